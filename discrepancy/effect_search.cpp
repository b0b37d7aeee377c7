#include "discrepancy/effect_search.hpp"

#include "discrepancy/fingerprint.hpp"
#include "discrepancy/implementation_error.hpp"
#include "discrepancy/laplace_evidence.hpp"
#include "discrepancy/linear_refit.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

namespace braidzone {
namespace {

using CandidateSet = std::set<std::size_t>;

/// A fingerprint promises less than a fit may gain, as it is taken as linear; an addition that
/// would not make the best set even if it gained this many times as much is not tried.
constexpr double generosity = 1.5;

CandidateSet candidates_of(const EffectFit& fit)
{
    CandidateSet all;
    for (const FittedEffect& effect : fit.effects)
        all.insert(effect.candidate);
    return all;
}

/// A set with one candidate more, where to begin, and what its fingerprint promises.
struct Addition {
    std::vector<ActiveEffect> start;
    double promise = 0.0;
};

/// The most promising simulation of a candidate alone for the residuals that a set leaves.
Addition best_addition(const EffectFit& set, const EffectFit& single, const Eigen::VectorXd& base,
                       const Whitening& whitening)
{
    const Eigen::VectorXd z = whitening(set.residuals);
    Addition best{.start = active_effects(set)};
    std::vector<double> values = single.effects.front().values;
    for (const Trial& trial : single.trials) {
        const double gain = fingerprint_gain(whitening(base - trial.residuals), z).gain;
        if (gain <= best.promise) continue;
        best.promise = gain;
        values = trial.values;
    }
    // Where fits begin at no effect, its derivatives there are the fingerprint.
    const LinearRefit linear =
        linear_refit(z, whitening.of_columns(single.derivatives),
                     Eigen::VectorXd::Zero(single.x.size()), parameters_of(single));
    best.promise = std::max(best.promise, 0.5 * (z.squaredNorm() - linear.whitened.squaredNorm() -
                                                 linear.x.squaredNorm()));
    best.start.push_back({single.effects.front().candidate, values});
    return best;
}

std::vector<Addition> promising_additions(const DiagnosisProblem& problem, const EffectFit& set,
                                          const std::vector<EffectFit>& singles,
                                          const Eigen::VectorXd& base, const SearchOptions& options)
{
    const Whitening whitening(with_implementation_error(
        problem, active_effects(set), base - set.residuals, options.implementation_error));
    const CandidateSet present = candidates_of(set);
    std::vector<Addition> additions;
    for (const EffectFit& single : singles) {
        if (!single.failure.empty() || present.count(single.effects.front().candidate) > 0)
            continue;
        Addition addition = best_addition(set, single, base, whitening);
        if (addition.promise > options.least_gain) additions.push_back(std::move(addition));
    }
    std::stable_sort(additions.begin(), additions.end(),
                     [](const Addition& a, const Addition& b) { return a.promise > b.promise; });
    if (static_cast<int>(additions.size()) > options.most_additions)
        additions.resize(static_cast<std::size_t>(options.most_additions));
    return additions;
}

/// What a fit of more effects has gained over that of a set of them, allowing for a wrong shape of
/// the set's.
double gain_over(const DiagnosisProblem& problem, const EffectFit& set, const EffectFit& larger,
                 const Eigen::VectorXd& base, const SearchOptions& options)
{
    const Whitening whitening(with_implementation_error(
        problem, active_effects(set), base - set.residuals, options.implementation_error));
    const auto evidence = [&](const EffectFit& fit) {
        return linear_refit(whitening(fit.residuals), whitening.of_columns(fit.derivatives), fit.x,
                            parameters_of(fit))
            .log_evidence;
    };
    return evidence(larger) - evidence(set);
}

/// True if no part of the set explains as much, but for the least gain.
bool earns_its_place(const EffectFit& fit, const std::map<CandidateSet, EffectFit>& known,
                     double least_gain)
{
    const CandidateSet all = candidates_of(fit);
    return std::none_of(known.begin(), known.end(), [&](const auto& one) {
        const auto& [part, of_part] = one;
        return std::includes(all.begin(), all.end(), part.begin(), part.end()) &&
               fit.log_evidence < of_part.log_evidence + least_gain;
    });
}

/// True if an effect ended with the amplitude zero, where bounds end: that is the set without it,
/// and what its derivatives there promise lies beyond the bounds.
bool has_idle_effect(const EffectFit& fit)
{
    return std::any_of(fit.effects.begin(), fit.effects.end(),
                       [](const FittedEffect& effect) { return effect.values.front() == 0.0; });
}

/// The sets with the greatest evidence, no more than the beam is wide.
std::vector<EffectFit> widest(std::vector<EffectFit> sets, int width)
{
    std::stable_sort(sets.begin(), sets.end(), [](const EffectFit& a, const EffectFit& b) {
        return a.log_evidence > b.log_evidence;
    });
    if (static_cast<int>(sets.size()) > width) sets.resize(static_cast<std::size_t>(width));
    return sets;
}

/// One effect more for each set of the beam: those that are accepted.
std::vector<EffectFit> larger_sets(const DiagnosisProblem& problem, const Eigen::VectorXd& base,
                                   const std::vector<EffectFit>& singles,
                                   const std::vector<EffectFit>& beam,
                                   std::map<CandidateSet, EffectFit>& known,
                                   const SearchOptions& options)
{
    double best = 0.0;
    for (const auto& [part, fit] : known)
        best = std::max(best, fit.log_evidence);
    std::vector<std::pair<const EffectFit*, Addition>> tasks;
    for (const EffectFit& set : beam) {
        for (Addition& addition : promising_additions(problem, set, singles, base, options)) {
            if (set.log_evidence + generosity * addition.promise > best)
                tasks.emplace_back(&set, std::move(addition));
        }
    }
    const Whitening whitening(problem.covariance);
    FitOptions together = options.fit;
    together.max_iterations = options.most_joint_iterations;
    std::vector<EffectFit> fits(tasks.size());
    tbb::parallel_for(std::size_t{0}, tasks.size(), [&](std::size_t i) {
        fits[i] = fit_together(problem, whitening, base, tasks[i].second.start, together);
        fits[i].trials.clear();
        if (!fits[i].failure.empty()) return;
        fits[i].log_evidence = tasks[i].first->log_evidence +
                               gain_over(problem, *tasks[i].first, fits[i], base, options);
    });
    std::vector<EffectFit> accepted;
    for (EffectFit& fit : fits) {
        if (!fit.failure.empty() || has_idle_effect(fit) ||
            !earns_its_place(fit, known, options.least_gain))
            continue;
        const auto [place, is_new] = known.emplace(candidates_of(fit), fit);
        if (is_new) accepted.push_back(std::move(fit));
    }
    return accepted;
}

}  // namespace

std::vector<EffectFit> find_sets(const DiagnosisProblem& problem, const Eigen::VectorXd& base,
                                 const std::vector<EffectFit>& singles, const SearchOptions& given)
{
    SearchOptions options = given;
    options.least_gain += std::log(std::max(1.0, static_cast<double>(singles.size()) - 1.0));
    std::map<CandidateSet, EffectFit> known;
    std::vector<EffectFit> beam;
    for (const EffectFit& single : singles) {
        if (!single.failure.empty()) continue;
        known.emplace(candidates_of(single), single);
        if (single.log_evidence >= given.least_gain) beam.push_back(single);
    }
    std::vector<EffectFit> sets;
    for (int size = 2; size <= options.most_effects && !beam.empty(); ++size) {
        beam = larger_sets(problem, base, singles, widest(std::move(beam), options.width), known,
                           options);
        sets.insert(sets.end(), beam.begin(), beam.end());
    }
    return sets;
}

}  // namespace braidzone
