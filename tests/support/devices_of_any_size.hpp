#pragma once

#include "support/devices.hpp"

#include <algorithm>

namespace braidzone::test {

/// A Pipeline of any size: the braid ratio by the fit t = 0.160 + 0.957 mm / D through the paper's
/// Table 1, coefficients on the line between those of 4 and 5 mm and constant beyond.
inline FlowDiverter pipeline(double diameter, double length = 20e-3)
{
    FlowDiverter device = pipeline_4x20();
    device.nominal_diameter = diameter;
    device.nominal_length = length;
    device.braid_ratio = 0.160 + 0.957e-3 / diameter;
    const double between = std::clamp((diameter - 4e-3) / 1e-3, 0.0, 1.0);
    device.surface_coefficient = 0.6 - 0.2 * between;
    device.radial_coefficient = 0.1 - 0.02 * between;
    device.reference_node_area *= diameter / 4e-3;
    return device;
}

}  // namespace braidzone::test
