#include "deploy/spring_forces.hpp"

#include "deploy/wire_theory.hpp"

#include <algorithm>
#include <cmath>

namespace braidzone {

namespace {

Vec3 arm_force(const Vec3& node, const Vec3& other, double coefficient, double rest_length)
{
    const Vec3 arm = other - node;
    const double length = arm.norm();
    return coefficient * (1.0 - rest_length / length) * arm;
}

/// Force of a radial spring on the node at `outward` from its hub.
Vec3 outward_force(const RadialSpring& spring, const Vec3& outward)
{
    const double radius = outward.norm();
    if (!(radius > 0.0)) return Vec3::Zero();
    return radial_force(spring, radius) / radius * outward;
}

/// Coefficient of an arm in the paper's code for the 4 mm device [N/m] (Zavodszky et al. 2020,
/// Table 2), and its ratio to that of a radial spring at a crossing: 0.1 N/m there belong to a node
/// of (20 mm / 36) (pi 4 mm / 24) = 0.29089 mm^2, and a crossing has 0.054831 mm^2.
constexpr double usual_surface = 0.6;
constexpr double usual_surface_to_radial = 0.6 / (0.1 * 0.054831 / 0.29089);

SpringCoefficients from_springs(const FlowDiverter& device, const BraidLattice& lattice)
{
    SpringCoefficients coefficients;
    coefficients.surface = device.surface_coefficient;
    coefficients.radial = {
        .rest_radius = device.nominal_radius(),
        .bending = device.radial_coefficient * lattice.node_area() / device.reference_node_area,
        .torsion = 0.0,
        .braid_ratio = device.braid_ratio};
    coefficients.force_scale = device.force_scale;
    return coefficients;
}

double surface_to_radial(const FlowDiverter& device)
{
    const bool has_springs = device.surface_coefficient > 0.0 && device.radial_coefficient > 0.0 &&
                             device.reference_node_area > 0.0;
    if (!has_springs) return usual_surface_to_radial;
    return device.surface_coefficient * device.reference_node_area /
           (device.radial_coefficient * crossing_node_area(device));
}

SpringCoefficients from_wires(const FlowDiverter& device, const BraidLattice& lattice)
{
    const RadialSpring crossing = crossing_radial_spring(device);
    const double real_surface = surface_to_radial(device) * radial_stiffness(crossing);
    SpringCoefficients coefficients;
    coefficients.surface =
        device.surface_coefficient > 0.0 ? device.surface_coefficient : usual_surface;
    coefficients.force_scale = real_surface / coefficients.surface;
    coefficients.radial = scaled(
        crossing, lattice.node_area() / crossing_node_area(device) / coefficients.force_scale);
    return coefficients;
}

}  // namespace

SpringCoefficients spring_coefficients(const FlowDiverter& device, const BraidLattice& lattice,
                                       double bending_ratio)
{
    SpringCoefficients coefficients = device.forces == ForceSource::springs
                                          ? from_springs(device, lattice)
                                          : from_wires(device, lattice);
    const BraidLattice crossings = make_lattice(device);
    const double area = lattice.node_area() / crossings.node_area();
    const double arm = lattice.arm_length / crossings.arm_length;
    coefficients.bending = bending_ratio * coefficients.surface * area / (arm * arm * arm * arm);
    coefficients.surface *= area / (arm * arm);
    return coefficients;
}

RadialSpring spring_of_ring(const BraidLattice& lattice, const SpringCoefficients& coefficients,
                            int ring)
{
    if (lattice.rest_radii.empty()) return coefficients.radial;
    return at_rest_radius(coefficients.radial, lattice.rest_radius(ring));
}

double elastic_energy(const BraidLattice& lattice, const SpringCoefficients& coefficients,
                      const std::vector<Vec3>& nodes, const std::vector<CrossSection>& rings)
{
    const auto at = [&](int ring, int column) -> const Vec3& {
        return nodes[static_cast<std::size_t>(lattice.node(ring, column))];
    };
    double energy = 0.0;
    for (int ring = 0; ring < lattice.num_rings; ++ring) {
        for (int column = 0; column < lattice.nodes_per_ring; ++column) {
            const Vec3& node = at(ring, column);
            if (ring + 1 < lattice.num_rings) {
                for (std::size_t family : {0u, 1u}) {
                    const double stretch =
                        (at(ring + 1, column + lattice.arm_steps[family]) - node).norm() -
                        lattice.rest_length(ring, family);
                    energy += 0.5 * coefficients.surface * stretch * stretch;
                }
            }
            const Vec3& hub = rings[static_cast<std::size_t>(ring)].origin;
            energy +=
                lattice.area_share(ring) *
                radial_energy(spring_of_ring(lattice, coefficients, ring), (node - hub).norm());
        }
    }
    return energy;
}

Vec3 spring_force(const BraidLattice& lattice, const SpringCoefficients& coefficients,
                  const std::vector<Vec3>& nodes, const std::vector<CrossSection>& rings, int ring,
                  int column)
{
    const int n = lattice.nodes_per_ring;
    const std::size_t index = static_cast<std::size_t>(ring * n + column);
    const Vec3& node = nodes[index];
    const auto arm_to = [&](int other, double rest_length) {
        return arm_force(node, nodes[static_cast<std::size_t>(other)], coefficients.surface,
                         rest_length);
    };
    const auto arms_before = [&](std::size_t family) {
        return arm_to(lattice.node(ring - 1, column - lattice.arm_steps[family]),
                      lattice.rest_length(ring - 1, family));
    };
    const auto arms_behind = [&](std::size_t family) {
        return arm_to(lattice.node(ring + 1, column + lattice.arm_steps[family]),
                      lattice.rest_length(ring, family));
    };

    Vec3 force = Vec3::Zero();
    if (ring > 0) force += arms_before(1) + arms_before(0);
    if (ring + 1 < lattice.num_rings) force += arms_behind(1) + arms_behind(0);
    const Vec3 outward = node - rings[static_cast<std::size_t>(ring)].origin;
    return force + lattice.area_share(ring) *
                       outward_force(spring_of_ring(lattice, coefficients, ring), outward);
}

double add_spring_forces(const BraidLattice& lattice, const SpringCoefficients& coefficients,
                         const std::vector<Vec3>& nodes, const std::vector<CrossSection>& rings,
                         std::vector<Vec3>& forces)
{
    double energy = 0.0;
    for (int ring = 0; ring < lattice.num_rings; ++ring) {
        const RadialSpring spring = spring_of_ring(lattice, coefficients, ring);
        const double share = lattice.area_share(ring);
        const Vec3& hub = rings[static_cast<std::size_t>(ring)].origin;
        for (int column = 0; column < lattice.nodes_per_ring; ++column) {
            const auto node = static_cast<std::size_t>(lattice.node(ring, column));
            const Vec3 outward = nodes[node] - hub;
            energy += share * radial_energy(spring, outward.norm());
            forces[node] += share * outward_force(spring, outward);
            if (ring + 1 == lattice.num_rings) continue;
            for (const std::size_t family : {0u, 1u}) {
                const auto other = static_cast<std::size_t>(
                    lattice.node(ring + 1, column + lattice.arm_steps[family]));
                const double rest_length = lattice.rest_length(ring, family);
                const Vec3 arm = nodes[other] - nodes[node];
                const double length = arm.norm();
                const double stretch = length - rest_length;
                const Vec3 force = coefficients.surface * (stretch / length) * arm;
                energy += 0.5 * coefficients.surface * stretch * stretch;
                forces[node] += force;
                forces[other] -= force;
            }
        }
    }
    return energy;
}

Vec3 hub_force(const BraidLattice& lattice, const SpringCoefficients& coefficients,
               const std::vector<Vec3>& nodes, const std::vector<CrossSection>& rings, int ring)
{
    const CrossSection& section = rings[static_cast<std::size_t>(ring)];
    const RadialSpring spring = spring_of_ring(lattice, coefficients, ring);
    Vec3 sum = Vec3::Zero();
    for (int column = 0; column < lattice.nodes_per_ring; ++column) {
        const Vec3& node = nodes[static_cast<std::size_t>(lattice.node(ring, column))];
        sum -= lattice.area_share(ring) * outward_force(spring, node - section.origin);
    }
    return sum - section.tangent.dot(sum) * section.tangent;
}

double largest_frequency(const SpringCoefficients& coefficients, double mass)
{
    return std::sqrt((8.0 * coefficients.surface + radial_stiffness(coefficients.radial) +
                      32.0 * coefficients.bending) /
                     mass);
}

}  // namespace braidzone
