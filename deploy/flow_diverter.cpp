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

struct Positive {
    const char* key;
    double value;
    Dimension dimension;
};

std::optional<InvalidValue> find_not_positive(const Positive& check)
{
    if (is_positive(check.value)) return std::nullopt;
    return InvalidValue{check.key, fmt::format("= {:.6g} {} is not positive", check.value,
                                               si_unit(check.dimension))};
}

std::optional<InvalidValue> find_invalid_springs(const FlowDiverter& device)
{
    for (const Positive& check :
         {Positive{"surface_coefficient", device.surface_coefficient, Dimension::stiffness},
          Positive{"radial_coefficient", device.radial_coefficient, Dimension::stiffness},
          Positive{"reference_node_area", device.reference_node_area, Dimension::area}}) {
        if (auto invalid = find_not_positive(check)) return invalid;
    }
    if (!is_positive(device.force_scale)) {
        return InvalidValue{"force_scale",
                            fmt::format("= {:.6g} is not positive", device.force_scale)};
    }
    return std::nullopt;
}

std::optional<InvalidValue> find_invalid_wires(const FlowDiverter& device)
{
    if (auto invalid =
            find_not_positive({"youngs_modulus", device.youngs_modulus, Dimension::pressure})) {
        return invalid;
    }
    if (!(device.poisson_ratio >= 0.0 && device.poisson_ratio <= 0.5)) {
        return InvalidValue{"poisson_ratio", fmt::format("= {:.6g} is out of range; allowed are 0 "
                                                         "to 0.5",
                                                         device.poisson_ratio)};
    }
    return std::nullopt;
}

/// A flare opens the braid by less than lets the wires lie along the circumference, where the
/// length would become 0; a cone closes it by less than to the catheter.
std::optional<InvalidValue> find_invalid_flare(const FlowDiverter& device)
{
    const double radius = device.nominal_radius();
    const double widest = radius * std::hypot(1.0, device.braid_ratio) - radius;
    const double narrowest = 0.5 * device.catheter_diameter - radius;
    struct Flare {
        const char* key;
        double value;
    };
    for (const Flare& flare : {Flare{"distal_flare", device.distal_flare},
                               Flare{"proximal_flare", device.proximal_flare}}) {
        if (flare.value > narrowest && flare.value < widest) continue;
        return InvalidValue{
            flare.key, fmt::format("= {:.6g} mm is out of range; a braid of radius {:.6g} mm and "
                                   "ratio {:.6g} allows {:.6g} to {:.6g} mm",
                                   1e3 * flare.value, 1e3 * radius, device.braid_ratio,
                                   1e3 * narrowest, 1e3 * widest)};
    }
    return std::nullopt;
}

}  // namespace

std::optional<InvalidValue> find_invalid(const FlowDiverter& device)
{
    if (device.num_wires < 8 || device.num_wires % 2 != 0) {
        return InvalidValue{
            "num_wires", fmt::format("= {} is not an even number of 8 or more", device.num_wires)};
    }
    for (const Positive& check :
         {Positive{"wire_diameter", device.wire_diameter, Dimension::length},
          Positive{"diameter", device.nominal_diameter, Dimension::length},
          Positive{"length", device.nominal_length, Dimension::length},
          Positive{"catheter_diameter", device.catheter_diameter, Dimension::length},
          Positive{"flare_length", device.flare_length, Dimension::length}}) {
        if (auto invalid = find_not_positive(check)) return invalid;
    }
    if (!is_positive(device.braid_ratio)) {
        return InvalidValue{"braid_ratio",
                            fmt::format("= {:.6g} is not positive", device.braid_ratio)};
    }
    if (auto invalid = device.forces == ForceSource::springs ? find_invalid_springs(device)
                                                             : find_invalid_wires(device)) {
        return invalid;
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
    return find_invalid_flare(device);
}

void validate(const FlowDiverter& device)
{
    if (const auto invalid = find_invalid(device)) {
        throw ConfigError(fmt::format("device.{} {}", invalid->key, invalid->finding));
    }
}

double braid_ratio_at_porosity(const FlowDiverter& device, double surface_porosity)
{
    if (!(surface_porosity > 0.0 && surface_porosity < 1.0)) {
        throw ConfigError(
            fmt::format("nominal_porosity = {:.6g} is out of range; it must lie between 0 and 1",
                        surface_porosity));
    }
    const double along_the_axis = device.num_wires * device.wire_diameter /
                                  (2.0 * std::numbers::pi * device.nominal_diameter);
    const double covered = 1.0 - std::sqrt(surface_porosity);
    const double sine = along_the_axis / covered;
    if (!(sine < 1.0)) {
        throw ConfigError(fmt::format(
            "nominal_porosity = {:.6g} is too large: {} wires of {:.6g} um leave less than {:.6g} "
            "of a device of {:.6g} mm open",
            surface_porosity, device.num_wires, 1e6 * device.wire_diameter,
            (1.0 - along_the_axis) * (1.0 - along_the_axis), 1e3 * device.nominal_diameter));
    }
    return sine / std::sqrt(1.0 - sine * sine);
}

std::string_view force_source_name(ForceSource source)
{
    return source == ForceSource::springs ? "springs" : "wire-theory";
}

std::string force_origin(const FlowDiverter& device)
{
    if (device.forces == ForceSource::springs) {
        return fmt::format(
            "spring coefficients of {:.6g} N/m (surface) and {:.6g} N/m (radial, a node of {:.6g} "
            "mm^2), force scale {:.6g}",
            device.surface_coefficient, device.radial_coefficient, 1e6 * device.reference_node_area,
            device.force_scale);
    }
    return fmt::format(
        "wire theory (Jedwab and Clerc 1993): {} wires of {:.6g} um, E = {:.6g} GPa, Poisson's "
        "ratio {:.6g}",
        device.num_wires, 1e6 * device.wire_diameter, 1e-9 * device.youngs_modulus,
        device.poisson_ratio);
}

}  // namespace braidzone
