#include "deploy/wire_theory.hpp"

#include "core/error.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

namespace braidzone {

namespace {

/// Sine, cosine and tangent of a braid angle, measured from the circumference.
struct BraidAngle {
    double sine;
    double cosine;
    double tangent() const { return sine / cosine; }
};

BraidAngle angle_at_rest(const FlowDiverter& device)
{
    const double hypotenuse = std::hypot(1.0, device.braid_ratio);
    return {device.braid_ratio / hypotenuse, 1.0 / hypotenuse};
}

void require_modulus(const FlowDiverter& device)
{
    if (!(device.youngs_modulus > 0.0)) {
        throw InputError(
            fmt::format("device.youngs_modulus = {:.6g} Pa; wire theory needs a positive one",
                        device.youngs_modulus));
    }
}

/// The angle of the braid held at a diameter.
BraidAngle angle_at(const FlowDiverter& device, double diameter)
{
    require_modulus(device);
    const double largest = largest_diameter(device);
    if (!(diameter > 0.0 && diameter < largest)) {
        throw InputError(fmt::format(
            "diameter = {:.6g} mm; a braid of nominal diameter {:.6g} mm "
            "and ratio {:.6g} allows more than 0 and less than {:.6g} mm",
            1e3 * diameter, 1e3 * device.nominal_diameter, device.braid_ratio, 1e3 * largest));
    }
    const double cosine = diameter / largest;
    // (1 - c)(1 + c) keeps its digits where the cosine is close to 1.
    return {std::sqrt((1.0 - cosine) * (1.0 + cosine)), cosine};
}

/// Length of wire between two crossings [m]: of the n/2 crossings around, each wire meets the next
/// half a spacing further.
double crossing_length(const FlowDiverter& device)
{
    return std::numbers::pi * device.nominal_diameter / device.num_wires /
           angle_at_rest(device).cosine;
}

}  // namespace

double largest_diameter(const FlowDiverter& device)
{
    return device.nominal_diameter * std::hypot(1.0, device.braid_ratio);
}

double wire_bending_rigidity(const FlowDiverter& device)
{
    require_modulus(device);
    return device.youngs_modulus * std::numbers::pi * std::pow(device.wire_diameter, 4) / 64.0;
}

double wire_torsion_rigidity(const FlowDiverter& device)
{
    // GJ / EI = 2 G / E = 1 / (1 + nu)
    return wire_bending_rigidity(device) / (1.0 + device.poisson_ratio);
}

double wire_energy(const FlowDiverter& device, double diameter)
{
    const BraidAngle b = angle_at(device, diameter), b0 = angle_at_rest(device);
    const double nominal = device.nominal_diameter;
    const double curvature =
        2.0 * b.cosine * b.cosine / diameter - 2.0 * b0.cosine * b0.cosine / nominal;
    const double torsion = 2.0 * b.sine * b.cosine / diameter - 2.0 * b0.sine * b0.cosine / nominal;
    const double wire_length = device.nominal_length / b0.sine;
    return device.num_wires * wire_length *
           (0.5 * wire_bending_rigidity(device) * curvature * curvature +
            0.5 * wire_torsion_rigidity(device) * torsion * torsion);
}

double axial_force(const FlowDiverter& device, double diameter)
{
    const BraidAngle b = angle_at(device, diameter), b0 = angle_at_rest(device);
    const double k1 = 2.0 * b0.sine * b0.cosine / device.nominal_diameter;
    const double k2 = 2.0 * b0.cosine * b0.cosine / device.nominal_diameter;
    const double k3 = largest_diameter(device);
    const double torsion = wire_torsion_rigidity(device) / k3 * (2.0 * b.sine / k3 - k1);
    const double bending =
        wire_bending_rigidity(device) * b.tangent() / k3 * (2.0 * b.cosine / k3 - k2);
    return 2.0 * device.num_wires * (torsion - bending);
}

double wire_pressure(const FlowDiverter& device, double diameter)
{
    const double width = diameter * angle_at(device, diameter).tangent();
    return 2.0 * axial_force(device, diameter) / (std::numbers::pi * width * width);
}

double wire_radial_force(const FlowDiverter& device, double diameter)
{
    return wire_pressure(device, diameter) * std::numbers::pi * diameter;
}

double crossing_node_area(const FlowDiverter& device)
{
    const double half_spacing = std::numbers::pi * device.nominal_diameter / device.num_wires;
    return 2.0 * device.braid_ratio * half_spacing * half_spacing;
}

RadialSpring crossing_radial_spring(const FlowDiverter& device)
{
    const double per_rigidity = 2.0 * crossing_length(device) *
                                std::pow(angle_at_rest(device).cosine / device.nominal_radius(), 4);
    return {.rest_radius = device.nominal_radius(),
            .bending = per_rigidity * wire_bending_rigidity(device),
            .torsion = per_rigidity * wire_torsion_rigidity(device),
            .braid_ratio = device.braid_ratio};
}

double crossing_bending_stiffness(const FlowDiverter& device)
{
    return wire_bending_rigidity(device) / std::pow(crossing_length(device), 3);
}

double wire_axial_stiffness(const FlowDiverter& device)
{
    require_modulus(device);
    const double section = 0.25 * std::numbers::pi * device.wire_diameter * device.wire_diameter;
    return device.youngs_modulus * section / crossing_length(device);
}

}  // namespace braidzone
