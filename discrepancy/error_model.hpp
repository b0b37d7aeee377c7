#pragma once

#include "discrepancy/noise_floor.hpp"
#include "discrepancy/observations.hpp"

#include <Eigen/Core>

namespace braidzone {

/// Covariance of the residuals where no effect is missing, in its parts, each row in its own unit:
/// [m^2] of patches and lengths.
///
///     C = W + B + o^2 1 1' + hub_sd^2 h h' + G Lambda G'        patches
///     W = diag(white_scale sd^2 sum w^2)        scatter of the points in their weighted mean
///     B = background_sd^2 exp(-distance / background_length)
///     h                                         of a shift of the hubs (`hub_slopes.hpp`)
///     G = [n, (x - x0) x n]                     of a small motion of the scan
///
/// The registration is marginalised: a misplacement of the scan as large as its prior Lambda
/// explains costs nothing, and none is subtracted beforehand (what is not linear in it:
/// `registered_residuals.hpp`). The lengths have a block of their
/// own: their own variance, the landing's, common to both ends, and the length's. So have densities
/// and force (`channel_errors.hpp`).
struct ErrorModel {
    Eigen::VectorXd white;            ///< W, and the own variances of what follows the patches
    Eigen::MatrixXd background;       ///< B, offset, hubs; of the lengths, landing and length
    Eigen::MatrixXd motion;           ///< G; 0 but for patches; columns: shift, rotation
    Eigen::VectorXd motion_variance;  ///< diagonal of Lambda
    Vec3 middle = Vec3::Zero();       ///< x0: of the patches' centres [m]
    Eigen::Index num_patches = 0;

    Eigen::MatrixXd without_registration() const;  ///< C without its last term
    Eigen::MatrixXd covariance() const;            ///< C
};

/// Distances between the patches' centres, in space [m].
Eigen::MatrixXd patch_distances(const DiscrepancyField& field);

ErrorModel make_error_model(const Observations& observations, const NoiseFloor& floor);

}  // namespace braidzone
