#include "cli/key_ranges.hpp"

#include "deploy/device_file.hpp"

#include <algorithm>

namespace braidzone {
namespace {

void append(KeyRanges& ranges, const KeyRanges& more)
{
    ranges.insert(ranges.end(), more.begin(), more.end());
}

/// From the smallest device that is made to an aortic one.
KeyRanges device_ranges()
{
    KeyRanges ranges = {{"device.diameter", "0.5 mm", "60 mm"},
                        {"device.length", "1 mm", "500 mm"}};
    for (const DeviceParameter& parameter : device_parameters())
        ranges.push_back({"device." + std::string(parameter.key), std::string(parameter.lowest),
                          std::string(parameter.highest)});
    return ranges;
}

/// Places along a centerline of 2 m at most, from the aorta's root to a foot.
KeyRanges placement_ranges()
{
    return {{"deployment.landing_distal", "-2 m", "2 m"},
            {"deployment.push_pull.from", "-2 m", "2 m"},
            {"deployment.push_pull.to", "-2 m", "2 m"},
            {"deployment.push_pull.spacing", "0.01", "10"},
            {"deployment.sliding", "0", "1"},
            {"deployment.twist.angle", "-3600 deg", "3600 deg"},
            {"deployment.twist.centre", "-2 m", "2 m"},
            {"deployment.twist.half_width", "0 mm", "2 m"},
            {"deployment.incomplete_opening.length", "0 mm", "2 m"},
            {"deployment.incomplete_opening.shrink", "-1", "1"},
            {"deployment.incomplete_opening.lean", "0", "1"},
            {"deployment.incomplete_opening.lean_angle", "-3600 deg", "3600 deg"}};
}

KeyRanges vessel_ranges()
{
    return {{"vessel.wall_offset", "-5 mm", "5 mm"},
            {"vessel.from", "0", "1000"},
            {"vessel.to", "0", "1000"},
            {"vessel.centerline_line", "-1", "1000000"},
            {"vessel.straightening.share", "-1", "1"},
            {"vessel.straightening.centre", "-2 m", "2 m"},
            {"vessel.straightening.half_width", "0 mm", "2 m"},
            {"vessel.straightening.kept_from", "-2 m", "2 m"},
            {"vessel.straightening.kept_to", "-2 m", "2 m"},
            {"vessel.openings.at", "0", "1000"}};
}

/// The wall: from softer than a vein to a rigid print. The physiological one is 1e8 Pa/m
/// (37 mmHg over 45 um).
KeyRanges motion_ranges()
{
    return {{"deployment.hub_freedom", "0", "1"},
            {"deployment.hub_shift", "0 mm", "10 mm"},
            {"deployment.friction", "0", "10"},
            {"deployment.wall_stiffness", "1e5 Pa/m", "1e14 Pa/m"},
            {"deployment.time_step_ratio", "0.001", "1"},
            {"deployment.damping", "1e-4 kg/s", "1e3 kg/s"},
            {"deployment.bending_ratio", "0", "1000"},
            {"deployment.release_interval", "1", "1000000"},
            {"deployment.residual_tolerance", "1e-20", "1"},
            {"deployment.max_settling_steps", "1", "1000000000"},
            {"deployment.num_frames", "0", "10000"},
            {"deployment.neck.from", "-2 m", "2 m"},
            {"deployment.neck.to", "-2 m", "2 m"}};
}

/// From gases to mercury and syrup.
KeyRanges fluid_ranges()
{
    return {{"fluid.density", "0.01 kg/m^3", "25000 kg/m^3"},
            {"fluid.viscosity", "1e-6 Pa s", "100 Pa s"},
            {"fluid.zero_shear_viscosity", "1e-6 Pa s", "100 Pa s"},
            {"fluid.infinite_shear_viscosity", "1e-6 Pa s", "100 Pa s"},
            {"fluid.relaxation_time", "1e-6 s", "1e4 s"},
            {"fluid.power_index", "0", "1"},
            {"fluid.yasuda_exponent", "0.01", "100"}};
}

/// Losses from a thousandth to a million times those of a flow diverter (490 Pa s/m, 330 kg/m^3).
KeyRanges porous_ranges()
{
    return {{"porous.tangential_ratio", "0.01", "10000"},
            {"porous.pressure_loss_linear", "0 Pa s/m", "1e9 Pa s/m"},
            {"porous.pressure_loss_quadratic", "0 kg/m^3", "1e9 kg/m^3"},
            {"porous.bench_density", "0.01 kg/m^3", "25000 kg/m^3"},
            {"porous.bench_viscosity", "1e-6 Pa s", "100 Pa s"},
            {"porous.fit_velocity", "1e-6 m/s", "100 m/s"}};
}

/// Cells and voxels from a sixth of a wire to the width of an aorta.
KeyRanges export_ranges()
{
    return {{"grid.spacing", "0.005 mm", "20 mm"},
            {"grid.kernel_half_width", "1", "16"},
            {"export.inlet_velocity", "1e-6 m/s", "100 m/s"},
            {"export.mean_flow_rate", "1e-6 ml/s", "1000 ml/s"},
            {"export.cycles", "1", "100"},
            {"export.max_courant", "0.001", "100"},
            {"export.outlet_pressures", "-1e6 Pa", "1e6 Pa"},
            {"export.outlet_shares", "0", "1"},
            {"export.coarse_cell", "0.005 mm", "20 mm"},
            {"export.surface_refinement", "0", "6"},
            {"export.device_refinement", "0", "6"},
            {"export.most_zones", "1", "4096"},
            {"export.peak_velocity", "1e-6 m/s", "100 m/s"},
            {"export.velocity_lu", "1e-6", "0.2"},
            {"export.wire_facets", "3", "64"},
            {"export.wire_pieces", "2", "64"},
            {"export.shell_thickness", "1 um", "10 mm"},
            {"export.distance_spacing", "0.005 mm", "20 mm"}};
}

KeyRanges measurement_ranges()
{
    return {{"measurement.voxel_size", "0 mm", "10 mm"},
            {"measurement.blur", "0 mm", "10 mm"},
            {"measurement.threshold", "0", "1"},
            {"measurement.blooming", "-5 mm", "5 mm"},
            {"measurement.rotation", "-360 deg", "360 deg"}};
}

/// The second device has the keys of [device] and those of its placement.
KeyRanges second_device_ranges()
{
    KeyRanges ranges = device_ranges();
    append(ranges, placement_ranges());
    for (KeyRange& range : ranges)
        range.key = "second_device" + range.key.substr(range.key.find('.'));
    return ranges;
}

}  // namespace

KeyRanges case_key_ranges()
{
    KeyRanges ranges = vessel_ranges();
    for (const KeyRanges& section :
         {device_ranges(), placement_ranges(), motion_ranges(), fluid_ranges(), porous_ranges(),
          export_ranges(), measurement_ranges(), second_device_ranges()})
        append(ranges, section);
    return ranges;
}

KeyRanges press_key_ranges()
{
    KeyRanges ranges = device_ranges();
    append(ranges, {{"press.notch_width", "0.1 mm", "1 m"},
                    {"press.notch_angle", "1 deg", "180 deg"},
                    {"press.edge_radius", "0 mm", "1 m"},
                    {"press.head_radius", "0.01 mm", "1 m"},
                    {"press.zero_offset", "-100 mm", "100 mm"},
                    {"press.stiffening", "-100", "100"},
                    {"press.stroke", "0.001 mm", "100 mm"},
                    {"press.step", "0.001 mm", "100 mm"},
                    {"press.load_step", "0.0001 mm", "100 mm"},
                    {"press.nodes_per_ring", "0", "100"},
                    {"press.bending_ratio", "0", "1000"},
                    {"press.surface_factor", "1e-4", "1e4"},
                    {"press.radial_factor", "1e-4", "1e4"},
                    {"press.friction", "0", "10"},
                    {"press.residual_tolerance", "1e-20", "1"}});
    return ranges;
}

KeyRanges pressure_key_ranges()
{
    KeyRanges ranges = device_ranges();
    append(ranges, fluid_ranges());
    append(ranges, porous_ranges());
    append(ranges, {{"bench.diameter", "0.1 mm", "100 mm"},
                    {"bench.metal_coverage", "0.001", "1"},
                    {"bench.density_increase", "-1", "100"},
                    {"bench.channel_diameter", "0.1 mm", "1 m"},
                    {"bench.gap", "0 mm", "100 mm"},
                    {"bench.second_layer", "0", "100"},
                    {"bench.added_inertia", "-1e6", "1e6"}});
    return ranges;
}

}  // namespace braidzone
