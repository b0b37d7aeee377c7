#pragma once

#include "deploy/deployment.hpp"

#include <cmath>
#include <numbers>

namespace braidzone::test {

/// A device of 48 wires that lies along z from 0 to `length`, every crossing at one radius and in
/// contact; its distal end is at z = length. Made by hand, not deployed.
inline Deployment straight_device(double radius, double length, int num_rings = 51)
{
    Deployment device;
    BraidLattice& lattice = device.lattice;
    lattice.nodes_per_ring = 24;
    lattice.num_rings = num_rings;
    lattice.nominal_radius = radius;
    lattice.ring_spacing = length / (num_rings - 1);
    lattice.arm_width = std::numbers::pi * radius / 24;
    for (int ring = 0; ring < num_rings; ++ring) {
        const double z = length - ring * lattice.ring_spacing;
        CrossSection section;
        section.origin = Vec3(0, 0, z);
        section.tangent = Vec3::UnitZ();
        section.normal = Vec3::UnitX();
        section.binormal = Vec3::UnitY();
        section.inscribed_radius = radius;
        device.rings.push_back(section);
        device.ring_arc_length.push_back(z);
        for (int column = 0; column < 24; ++column) {
            const double angle = lattice.angle(ring, column);
            device.nodes.emplace_back(radius * std::cos(angle), radius * std::sin(angle), z);
            device.in_contact.push_back(1);
        }
    }
    device.converged = true;
    return device;
}

}  // namespace braidzone::test
