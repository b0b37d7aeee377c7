#include "core/error.hpp"
#include "export/foam_baffles.hpp"
#include "support/braids.hpp"
#include "support/foam_box.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <set>

namespace braidzone {
namespace {

const Fluid blood;
// D_s = a / mu = 140000 1/m, F_s = 2 b / rho = 0.625.
const SheetLoss loss{490.0, 330.0};

ResistanceSheet flat_sheet(const Vec3& origin, const Vec3& edge_a, const Vec3& edge_b, int count)
{
    return make_resistance_sheet(test::flat_braid(origin, edge_a, count, edge_b, count, 30e-6),
                                 ConstantLaw{loss}, blood);
}

/// A block of 2 mm in cubes of 0.1 mm.
FoamMesh block()
{
    return test::foam_box({20, 20, 20}, 0.1e-3);
}

/// Cells that can be reached from the first one without passing a face of the baffles.
int reachable_cells(const FoamMesh& mesh, const FoamBaffles& baffles)
{
    std::set<int> closed;
    for (const FoamBaffle& group : baffles.groups)
        closed.insert(group.faces.faces.begin(), group.faces.faces.end());
    std::vector<std::vector<int>> beside(mesh.cell_volumes.size());
    for (std::size_t face = 0; face < mesh.neighbour.size(); ++face) {
        if (closed.count(static_cast<int>(face)) > 0) continue;
        beside[static_cast<std::size_t>(mesh.owner[face])].push_back(mesh.neighbour[face]);
        beside[static_cast<std::size_t>(mesh.neighbour[face])].push_back(mesh.owner[face]);
    }
    std::vector<int> reached{0};
    std::set<int> seen{0};
    for (std::size_t next = 0; next < reached.size(); ++next)
        for (const int cell : beside[static_cast<std::size_t>(reached[next])])
            if (seen.insert(cell).second) reached.push_back(cell);
    return static_cast<int>(reached.size());
}

// Between the cell layers 9 and 10 the faces lie in a plane: k = 1, and the coefficients are the
// sheet's. The sheet's middle plane runs through no cell centre, its edges beyond the block.
TEST(MakeBaffles, OnFacesInAPlaneHaveTheSheetsCoefficients)
{
    const auto sheet = flat_sheet(Vec3(-0.1e-3, -0.1e-3, 0.98e-3), 0.22e-3 * Vec3::UnitX(),
                                  0.22e-3 * Vec3::UnitY(), 10);
    const FoamMesh mesh = block();
    const FoamBaffles baffles = make_baffles(sheet, mesh, 5);
    EXPECT_NEAR(baffles.step_ratio, 1.0, 1e-12);
    double area = 0.0, integral = 0.0;
    std::set<int> faces;
    for (const FoamBaffle& group : baffles.groups) {
        EXPECT_NEAR(group.darcy, 490.0 / 3.5e-3, 1e-6);
        EXPECT_NEAR(group.inertia, 2.0 * 330.0 / 1056.0, 1e-12);
        // Face normals run from the owner, below, upwards, as those of the sheet.
        for (const int flipped : group.faces.flipped)
            EXPECT_EQ(flipped, 0);
        faces.insert(group.faces.faces.begin(), group.faces.faces.end());
        area += group.area;
        integral += group.integral;
    }
    EXPECT_EQ(baffles.groups.size(), 5U);
    EXPECT_EQ(faces.size(), 400U);
    EXPECT_NEAR(area, 4e-6, 1e-16);
    EXPECT_NEAR(integral, 140000.0 * 4e-6, 1e-9);
    EXPECT_EQ(reachable_cells(mesh, baffles), 10 * 400);
}

// A plane at 45 degrees about y through a lattice of cubes is made of steps with sqrt(2) times its
// area. Flow v across it goes through the steps at v / sqrt(2) and must lose a v + b v^2.
TEST(MakeBaffles, MakeUpForTheAreaOfSteps)
{
    const double s = std::numbers::sqrt2;
    const Vec3 up = Vec3(1.0, 0.0, 1.0) / s;
    const auto sheet =
        flat_sheet(Vec3(-0.37e-3, -0.1e-3, -0.43e-3), 0.2e-3 * up, 0.15e-3 * Vec3::UnitY(), 20);
    const FoamMesh mesh = block();
    const FoamBaffles baffles = make_baffles(sheet, mesh, 1);
    ASSERT_EQ(baffles.groups.size(), 1U);
    EXPECT_NEAR(baffles.step_ratio, s, 0.02 * s);
    const double v = 0.1, through = v / s;
    const FoamBaffle& group = baffles.groups.front();
    const double drop =
        (blood.viscosity * group.darcy + 0.5 * blood.density * group.inertia * through) * through;
    EXPECT_NEAR(drop / (490.0 * v + 330.0 * v * v), 1.0, 0.02);
    // No path around the steps: half of the block stays closed.
    EXPECT_LT(reachable_cells(mesh, baffles), 5000);
}

// Two layers a face apart stay two; within one cell they add.
TEST(MakeBaffles, LayersThatOneFaceMeetsAdd)
{
    const auto layer = [](double z) {
        return flat_sheet(Vec3(-0.1e-3, -0.1e-3, z), 0.22e-3 * Vec3::UnitX(),
                          0.22e-3 * Vec3::UnitY(), 10);
    };
    const FoamBaffles both = make_baffles(joined(layer(0.97e-3), layer(1.03e-3)), block(), 1);
    EXPECT_NEAR(both.groups.at(0).darcy, 2.0 * 490.0 / 3.5e-3, 1e-6);
    const FoamBaffles apart = make_baffles(joined(layer(0.97e-3), layer(1.17e-3)), block(), 1);
    EXPECT_NEAR(apart.groups.at(0).darcy, 490.0 / 3.5e-3, 1e-6);
    EXPECT_EQ(apart.groups.at(0).faces.faces.size(), 800U);
}

TEST(MakeBaffles, NoneWhereTheDeviceLiesOnTheWall)
{
    auto sheet =
        flat_sheet(Vec3(0, 0, 1.02e-3), 0.2e-3 * Vec3::UnitX(), 0.2e-3 * Vec3::UnitY(), 10);
    for (double& acting : sheet.acting)
        acting = 0.0;
    EXPECT_TRUE(make_baffles(sheet, block(), 8).groups.empty());
}

TEST(MakeBaffles, RefusesAMeshWithoutFacesAcross)
{
    const auto sheet =
        flat_sheet(Vec3(0, 0, 5e-3), 0.2e-3 * Vec3::UnitX(), 0.2e-3 * Vec3::UnitY(), 10);
    try {
        make_baffles(sheet, block(), 8);
        FAIL();
    } catch (const GeometryError& error) {
        EXPECT_NE(std::string(error.what()).find("no face of the mesh lies across"),
                  std::string::npos);
    }
    EXPECT_THROW(make_baffles(sheet, block(), 0), InputError);
}

TEST(BaffleDict, HasAPairOfPatchesForEachGroup)
{
    FoamBaffle baffle;
    baffle.faces.name = "FD_0003";
    baffle.darcy = 140000.0;
    baffle.inertia = 0.625;
    const std::string text = baffle_dict({baffle});
    for (const char* entry : {"name            FD_0003_front;", "neighbourPatch  FD_0003_back;",
                              "D               140000;", "I               0.625;"})
        EXPECT_NE(text.find(entry), std::string::npos) << entry;
}

}  // namespace
}  // namespace braidzone
