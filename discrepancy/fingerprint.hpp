#pragma once

#include <Eigen/Core>

namespace braidzone {

/// What an effect's fingerprint, taken as linear in the effect's size, does for the data.
struct FingerprintGain {
    double size = 0.0;  ///< at which it explains most, over that at which it was simulated
    double gain = 0.0;  ///< what it takes off half the sum of squares there
};

/// The size c of whitened residuals' change F that leaves the least of z:
///
///     c = F' z / F' F, between 0 and 2;   gain = c F' z - 1/2 c^2 F' F
///
/// Twice the simulated size at most: further off an effect is not linear.
/// @param fingerprint  F: whitened residuals of the case as it is, less those with the effect
/// @param z            whitened residuals to be explained
FingerprintGain fingerprint_gain(const Eigen::VectorXd& fingerprint, const Eigen::VectorXd& z);

}  // namespace braidzone
