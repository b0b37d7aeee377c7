#include "deploy/braid_lattice.hpp"

#include "core/error.hpp"
#include "core/smooth_step.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace braidzone {

namespace {

/// Gaps and node spacings an arm spans, of the lattice of Zavodszky et al. 2020.
constexpr int paper_gaps = 36;
constexpr int paper_span = 3;

BraidLattice crossing_lattice(const FlowDiverter& device)
{
    BraidLattice lattice;
    lattice.nodes_per_ring = device.num_wires / 2;
    lattice.nominal_radius = device.nominal_radius();
    lattice.arm_width = std::numbers::pi * lattice.nominal_radius / lattice.nodes_per_ring;
    lattice.ring_spacing = device.braid_ratio * lattice.arm_width;
    const double chord =
        2.0 * lattice.nominal_radius * std::sin(0.5 * std::numbers::pi / lattice.nodes_per_ring);
    lattice.arm_length = std::hypot(lattice.ring_spacing, chord);
    const long num_gaps = std::lround(device.nominal_length / lattice.ring_spacing);
    lattice.num_rings = static_cast<int>(std::max(num_gaps, 2L)) + 1;
    return lattice;
}

BraidLattice paper_lattice(const FlowDiverter& device)
{
    BraidLattice lattice;
    lattice.nodes_per_ring = device.num_wires / 2;
    lattice.num_rings = paper_gaps + 1;
    lattice.nominal_radius = device.nominal_radius();
    lattice.ring_spacing = device.nominal_length / paper_gaps;
    lattice.arm_width =
        paper_span * 2.0 * std::numbers::pi * lattice.nominal_radius / lattice.nodes_per_ring;
    lattice.arm_length = std::hypot(lattice.ring_spacing, lattice.arm_width);
    lattice.stagger = 0.0;
    lattice.arm_steps = {-paper_span, paper_span};
    return lattice;
}

void add_flares(BraidLattice& lattice, const FlowDiverter& device)
{
    for (int ring = 0; ring < lattice.num_rings; ++ring) {
        const double from_distal = ring * lattice.ring_spacing;
        const double from_proximal = (lattice.num_rings - 1 - ring) * lattice.ring_spacing;
        lattice.rest_radii.push_back(
            lattice.nominal_radius +
            device.distal_flare * smooth_step(1.0 - from_distal / device.flare_length) +
            device.proximal_flare * smooth_step(1.0 - from_proximal / device.flare_length));
    }
    const double square_length = lattice.arm_length * lattice.arm_length;
    const double square_spacing = lattice.ring_spacing * lattice.ring_spacing;
    // Width of an arm at nominal radius as l0 has it (chord or arc) over R0, squared.
    const double square_width =
        (square_length - square_spacing) / (lattice.nominal_radius * lattice.nominal_radius);
    for (int ring = 0; ring + 1 < lattice.num_rings; ++ring) {
        const double here = lattice.rest_radius(ring), next = lattice.rest_radius(ring + 1);
        const double square =
            square_length - square_width * here * next - (next - here) * (next - here);
        if (!(here > 0.0 && next > 0.0 && square > 0.0)) {
            throw ConfigError(fmt::format(
                "device.{}_flare: the braid cannot lie at a radius of {:.6g} mm at ring {} of {}; "
                "a braid of radius {:.6g} mm and this angle opens to {:.6g} mm",
                2 * ring < lattice.num_rings ? "distal" : "proximal", 1e3 * std::max(here, next),
                ring, lattice.num_rings, 1e3 * lattice.nominal_radius,
                1e3 * std::sqrt(square_length / square_width)));
        }
        lattice.gap_spacings.push_back(std::sqrt(square));
    }
}

}  // namespace

double BraidLattice::angle(int ring, int column) const
{
    return (column + stagger * ring) * 2.0 * std::numbers::pi / nodes_per_ring;
}

BraidLattice make_lattice(const FlowDiverter& device, LatticeKind kind)
{
    validate(device);
    BraidLattice lattice =
        kind == LatticeKind::crossings ? crossing_lattice(device) : paper_lattice(device);
    if (device.distal_flare != 0.0 || device.proximal_flare != 0.0) add_flares(lattice, device);
    return lattice;
}

std::array<int, 4> rhombus_corners(const BraidLattice& lattice, int ring, int column)
{
    return {lattice.node(ring, column), lattice.node(ring + 1, column - 1),
            lattice.node(ring + 2, column - 1), lattice.node(ring + 1, column)};
}

}  // namespace braidzone
