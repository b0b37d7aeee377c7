#include "discrepancy/linear_refit.hpp"

#include "discrepancy/laplace_evidence.hpp"

#include <Eigen/Dense>

namespace braidzone {

LinearRefit linear_refit(const Eigen::VectorXd& whitened, const Eigen::MatrixXd& derivatives,
                         const Eigen::VectorXd& x, const std::vector<bool>& is_uniform)
{
    const Eigen::Index n = x.size();
    // Of a parameter that leaves no trace the least change is taken.
    Eigen::MatrixXd rows = Eigen::MatrixXd::Zero(whitened.size() + n, n);
    Eigen::VectorXd right(whitened.size() + n);
    rows.topRows(whitened.size()) = derivatives;
    right.head(whitened.size()) = -whitened;
    for (Eigen::Index i = 0; i < n; ++i) {
        const bool has_prior = !is_uniform[static_cast<std::size_t>(i)];
        rows(whitened.size() + i, i) = has_prior ? 1.0 : 0.0;
        right[whitened.size() + i] = has_prior ? -x[i] : 0.0;
    }
    LinearRefit refit;
    const Eigen::VectorXd change =
        Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd>(rows).solve(right);
    refit.x = x + change;
    refit.whitened = whitened + derivatives * change;
    refit.log_evidence = log_bayes_factor(Eigen::VectorXd::Zero(whitened.size()), refit.whitened,
                                          derivatives, refit.x, is_uniform);
    return refit;
}

}  // namespace braidzone
