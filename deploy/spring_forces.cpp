#include "deploy/spring_forces.hpp"

#include <cmath>

namespace braidzone {

namespace {

Vec3 arm_force(const Vec3& node, const Vec3& other, double coefficient, double rest_length)
{
    const Vec3 arm = other - node;
    const double length = arm.norm();
    return coefficient * (1.0 - rest_length / length) * arm;
}

}  // namespace

namespace {

RadialSpring radial_spring(const FlowDiverter& device, const BraidLattice& lattice)
{
    return {.rest_radius = lattice.nominal_radius,
            .bending = device.radial_coefficient * lattice.node_area() / device.reference_node_area,
            .torsion = 0.0,
            .braid_ratio = device.braid_ratio};
}

}  // namespace

SpringCoefficients spring_coefficients(const FlowDiverter& device, const BraidLattice& lattice,
                                       double bending_ratio)
{
    return {.surface = device.surface_coefficient,
            .radial = radial_spring(device, lattice),
            .bending = bending_ratio * device.surface_coefficient};
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
                for (int next : {column, column - 1}) {
                    const double stretch = (at(ring + 1, next) - node).norm() - lattice.arm_length;
                    energy += 0.5 * coefficients.surface * stretch * stretch;
                }
            }
            const Vec3& hub = rings[static_cast<std::size_t>(ring)].origin;
            energy +=
                lattice.area_share(ring) * radial_energy(coefficients.radial, (node - hub).norm());
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
    const int before = column == 0 ? n - 1 : column - 1;
    const int after = column == n - 1 ? 0 : column + 1;
    const auto arm_to = [&](int other) {
        return arm_force(node, nodes[static_cast<std::size_t>(other)], coefficients.surface,
                         lattice.arm_length);
    };

    Vec3 force = Vec3::Zero();
    if (ring > 0) {
        const int distal = (ring - 1) * n;
        force += arm_to(distal + column) + arm_to(distal + after);
    }
    if (ring + 1 < lattice.num_rings) {
        const int proximal = (ring + 1) * n;
        force += arm_to(proximal + column) + arm_to(proximal + before);
    }
    const Vec3 outward = node - rings[static_cast<std::size_t>(ring)].origin;
    const double radius = outward.norm();
    if (radius > 0.0) {
        force +=
            lattice.area_share(ring) * radial_force(coefficients.radial, radius) / radius * outward;
    }
    return force;
}

double largest_frequency(const SpringCoefficients& coefficients, double mass)
{
    return std::sqrt((8.0 * coefficients.surface + radial_stiffness(coefficients.radial) +
                      32.0 * coefficients.bending) /
                     mass);
}

}  // namespace braidzone
