#pragma once

#include "deploy/flow_diverter.hpp"

#include <numbers>

namespace braidzone::test {

/// A Pipeline of 4 x 20 mm with the paper's values (Zavodszky et al. 2020, Tables 1 and 2) on the
/// paper's lattice of 24 nodes a ring and 36 gaps, forces unscaled.
inline FlowDiverter pipeline_4x20()
{
    FlowDiverter device;
    device.name = "pipeline-flex";
    device.num_wires = 48;
    device.wire_diameter = 30e-6;
    device.nominal_diameter = 4e-3;
    device.nominal_length = 20e-3;
    device.braid_ratio = 0.40;
    device.surface_coefficient = 0.6;
    device.radial_coefficient = 0.1;
    device.reference_node_area = 20e-3 / 36 * 2.0 * std::numbers::pi * 2e-3 / 24;
    return device;
}

/// The same of 5 x 20 mm.
inline FlowDiverter pipeline_5x20()
{
    FlowDiverter device = pipeline_4x20();
    device.nominal_diameter = 5e-3;
    device.braid_ratio = 0.35;
    device.surface_coefficient = 0.4;
    device.radial_coefficient = 0.08;
    device.reference_node_area = 20e-3 / 36 * 2.0 * std::numbers::pi * 2.5e-3 / 24;
    return device;
}

/// A Pipeline of the given size with forces from its wires: 48 of 200 GPa, and the ratio of the
/// paper's Table 1 for that diameter.
inline FlowDiverter wire_pipeline(double diameter, double braid_ratio, double wire_diameter = 30e-6)
{
    FlowDiverter device;
    device.name = "pipeline-flex";
    device.num_wires = 48;
    device.wire_diameter = wire_diameter;
    device.nominal_diameter = diameter;
    device.nominal_length = 20e-3;
    device.braid_ratio = braid_ratio;
    device.forces = ForceSource::wire_theory;
    device.youngs_modulus = 200e9;
    return device;
}

}  // namespace braidzone::test
