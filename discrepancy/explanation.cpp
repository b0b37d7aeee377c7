#include "discrepancy/explanation.hpp"

#include "discrepancy/implementation_error.hpp"
#include "discrepancy/laplace_evidence.hpp"
#include "discrepancy/shape_error.hpp"
#include "discrepancy/unknown_effect.hpp"
#include "discrepancy/unknown_scalars.hpp"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <mutex>
#include <utility>

namespace braidzone {
namespace {

/// Of an effect's shape, over its size, where it is weighed: half of what a further effect must
/// stand against. With as much as that, a waist passed for a pull.
constexpr double shape_error = 0.1;

std::vector<EffectFit> fit_singles(const DiagnosisProblem& problem, const Whitening& whitening,
                                   const Eigen::VectorXd& base, const ExplainOptions& options)
{
    std::vector<EffectFit> fits(problem.candidates.size());
    std::mutex one_call;
    std::size_t done = 0;
    tbb::parallel_for(std::size_t{0}, fits.size(), [&](std::size_t i) {
        fits[i] = fit_effect(problem, whitening, base, i, options.search.fit);
        const std::scoped_lock lock(one_call);
        ++done;
        if (options.on_progress)
            options.on_progress(fmt::format("fitting effects: {} of {} done", done, fits.size()));
    });
    return fits;
}

/// Makes the log evidence of each fit that of its effects at once, their shapes right or, as
/// probably, off by a share. Sets become comparable by it: what `find_sets` adds up depends on the
/// order in which it found a set's effects.
void doubt_shapes(const DiagnosisProblem& problem, const Whitening& whitening,
                  const Eigen::VectorXd& base, std::vector<EffectFit>& fits)
{
    tbb::parallel_for(std::size_t{0}, fits.size(), [&](std::size_t i) {
        EffectFit& fit = fits[i];
        if (!fit.failure.empty()) return;
        fit.log_evidence =
            log_of_mean({fit.log_evidence_together,
                         evidence_with_shape_error(problem, whitening, base, fit, shape_error)});
    });
}

/// True if something may be missing: otherwise there is no need to look for several effects.
bool may_miss_something(const Explanation& explanation, const VerdictOptions& bars)
{
    return explanation.log_evidence_unknown >= bars.unknown_bar ||
           explanation.log_evidence_scalars >= bars.unknown_bar ||
           std::any_of(explanation.fits.begin(), explanation.fits.end(),
                       [&](const EffectFit& fit) { return fit.log_evidence >= bars.effect_bar; });
}

Whitening whitening_with(const DiagnosisProblem& problem, const Explanation& explanation,
                         const std::vector<ActiveEffect>& effects, const Eigen::VectorXd& residuals,
                         const ExplainOptions& options)
{
    return Whitening(with_implementation_error(problem, effects,
                                               explanation.base_residuals - residuals,
                                               options.search.implementation_error));
}

std::vector<NamedEvidence> weigh(const DiagnosisProblem& problem, const Explanation& explanation,
                                 const ExplainOptions& options)
{
    std::vector<NamedEvidence> all(explanation.fits.size());
    // Each further effect is one of those that are left.
    const double others =
        std::log(std::max(1.0, static_cast<double>(explanation.num_singles) - 1.0));
    tbb::parallel_for(std::size_t{0}, all.size(), [&](std::size_t i) {
        const EffectFit& fit = explanation.fits[i];
        if (!fit.failure.empty()) return;
        const Whitening whitening =
            whitening_with(problem, explanation, active_effects(fit), fit.residuals, options);
        NamedEvidence& evidence = all[i];
        evidence.fit = i;
        for (const FittedEffect& effect : fit.effects)
            evidence.effects.push_back(effect.name);
        evidence.log_evidence = fit.log_evidence;
        evidence.log_prior = -others * static_cast<double>(fit.effects.size() - 1);
        if (options.doubts_shapes) evidence.unknown_price = options.search.least_gain + others;
        evidence.log_evidence_unknown =
            UnknownEffect(problem, whitening).log_evidence(whitening(fit.residuals));
        evidence.log_evidence_scalars = unknown_scalars_evidence(problem, fit.residuals);
    });
    std::erase_if(all, [](const NamedEvidence& one) { return one.effects.empty(); });
    return all;
}

}  // namespace

const Eigen::VectorXd& Explanation::residuals_after() const
{
    return best ? fits[*best].residuals : base_residuals;
}

Explanation explain(const DiagnosisProblem& problem, const ExplainOptions& options)
{
    Explanation explanation{.base_residuals = problem.residuals({})};
    const Eigen::VectorXd& base = explanation.base_residuals;
    const Whitening whitening(problem.covariance);
    const Eigen::VectorXd whitened = whitening(base);
    explanation.chi_square = whitened.squaredNorm();
    explanation.log_evidence_unknown = UnknownEffect(problem, whitening).log_evidence(whitened);
    explanation.log_evidence_scalars = unknown_scalars_evidence(problem, base);

    explanation.fits = fit_singles(problem, whitening, base, options);
    explanation.num_singles = explanation.fits.size();
    if (options.doubts_shapes) doubt_shapes(problem, whitening, base, explanation.fits);
    const VerdictOptions bars = for_choice_among(explanation.num_singles, options.verdict);
    for (std::size_t i = 0; i < explanation.num_singles; ++i) {
        explanation.limits.push_back(detection_limit(
            explanation.fits[i], base, problem.candidates[i], whitening, bars.effect_bar));
    }
    if (may_miss_something(explanation, bars)) {
        if (options.on_progress) options.on_progress("looking for several effects");
        std::vector<EffectFit> sets = find_sets(problem, base, explanation.fits, options.search);
        if (options.doubts_shapes) doubt_shapes(problem, whitening, base, sets);
        std::move(sets.begin(), sets.end(), std::back_inserter(explanation.fits));
    }
    explanation.num_runs = 1;
    for (const EffectFit& fit : explanation.fits)
        explanation.num_runs += fit.num_runs;

    explanation.named = weigh(problem, explanation, options);
    explanation.verdict = decide(explanation.named, explanation.log_evidence_unknown,
                                 explanation.log_evidence_scalars, bars);
    if (!explanation.verdict.answers.empty())
        explanation.best = explanation.verdict.answers.front().fit;
    const Eigen::VectorXd& after = explanation.residuals_after();
    const Whitening last =
        whitening_with(problem, explanation,
                       explanation.best ? active_effects(explanation.fits[*explanation.best])
                                        : std::vector<ActiveEffect>{},
                       after, options);
    explanation.unexplained = UnknownEffect(problem, last).mean_field(last(after));
    return explanation;
}

}  // namespace braidzone
