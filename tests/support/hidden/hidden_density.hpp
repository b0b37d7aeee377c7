#pragma once

#include "deploy/flow_diverter.hpp"
#include "discrepancy/density_map.hpp"
#include "support/hidden/hidden_device.hpp"

#include <random>

namespace braidzone::hidden {

/// How a map of a hidden device's pores is taken.
struct DensityPicture {
    int rows = 8, columns = 8;  ///< squares along and around, 1.5 mm from the ends
    double window = 1.5e-3;     ///< side of a square [m]
    double relative_sd = 0.15;  ///< of the pores counted in one square, independent
    double scale_sd = 0.04;     ///< relative, of all squares together: the picture's scale
    double unseen_share = 0.2;  ///< of the squares: wires over wires
};

/// Pores per area in squares all over a device, from the areas of its sheet's cells:
///
///     pores per area = (wires / 2)^2 / (2 pi^2 R0^2 t) * force-free area / area
///
/// with the noise of the count and of the picture's scale; places lie on the device, in the frame
/// of the believed vessel.
DensityMap counted_pores(const HiddenDevice& device, const FlowDiverter& braid,
                         const DensityPicture& picture, std::mt19937& random);

/// Radial force on the wall between two arc lengths of the believed axis [N].
double wall_force(const HiddenDevice& device, double from, double to);

}  // namespace braidzone::hidden
