#include "deploy/lattice_mapping.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numeric>

namespace braidzone {

namespace {

/// Weights of four values in a row at a place u from the second (0) to the third (1).
std::array<double, 4> cubic_weights(double u)
{
    return {0.5 * u * (-1.0 + u * (2.0 - u)), 1.0 + 0.5 * u * u * (-5.0 + 3.0 * u),
            0.5 * u * (1.0 + u * (4.0 - 3.0 * u)), 0.5 * u * u * (-1.0 + u)};
}

/// A place between two of the coarse rings.
struct RingPlace {
    int first = 0;      ///< the ring before
    double part = 0.0;  ///< of the way to the next
};

RingPlace ring_place(int fine_ring, int num_fine_rings, int num_coarse_rings)
{
    const double place =
        static_cast<double>(fine_ring) * (num_coarse_rings - 1) / (num_fine_rings - 1);
    const int first = std::clamp(static_cast<int>(place), 0, num_coarse_rings - 2);
    return {first, place - first};
}

/// Cubic weights of the coarse rings around a place; beyond the ends the values go on evenly.
struct RingWeights {
    std::array<int, 4> rings{};
    std::array<double, 4> weights{};
};

RingWeights ring_weights(const RingPlace& place, int num_rings)
{
    RingWeights result;
    result.weights = cubic_weights(place.part);
    for (int i = 0; i < 4; ++i)
        result.rings[static_cast<std::size_t>(i)] = place.first + i - 1;
    auto& [before, first, second, after] = result.weights;
    if (place.first == 0) {  // value(-1) = 2 value(0) - value(1)
        first += 2.0 * before;
        second -= before;
        before = 0.0;
        result.rings[0] = 0;
    }
    if (place.first == num_rings - 2) {
        second += 2.0 * after;
        first -= after;
        after = 0.0;
        result.rings[3] = num_rings - 1;
    }
    return result;
}

}  // namespace

LatticeMapping make_lattice_mapping(const BraidLattice& coarse, const BraidLattice& fine)
{
    assert(coarse.stagger == 0.0);
    LatticeMapping mapping;
    mapping.num_coarse_rings = coarse.num_rings;
    mapping.num_fine_rings = fine.num_rings;
    mapping.stencils.reserve(static_cast<std::size_t>(fine.num_nodes()));
    const int n = coarse.nodes_per_ring;
    for (int ring = 0; ring < fine.num_rings; ++ring) {
        const RingWeights along =
            ring_weights(ring_place(ring, fine.num_rings, coarse.num_rings), coarse.num_rings);
        for (int column = 0; column < fine.nodes_per_ring; ++column) {
            const double around = fine.angle(ring, column) * n / (2.0 * std::numbers::pi);
            const double first = std::floor(around);
            const std::array<double, 4> weights = cubic_weights(around - first);
            const int start = static_cast<int>(first) % n;
            LatticeMapping::Stencil stencil;
            for (std::size_t i = 0; i < 4; ++i) {
                for (std::size_t j = 0; j < 4; ++j) {
                    stencil.nodes[4 * i + j] =
                        coarse.node(along.rings[i], start + static_cast<int>(j) - 1);
                    stencil.weights[4 * i + j] = along.weights[i] * weights[j];
                }
            }
            mapping.stencils.push_back(stencil);
        }
    }
    return mapping;
}

std::vector<double> carried_over(const LatticeMapping& mapping, const std::vector<double>& values)
{
    std::vector<double> result;
    result.reserve(mapping.stencils.size());
    for (const LatticeMapping::Stencil& stencil : mapping.stencils) {
        double sum = 0.0;
        for (std::size_t i = 0; i < stencil.nodes.size(); ++i)
            sum += stencil.weights[i] * values[static_cast<std::size_t>(stencil.nodes[i])];
        result.push_back(sum);
    }
    return result;
}

std::vector<double> carried_over_rings(const LatticeMapping& mapping,
                                       const std::vector<double>& arc_lengths)
{
    std::vector<double> result;
    for (int ring = 0; ring < mapping.num_fine_rings; ++ring) {
        const RingPlace place = ring_place(ring, mapping.num_fine_rings, mapping.num_coarse_rings);
        const std::size_t first = static_cast<std::size_t>(place.first);
        result.push_back(std::lerp(arc_lengths[first], arc_lengths[first + 1], place.part));
    }
    return result;
}

std::vector<double> carried_over_forces(const LatticeMapping& mapping,
                                        const std::vector<double>& coarse_forces,
                                        const std::vector<double>& coarse_areas,
                                        const std::vector<double>& fine_areas,
                                        const std::vector<char>& in_contact)
{
    std::vector<double> pressures;
    for (std::size_t i = 0; i < coarse_forces.size(); ++i)
        pressures.push_back(coarse_forces[i] / coarse_areas[i]);
    std::vector<double> forces = carried_over(mapping, pressures);
    for (std::size_t i = 0; i < forces.size(); ++i)
        forces[i] = in_contact[i] ? std::max(0.0, forces[i]) * fine_areas[i] : 0.0;
    const double sum = std::accumulate(forces.begin(), forces.end(), 0.0);
    const double wanted = std::accumulate(coarse_forces.begin(), coarse_forces.end(), 0.0);
    if (!(sum > 0.0)) return forces;
    for (double& force : forces)
        force *= wanted / sum;
    return forces;
}

}  // namespace braidzone
