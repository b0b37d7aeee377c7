#include "deploy/flow_diverter.hpp"

#include "core/error.hpp"
#include "core/quantity.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

namespace braidzone {
namespace {

bool is_positive(double value)
{
    return value > 0.0 && std::isfinite(value);
}

/// Perpendicular distance of neighbouring wires of one family in the force-free device [m]:
/// wires / 2 helices share the circumference, at the angle whose tangent is the braid ratio.
double wire_spacing(const FlowDiverter& device)
{
    const double around = std::numbers::pi * device.nominal_diameter / (device.num_wires / 2);
    return around * device.braid_ratio / std::hypot(1.0, device.braid_ratio);
}

}  // namespace

std::optional<InvalidValue> find_invalid(const FlowDiverter& device)
{
    if (device.num_wires < 8 || device.num_wires % 2 != 0) {
        return InvalidValue{
            "num_wires", fmt::format("= {} is not an even number of 8 or more", device.num_wires)};
    }
    struct Positive {
        const char* key;
        double value;
        Dimension dimension;
    };
    for (const Positive& check :
         {Positive{"wire_diameter", device.wire_diameter, Dimension::length},
          Positive{"diameter", device.nominal_diameter, Dimension::length},
          Positive{"length", device.nominal_length, Dimension::length},
          Positive{"catheter_diameter", device.catheter_diameter, Dimension::length},
          Positive{"surface_coefficient", device.surface_coefficient, Dimension::stiffness},
          Positive{"radial_coefficient", device.radial_coefficient, Dimension::stiffness},
          Positive{"reference_node_area", device.reference_node_area, Dimension::area}}) {
        if (is_positive(check.value)) continue;
        return InvalidValue{check.key, fmt::format("= {:.6g} {} is not positive", check.value,
                                                   si_unit(check.dimension))};
    }
    if (!is_positive(device.braid_ratio)) {
        return InvalidValue{"braid_ratio",
                            fmt::format("= {:.6g} is not positive", device.braid_ratio)};
    }
    if (!is_positive(device.force_scale)) {
        return InvalidValue{"force_scale",
                            fmt::format("= {:.6g} is not positive", device.force_scale)};
    }
    if (!(device.wire_diameter <= 0.1 * device.nominal_diameter)) {
        return InvalidValue{"wire_diameter",
                            fmt::format("= {:.6g} um exceeds device.diameter / 10 = {:.6g} um",
                                        1e6 * device.wire_diameter, 1e5 * device.nominal_diameter)};
    }
    if (!(device.wire_diameter < wire_spacing(device))) {
        return InvalidValue{
            "wire_diameter",
            fmt::format("= {:.6g} um leaves no pores: neighbours of {} wires at braid_ratio {:.6g} "
                        "are {:.6g} um apart",
                        1e6 * device.wire_diameter, device.num_wires, device.braid_ratio,
                        1e6 * wire_spacing(device))};
    }
    if (!(device.catheter_diameter < device.nominal_diameter)) {
        return InvalidValue{
            "catheter_diameter",
            fmt::format("= {:.6g} mm is not narrower than device.diameter = {:.6g} mm",
                        1e3 * device.catheter_diameter, 1e3 * device.nominal_diameter)};
    }
    return std::nullopt;
}

void validate(const FlowDiverter& device)
{
    if (const auto invalid = find_invalid(device)) {
        throw ConfigError(fmt::format("device.{} {}", invalid->key, invalid->finding));
    }
}

}  // namespace braidzone
