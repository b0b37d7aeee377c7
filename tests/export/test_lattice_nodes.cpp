#include "core/error.hpp"
#include "export/lattice_nodes.hpp"
#include "support/braids.hpp"
#include "support/shapes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

namespace braidzone {
namespace {

constexpr double radius = 1.5e-3, length = 6e-3, h = 0.1e-3;
constexpr auto fluid = static_cast<std::uint8_t>(NodeType::fluid);
constexpr auto wall = static_cast<std::uint8_t>(NodeType::wall);
constexpr auto unused = static_cast<std::uint8_t>(NodeType::unused);

/// A tube along z with a slanted sheet across it, wider than the tube is: only its part in the
/// lumen is taken.
struct TubeWithSheet {
    Vessel vessel = test::tube_vessel(radius, length, 96, 24);
    PorousField field;
    LatticeNodes nodes;

    TubeWithSheet()
    {
        // 2 mm by 2 mm fit into the tube of 3 mm; the rest of the section stays open.
        const Vec3 a(0.1e-3, 0, 0.02e-3), b(0, 0.1e-3, 0);
        const BraidSurface surface =
            test::flat_braid(Vec3(0, 0, 3.013e-3) - 10.0 * (a + b), a, 20, b, 20, 30e-6);
        field = deposit(make_resistance_sheet(surface, ConstantLaw{{400.0, 300.0}}, Fluid{}),
                        vessel, {.spacing = h});
        nodes = make_lattice_nodes(field, vessel, 1);
    }

    std::uint8_t type(const std::array<int, 3>& node) const
    {
        return nodes.type[nodes.grid.index(node[0], node[1], node[2])];
    }
};

TEST(LatticeNodes, FluidIsTheLumen)
{
    const TubeWithSheet tube;
    double num_fluid = 0.0;
    for (int k = 0; k < tube.nodes.grid.dims[2]; ++k) {
        for (int j = 0; j < tube.nodes.grid.dims[1]; ++j) {
            for (int i = 0; i < tube.nodes.grid.dims[0]; ++i) {
                const Vec3 place = tube.nodes.grid.centre(i, j, k);
                const double r = std::hypot(place.x(), place.y());
                const bool inside = r < radius && place.z() > 0.0 && place.z() < length;
                // The tube is a prism within the circle.
                const double apothem = radius * std::cos(std::numbers::pi / 96);
                if (r > apothem - 1e-9 && r < radius + 1e-9) continue;
                // Nodes in the plane of an opening may count either way.
                if (std::abs(place.z()) < 1e-9 || std::abs(place.z() - length) < 1e-9) continue;
                ASSERT_EQ(tube.type({i, j, k}) == fluid, inside) << place.transpose();
                num_fluid += inside;
            }
        }
    }
    // 59 planes between the openings; nodes on the circle's edge are left out.
    const double expected = 59.0 * std::numbers::pi * radius * radius / (h * h);
    EXPECT_NEAR(num_fluid / expected, 1.0, 0.02);
}

// Streaming from a fluid node ends at a node that is something; and each opening has about its area
// of nodes, with those that only a slanted link reaches.
TEST(LatticeNodes, SurroundTheFluidByWallAndOpenings)
{
    const TubeWithSheet tube;
    const auto& dims = tube.nodes.grid.dims;
    for (int k = 1; k + 1 < dims[2]; ++k)
        for (int j = 1; j + 1 < dims[1]; ++j)
            for (int i = 1; i + 1 < dims[0]; ++i) {
                if (tube.type({i, j, k}) != fluid) continue;
                for (int axis = 0; axis < 3; ++axis) {
                    for (const int step : {-1, 1}) {
                        std::array<int, 3> other{i, j, k};
                        other[static_cast<std::size_t>(axis)] += step;
                        ASSERT_NE(tube.type(other), unused);
                    }
                }
            }
    ASSERT_EQ(tube.nodes.openings.size(), 2U);
    EXPECT_EQ(tube.nodes.openings[0].opening, 1);
    EXPECT_EQ(tube.nodes.openings[0].code, static_cast<std::uint8_t>(NodeType::inlet));
    EXPECT_EQ(tube.nodes.openings[1].opening, 0);
    EXPECT_EQ(tube.nodes.openings[1].code, static_cast<std::uint8_t>(NodeType::outlet));
    const double expected = std::numbers::pi * radius * radius / (h * h);
    for (const LatticeOpening& opening : tube.nodes.openings) {
        EXPECT_NEAR(static_cast<double>(opening.num_nodes) / expected, 1.0, 0.1);
        std::int64_t counted = 0;
        for (const std::uint8_t type : tube.nodes.type)
            counted += type == opening.code;
        EXPECT_EQ(counted, opening.num_nodes);
    }
    EXPECT_GT(std::count(tube.nodes.type.begin(), tube.nodes.type.end(), wall), 0);
}

TEST(LatticeNodes, HoldTheFieldsResistanceAtItsPlaces)
{
    const TubeWithSheet tube;
    const double exact = resistance_integral(tube.field);
    EXPECT_NEAR(resistance_integral(tube.nodes), exact, 1e-12 * exact);
    ASSERT_FALSE(tube.nodes.resisting.empty());
    EXPECT_TRUE(std::is_sorted(tube.nodes.resisting.begin(), tube.nodes.resisting.end()));
    for (const std::int64_t node : tube.nodes.resisting) {
        const auto& [i, j, k] = place_of(tube.nodes.grid, node);
        EXPECT_EQ(tube.type({i, j, k}), fluid);
        const Vec3 place = tube.nodes.grid.centre(i, j, k);
        // Within the kernel, two nodes, of the sheet z = 3.013 mm + 0.2 x.
        EXPECT_LT(std::abs(place.z() - 3.013e-3 - 0.2 * place.x()), 3.0 * h);
    }
}

// A path from node to node, along axes and diagonals, from one side of the sheet to the other
// passes a resisting node: above the middle of the sheet no column of nodes is free of them.
TEST(LatticeNodes, TheSheetHasNoHoles)
{
    const TubeWithSheet tube;
    std::vector<char> resists(tube.nodes.type.size(), 0);
    for (const std::int64_t node : tube.nodes.resisting)
        resists[static_cast<std::size_t>(node)] = 1;
    for (int j = 0; j < tube.nodes.grid.dims[1]; ++j) {
        for (int i = 0; i < tube.nodes.grid.dims[0]; ++i) {
            const Vec3 place = tube.nodes.grid.centre(i, j, 0);
            if (std::abs(place.x()) > 0.9e-3 || std::abs(place.y()) > 0.9e-3) continue;
            int num_resisting = 0;
            for (int k = 0; k < tube.nodes.grid.dims[2]; ++k)
                num_resisting += resists[tube.nodes.grid.index(i, j, k)];
            // Two layers or more: no diagonal link passes between them.
            EXPECT_GE(num_resisting, 2);
        }
    }
}

TEST(LatticeNodes, TooManyAreRefusedWithTheirNumber)
{
    TubeWithSheet tube;
    tube.field.grid.spacing = 2e-6;
    try {
        make_lattice_nodes(tube.field, tube.vessel, 0);
        FAIL() << "nothing was thrown";
    } catch (const ConfigError& error) {
        const std::string message = error.what();
        EXPECT_NE(message.find("grid.spacing = 0.002 mm gives a lattice of"), std::string::npos)
            << message;
        EXPECT_NE(message.find("at most 5e+08"), std::string::npos) << message;
    }
}

}  // namespace
}  // namespace braidzone
