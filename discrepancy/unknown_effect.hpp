#pragma once

#include "discrepancy/diagnosis_problem.hpp"
#include "discrepancy/whitening.hpp"

#include <Eigen/Core>

#include <vector>

namespace braidzone {

/// An effect of which only the size and extent are known: a Gaussian process over the field,
///
///     K = a^2 exp(-distance^2 / (2 l^2)),
///
/// a out of `unknown_amplitudes` and l out of `unknown_lengths`, nothing on the single numbers. The
/// rival that keeps a named effect from being chosen only because it is the best of a bad lot.
class UnknownEffect {
public:
    /// @param whitening  by a covariance of all the problem's residuals, not always its own
    UnknownEffect(const DiagnosisProblem& problem, const Whitening& whitening);

    /// Log Bayes factor against the residuals being noise alone, the evidence averaged over the
    /// amplitudes and lengths. Exact, by the eigenvalues d of L^-1 K L^-T / a^2 with u the whitened
    /// residuals along its eigenvectors:
    ///
    ///     ln B = sum of -1/2 ln(1 + a^2 d) + 1/2 u^2 a^2 d / (1 + a^2 d)
    double log_evidence(const Eigen::VectorXd& whitened) const;

    /// The mean of the process given the residuals, at the amplitude and length with the greatest
    /// evidence: what of the field is unexplained.
    Eigen::VectorXd mean_field(const Eigen::VectorXd& whitened) const;

private:
    struct Scale {
        Eigen::MatrixXd kernel;  ///< at unit amplitude, rows and columns of all residuals
        Eigen::MatrixXd vectors;
        Eigen::VectorXd eigenvalues;
    };
    static double log_evidence(const Scale& scale, double amplitude, const Eigen::VectorXd& along);

    std::vector<Scale> scales_;
    std::vector<double> amplitudes_;
    const Whitening whitening_;
    Eigen::Index field_size_ = 0;
};

}  // namespace braidzone
