#include "porous/pressure_bench.hpp"

#include "core/error.hpp"
#include "deploy/braid_kinematics.hpp"
#include "porous/braid_stokes.hpp"
#include "porous/edge_gap.hpp"
#include "porous/range_check.hpp"

#include <fmt/format.h>

#include <numbers>
#include <variant>

namespace braidzone {

Rhombus bench_rhombus(const PressureBench& bench)
{
    const FlowDiverter& device = bench.device;
    const int num_nodes = device.num_wires / 2;
    const double around = 0.5 * std::numbers::pi * bench.diameter / num_nodes;
    const double nominal = 0.5 * std::numbers::pi * device.nominal_diameter / num_nodes;
    const double spacing =
        device.braid_ratio * nominal *
        length_ratio(device.braid_ratio, bench.diameter / device.nominal_diameter);
    const double along = spacing / (1.0 + bench.density_increase);
    return measure_rhombus({along, around, 0.0}, {along, -around, 0.0}, device.wire_diameter,
                           Vec3::UnitY());
}

SheetLoss bench_loss(const PressureBench& bench)
{
    const Rhombus rhombus = bench_rhombus(bench);
    if (!std::holds_alternative<ConstantLaw>(bench.law))
        require_pores(rhombus, law_name(bench.law).c_str());
    SheetLoss loss = sheet_loss(bench.law, rhombus, bench.fluid);
    if (bench.added_inertia != 0.0) {
        loss.quadratic +=
            bench.added_inertia * braid_stokes_quadratic(rhombus, bench.fluid.density);
    }
    if (!(loss.quadratic >= 0.0)) {
        throw InputError(fmt::format(
            "added_inertia = {:.6g} makes the quadratic loss negative, {:.6g} Pa s^2/m^2",
            bench.added_inertia, loss.quadratic));
    }
    const double layers = 1.0 + bench.second_layer;
    return {layers * loss.linear, layers * loss.quadratic};
}

double bench_pressure_drop(const PressureBench& bench, double velocity)
{
    const SheetLoss loss = bench_loss(bench);
    if (bench.gap_width == 0.0) return pressure_drop(loss, velocity);
    const double thickness = 2.0 * bench.device.wire_diameter;
    return parallel_pressure_drop(loss, slit_loss(bench.gap_width, thickness, bench.fluid),
                                  4.0 * bench.gap_width / bench.channel_diameter, velocity);
}

}  // namespace braidzone
