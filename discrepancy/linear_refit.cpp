#include "discrepancy/linear_refit.hpp"

#include "discrepancy/laplace_evidence.hpp"

#include <Eigen/Dense>

namespace braidzone {

namespace {

/// The change of the parameters that are not held. Of one that leaves no trace the least change is
/// taken.
Eigen::VectorXd best_change(const Eigen::VectorXd& whitened, const Eigen::MatrixXd& derivatives,
                            const Eigen::VectorXd& x, const Eigen::VectorXd& weights,
                            const std::vector<char>& is_held)
{
    const Eigen::Index n = x.size(), m = whitened.size();
    Eigen::MatrixXd rows(m + n, n);
    rows << derivatives, Eigen::MatrixXd(weights.asDiagonal());
    Eigen::VectorXd right(m + n);
    right << -whitened, -weights.cwiseProduct(x);
    for (Eigen::Index i = 0; i < n; ++i) {
        if (is_held[static_cast<std::size_t>(i)] != 0) rows.col(i).setZero();
    }
    return rows.completeOrthogonalDecomposition().solve(right);
}

}  // namespace

LinearRefit linear_refit(const Eigen::VectorXd& whitened, const Eigen::MatrixXd& derivatives,
                         const Eigen::VectorXd& x, const std::vector<EffectParameter>& parameters)
{
    const Eigen::Index n = x.size();
    Eigen::VectorXd lower(n), upper(n), weights(n);
    std::vector<bool> is_uniform;
    for (Eigen::Index i = 0; i < n; ++i) {
        const EffectParameter& p = parameters[static_cast<std::size_t>(i)];
        lower[i] = (p.lower - p.prior_mean) / p.prior_sd;
        upper[i] = (p.upper - p.prior_mean) / p.prior_sd;
        weights[i] = p.is_uniform ? 0.0 : 1.0;
        is_uniform.push_back(p.is_uniform);
    }
    LinearRefit refit{.x = x, .whitened = whitened};
    std::vector<char> is_held(static_cast<std::size_t>(n), 0);
    for (Eigen::Index round = 0; round <= n; ++round) {
        const Eigen::VectorXd wanted =
            refit.x + best_change(refit.whitened, derivatives, refit.x, weights, is_held);
        const Eigen::VectorXd allowed = wanted.cwiseMax(lower).cwiseMin(upper);
        refit.whitened += derivatives * (allowed - refit.x);
        refit.x = allowed;
        if (allowed == wanted) break;
        for (Eigen::Index i = 0; i < n; ++i) {
            if (allowed[i] != wanted[i]) is_held[static_cast<std::size_t>(i)] = 1;
        }
    }
    refit.log_evidence = log_bayes_factor(Eigen::VectorXd::Zero(whitened.size()), refit.whitened,
                                          derivatives, refit.x, is_uniform);
    return refit;
}

}  // namespace braidzone
