#pragma once

#include <Eigen/Cholesky>
#include <Eigen/Core>

namespace braidzone {

/// Residuals in units of their error: z = L^-1 r with L L' = C.
class Whitening {
public:
    /// @throws InputError if the covariance is not positive definite
    explicit Whitening(const Eigen::MatrixXd& covariance);
    Eigen::VectorXd operator()(const Eigen::VectorXd& residuals) const;
    Eigen::MatrixXd of_columns(const Eigen::MatrixXd& columns) const;
    double log_determinant() const;  ///< of C

private:
    Eigen::LLT<Eigen::MatrixXd> factor_;
};

}  // namespace braidzone
