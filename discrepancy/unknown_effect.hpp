#pragma once

#include "discrepancy/error_model.hpp"

#include <Eigen/Core>

#include <vector>

namespace braidzone {

/// An effect of which only the size and extent are known: a Gaussian process over the device,
///
///     K = a^2 exp(-distance^2 / (2 l^2)),   a in 0.04 to 0.32 mm,   l in 1 to 4 mm,
///
/// on the patches, nothing on the scalars. The rival that keeps a named effect from being chosen
/// only because it is the best of a bad lot.
class UnknownEffect {
public:
    UnknownEffect(const DiscrepancyField& field, const Whitening& whitening,
                  Eigen::Index num_residuals);

    /// Log Bayes factor against the residuals being noise alone, the evidence averaged over the
    /// amplitudes and lengths. Exact, by the eigenvalues d of L^-1 K L^-T / a^2 with u the whitened
    /// residuals along its eigenvectors:
    ///
    ///     ln B = sum of -1/2 ln(1 + a^2 d) + 1/2 u^2 a^2 d / (1 + a^2 d)
    double log_evidence(const Eigen::VectorXd& whitened) const;

    /// The mean of the process given the residuals, at the amplitude and length with the greatest
    /// evidence: the unexplained gap of each patch [m].
    Eigen::VectorXd mean_field(const Eigen::VectorXd& whitened) const;

private:
    struct Scale {
        Eigen::MatrixXd kernel;  ///< at unit amplitude, rows and columns of all residuals
        Eigen::MatrixXd vectors;
        Eigen::VectorXd eigenvalues;
    };
    static double log_evidence(const Scale& scale, double amplitude, const Eigen::VectorXd& along);

    std::vector<Scale> scales_;
    const Whitening whitening_;
    Eigen::Index num_patches_ = 0;
};

}  // namespace braidzone
