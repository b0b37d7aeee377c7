#include "discrepancy/implementation_error.hpp"

#include "discrepancy/effect_roughness.hpp"

namespace braidzone {

Eigen::MatrixXd with_implementation_error(const DiagnosisProblem& problem,
                                          const std::vector<ActiveEffect>& effects,
                                          const Eigen::VectorXd& change, double ratio)
{
    const Eigen::Index n = problem.distances.rows();
    Eigen::MatrixXd covariance = problem.covariance;
    const Eigen::VectorXd size = ratio * change.head(n).cwiseAbs();
    covariance.topLeftCorner(n, n) +=
        (size * size.transpose())
            .cwiseProduct((-problem.distances.array() / problem.correlation_length).exp().matrix());
    if (problem.shape_correlation.size() > 0) {
        const Eigen::Index count = change.size() - n;
        const Eigen::VectorXd of_numbers = ratio * change.tail(count).cwiseAbs();
        covariance.bottomRightCorner(count, count) +=
            (of_numbers * of_numbers.transpose()).cwiseProduct(problem.shape_correlation);
    }
    covariance.diagonal() += roughness_variance(problem, effects);
    return covariance;
}

}  // namespace braidzone
