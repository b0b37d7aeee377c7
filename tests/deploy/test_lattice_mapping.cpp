#include "deploy/lattice_mapping.hpp"
#include "support/devices.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace braidzone {

namespace {

struct Lattices {
    BraidLattice coarse = make_lattice(test::pipeline_4x20(), LatticeKind::paper_2020);
    BraidLattice fine = make_lattice(test::pipeline_4x20());
    LatticeMapping mapping = make_lattice_mapping(coarse, fine);
};

/// Values of a function of the share of the length and the angle.
template <typename Function>
std::vector<double> values_on(const BraidLattice& lattice, Function function)
{
    std::vector<double> values;
    for (int ring = 0; ring < lattice.num_rings; ++ring) {
        for (int column = 0; column < lattice.nodes_per_ring; ++column) {
            values.push_back(function(static_cast<double>(ring) / (lattice.num_rings - 1),
                                      lattice.angle(ring, column)));
        }
    }
    return values;
}

}  // namespace

TEST(CarriedOver, LeavesACircleACircle)
{
    const Lattices lattices;
    const std::vector<double> radii(static_cast<std::size_t>(lattices.coarse.num_nodes()), 1.9e-3);
    for (double radius : carried_over(lattices.mapping, radii))
        EXPECT_NEAR(radius, 1.9e-3, 1e-17);
}

TEST(CarriedOver, IsExactForAnEvenTaperUpToItsEnds)
{
    const Lattices lattices;
    const auto taper = [](double along, double) { return 2e-3 - 4e-4 * along; };
    const std::vector<double> fine =
        carried_over(lattices.mapping, values_on(lattices.coarse, taper));
    const std::vector<double> exact = values_on(lattices.fine, taper);
    for (std::size_t i = 0; i < fine.size(); ++i)
        EXPECT_NEAR(fine[i], exact[i], 1e-17);
}

// Cubic convolution has an error of third order at least: a period of m nodes leaves about
// (2 pi / m)^3 / 24 of the amplitude: 1e-3 of it for m = 24. A shift by a column would be 0.26.
TEST(CarriedOver, FollowsAWaveAroundTheRing)
{
    const Lattices lattices;
    const auto wave = [](double, double angle) { return std::cos(angle - 0.3); };
    const std::vector<double> fine =
        carried_over(lattices.mapping, values_on(lattices.coarse, wave));
    const std::vector<double> exact = values_on(lattices.fine, wave);
    for (std::size_t i = 0; i < fine.size(); ++i)
        EXPECT_NEAR(fine[i], exact[i], 2e-3);
}

TEST(CarriedOverRings, KeepsTheEndsAndTheOrder)
{
    const Lattices lattices;
    std::vector<double> places;
    for (int ring = 0; ring < lattices.coarse.num_rings; ++ring)
        places.push_back(25e-3 - 0.5e-3 * ring + (ring > 20 ? 0.2e-3 * (ring - 20) : 0.0));
    const std::vector<double> fine = carried_over_rings(lattices.mapping, places);
    ASSERT_EQ(static_cast<int>(fine.size()), lattices.fine.num_rings);
    EXPECT_EQ(fine.front(), places.front());
    EXPECT_DOUBLE_EQ(fine.back(), places.back());
    EXPECT_TRUE(std::is_sorted(fine.rbegin(), fine.rend()));
}

// A uniform pressure on a third of the columns: the sum stays, and where the wall is not touched
// nothing is borne.
TEST(CarriedOverForces, KeepsTheSumAndLeavesFreeNodesWithoutForce)
{
    const Lattices lattices;
    const std::vector<double> force =
        values_on(lattices.coarse, [](double, double angle) { return angle < 2.0 ? 3e-5 : 0.0; });
    const std::vector<double> coarse_areas(force.size(), 0.29e-6);
    const std::vector<double> fine_areas(static_cast<std::size_t>(lattices.fine.num_nodes()),
                                         0.055e-6);
    std::vector<char> in_contact;
    for (double angle : values_on(lattices.fine, [](double, double a) { return a; }))
        in_contact.push_back(std::fmod(angle, 2.0 * std::numbers::pi) < 2.0 ? 1 : 0);
    const std::vector<double> fine =
        carried_over_forces(lattices.mapping, force, coarse_areas, fine_areas, in_contact);
    const double sum = std::accumulate(force.begin(), force.end(), 0.0);
    EXPECT_NEAR(std::accumulate(fine.begin(), fine.end(), 0.0), sum, 1e-12 * sum);
    for (std::size_t i = 0; i < fine.size(); ++i) {
        EXPECT_TRUE(in_contact[i] || fine[i] == 0.0);
    }
}

TEST(CarriedOverForces, AreNothingWhereNothingTouchesTheWall)
{
    const Lattices lattices;
    const std::vector<double> force(static_cast<std::size_t>(lattices.coarse.num_nodes()), 1e-5);
    const std::vector<double> areas(force.size(), 0.29e-6);
    const std::size_t num_fine = static_cast<std::size_t>(lattices.fine.num_nodes());
    for (double fine : carried_over_forces(lattices.mapping, force, areas,
                                           std::vector<double>(num_fine, 0.055e-6),
                                           std::vector<char>(num_fine, 0)))
        EXPECT_EQ(fine, 0.0);
}

}  // namespace braidzone
