#include "discrepancy/held_out.hpp"

#include "discrepancy/linear_refit.hpp"

#include <Eigen/Dense>

#include <algorithm>

namespace braidzone {
namespace {

/// A block and what is learned from for it.
struct Fold {
    std::vector<int> block, rest;
    Whitening whitening;                     ///< of the rest
    Eigen::MatrixXd taken;                   ///< N_(block, rest) C_(rest, rest)^-1
    Eigen::MatrixXd mean;                    ///< C_(block, rest) C_(rest, rest)^-1
    Eigen::LLT<Eigen::MatrixXd> predictive;  ///< covariance of the block given the rest
};

Fold make_fold(const DiagnosisProblem& problem, const std::vector<int>& block, double buffer)
{
    std::vector<int> rest;
    for (int i = 0; i < static_cast<int>(problem.covariance.rows()); ++i) {
        const bool is_near =
            i < problem.distances.rows() && std::any_of(block.begin(), block.end(), [&](int held) {
                return problem.distances(i, held) <= buffer;
            });
        if (!is_near) rest.push_back(i);
    }
    const Eigen::MatrixXd& c = problem.covariance;
    const Eigen::MatrixXd known = c(rest, rest);
    const Eigen::LLT<Eigen::MatrixXd> factor(known);
    Fold fold{block, rest, Whitening(known), {}, {}, {}};
    const Eigen::MatrixXd shared = c(block, rest);
    fold.mean = factor.solve(shared.transpose()).transpose();
    fold.predictive.compute(c(block, block) - fold.mean * shared.transpose());
    fold.taken = problem.nuisance.size() == 0
                     ? Eigen::MatrixXd::Zero(shared.rows(), shared.cols())
                     : Eigen::MatrixXd(factor.solve(problem.nuisance(rest, block)).transpose());
    return fold;
}

/// Residuals of a fit, refitted to those that are learned from.
struct Refitted {
    Eigen::VectorXd residuals;
    double log_evidence = 0.0;
};

Refitted refitted(const EffectFit& fit, const Fold& fold)
{
    const Eigen::VectorXd known = fit.residuals(fold.rest);
    const Eigen::MatrixXd slope = fit.derivatives(fold.rest, Eigen::all);
    const LinearRefit refit = linear_refit(fold.whitening(known), fold.whitening.of_columns(slope),
                                           fit.x, parameters_of(fit));
    return {fit.residuals + fit.derivatives * (refit.x - fit.x), refit.log_evidence};
}

Eigen::VectorXd gap_in(const Fold& fold, const Eigen::VectorXd& residuals)
{
    return residuals(fold.block) - fold.taken * residuals(fold.rest);
}

double log_score(const Fold& fold, const Eigen::VectorXd& residuals)
{
    const Eigen::VectorXd off = residuals(fold.block) - fold.mean * residuals(fold.rest);
    return -0.5 * fold.predictive.matrixL().solve(off).squaredNorm();
}

}  // namespace

bool HeldOutGap::confirms() const
{
    return log_score_gain > 0.0 && 4 * num_same >= 3 * static_cast<int>(choices.size());
}

HeldOutGap held_out_gap(const DiagnosisProblem& problem, const Explanation& explanation,
                        const std::vector<std::vector<int>>& folds, double buffer,
                        const ExplainOptions& options)
{
    const Eigen::VectorXd& base = explanation.base_residuals;
    const VerdictOptions bars = for_choice_among(explanation.num_singles, options.verdict);
    HeldOutGap gap{.before = Eigen::VectorXd::Zero(problem.distances.rows())};
    gap.after = gap.before;
    for (const EffectFit& fit : explanation.fits)
        gap.of_fits.push_back(fit.failure.empty() ? gap.before : Eigen::VectorXd());
    const std::string chosen_by_all =
        explanation.best ? name_of(explanation.fits[*explanation.best]) : "none";
    for (const std::vector<int>& block : folds) {
        const Fold fold = make_fold(problem, block, buffer);
        const double none = -0.5 * fold.whitening(base(fold.rest)).squaredNorm();
        double best = none + bars.effect_bar;
        Eigen::VectorXd after = base;
        gap.choices.emplace_back("none");
        for (std::size_t i = 0; i < explanation.fits.size(); ++i) {
            const EffectFit& fit = explanation.fits[i];
            if (!fit.failure.empty()) continue;
            const Refitted here = refitted(fit, fold);
            gap.of_fits[i](block) = gap_in(fold, here.residuals);
            if (here.log_evidence <= best) continue;
            best = here.log_evidence;
            after = here.residuals;
            gap.choices.back() = name_of(fit);
        }
        gap.num_same += gap.choices.back() == chosen_by_all ? 1 : 0;
        gap.log_score_gain += log_score(fold, after) - log_score(fold, base);
        gap.before(block) = gap_in(fold, base);
        gap.after(block) = gap_in(fold, after);
    }
    return gap;
}

Eigen::MatrixXd held_out_rows(const DiagnosisProblem& problem,
                              const std::vector<std::vector<int>>& folds, double buffer)
{
    Eigen::MatrixXd rows =
        Eigen::MatrixXd::Zero(problem.distances.rows(), problem.covariance.cols());
    for (const std::vector<int>& block : folds) {
        const Fold fold = make_fold(problem, block, buffer);
        rows(block, fold.rest) = -fold.taken;
        for (const int i : block)
            rows(i, i) = 1.0;
    }
    return rows;
}

}  // namespace braidzone
