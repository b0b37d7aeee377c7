#pragma once

#include "deploy/force_curve.hpp"

namespace braidzone {

/// How a press bench shows what happens on it.
struct PressReading {
    /// Displacement that the bench shows when its head touches the device [m]: positive if the
    /// head was set to zero above the device, negative if it pressed the device already.
    double zero_offset = 0.0;
    /// k of the factor 1 + k x / D on forces [-]: the device stiffens as it is pressed, beyond what
    /// its shape makes it do.
    double stiffening = 0.0;
};

/// The point of a force curve that the bench shows.
///
///     displacement = x + zero_offset,   force = F (1 + k x / D)
///
/// @param actual            x since the head touched the device [m], F [N]
/// @param nominal_diameter  D of the device [m]; > 0
ForcePoint as_read(const ForcePoint& actual, const PressReading& reading, double nominal_diameter);

}  // namespace braidzone
