#include "discrepancy/whitening.hpp"

#include "core/error.hpp"

namespace braidzone {

Whitening::Whitening(const Eigen::MatrixXd& covariance) : factor_(covariance)
{
    if (factor_.info() != Eigen::Success)
        throw InputError("the covariance of the residuals is not positive definite");
}

Eigen::VectorXd Whitening::operator()(const Eigen::VectorXd& residuals) const
{
    return factor_.matrixL().solve(residuals);
}

Eigen::MatrixXd Whitening::of_columns(const Eigen::MatrixXd& columns) const
{
    return factor_.matrixL().solve(columns);
}

double Whitening::log_determinant() const
{
    return 2.0 * factor_.matrixLLT().diagonal().array().log().sum();
}

}  // namespace braidzone
