#include "core/wall_tree.hpp"
#include "porous/voxel_wall_distance.hpp"
#include "support/shapes.hpp"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <cmath>

namespace braidzone {
namespace {

constexpr double radius = 1.5e-3;
constexpr double length = 6e-3;

/// A tube bent to a quarter of a circle, so that distances differ from voxel to voxel.
Vessel bent_tube()
{
    Vessel vessel = test::tube_vessel(radius, length, 48, 24);
    constexpr double bend_radius = 4e-3;
    const auto bend = [&](const Vec3& p) {
        const double angle = p.z() / bend_radius;
        return Vec3((bend_radius + p.x()) * std::cos(angle), p.y(),
                    (bend_radius + p.x()) * std::sin(angle));
    };
    for (Vec3& point : vessel.wall.points)
        point = bend(point);
    return make_vessel(vessel.wall, vessel.unit);
}

/// Distances with every voxel held.
VoxelWallDistance distance_everywhere(const VoxelGrid& grid, const Vessel& vessel)
{
    CubeMarks all(grid);
    all.mark({0, 0, 0}, {grid.dims[0] - 1, grid.dims[1] - 1, grid.dims[2] - 1});
    return voxel_wall_distance(grid, vessel, all);
}

/// Voxels over the vessel's box and half a millimetre around it.
VoxelGrid grid_around(const Vessel& vessel, double spacing)
{
    const Box box = bounding_box(vessel.wall);
    VoxelGrid grid;
    grid.spacing = spacing;
    grid.origin = box.lower - Vec3::Constant(0.5e-3);
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto i = static_cast<int>(axis);
        grid.dims[axis] =
            static_cast<int>(std::ceil((box.upper[i] - grid.origin[i] + 0.5e-3) / spacing));
    }
    return grid;
}

// The tree of boxes answers one point at a time, independently of the grid. Propagation is exact
// near the wall and may be off by a quarter of the spacing where parts of the wall are about
// equally far.
TEST(VoxelWallDistance, AgreesWithTheWallTree)
{
    const Vessel vessel = bent_tube();
    const WallTree tree(vessel);
    const VoxelGrid grid = grid_around(vessel, 0.1e-3);
    const VoxelWallDistance distances = distance_everywhere(grid, vessel);
    double largest_error_near_wall = 0.0, largest_error = 0.0;
    int wrong_sides = 0;
    for (int k = 0; k < grid.dims[2]; k += 2) {
        for (int j = 0; j < grid.dims[1]; j += 3) {
            for (int i = 0; i < grid.dims[0]; ++i) {
                const Vec3 centre = grid.centre(i, j, k);
                const double distance = static_cast<double>(distance_at(distances, i, j, k));
                const double exact = tree.nearest(centre).distance;
                const double error = std::abs(std::abs(distance) - exact);
                largest_error = std::max(largest_error, error);
                if (exact < grid.spacing) {
                    largest_error_near_wall = std::max(largest_error_near_wall, error);
                }
                wrong_sides += (distance < 0.0) != tree.contains(centre);
            }
        }
    }
    EXPECT_EQ(wrong_sides, 0);
    EXPECT_LT(largest_error_near_wall, 1e-6 * grid.spacing);
    EXPECT_LT(largest_error, 0.25 * grid.spacing);
}

// On the axis the wall is the radius away, also where the opening is nearer; beyond the opening is
// no lumen.
TEST(VoxelWallDistance, CapsBoundTheLumenButAreNoWall)
{
    const Vessel vessel = test::tube_vessel(radius, length, 48, 24);
    VoxelGrid grid;
    grid.spacing = 0.1e-3;
    grid.origin = Vec3(-2e-3, -2e-3, -0.55e-3);
    grid.dims = {41, 41, 20};
    const VoxelWallDistance distances = distance_everywhere(grid, vessel);
    const double apothem = radius * std::cos(std::numbers::pi / 48);
    for (int k = 6; k < 20; ++k) {  // centres from z = 0.05 mm on
        const double on_axis = static_cast<double>(distance_at(distances, 20, 20, k));
        EXPECT_LE(on_axis, -apothem + 1e-9);
        EXPECT_GE(on_axis, -radius - 1e-9);
    }
    for (int k = 0; k < 6; ++k) {  // up to z = -0.05 mm
        const double beyond = static_cast<double>(distance_at(distances, 20, 20, k));
        EXPECT_GT(beyond, apothem - 1e-9) << k;
    }
}

TEST(VoxelWallDistance, DoesNotDependOnTheNumberOfThreads)
{
    const Vessel vessel = bent_tube();
    const VoxelGrid grid = grid_around(vessel, 0.15e-3);
    const VoxelWallDistance many = voxel_wall_distance(grid, vessel, CubeMarks(grid));
    const tbb::global_control one_thread(tbb::global_control::max_allowed_parallelism, 1);
    const VoxelWallDistance one = voxel_wall_distance(grid, vessel, CubeMarks(grid));
    EXPECT_EQ(one.of_voxels, many.of_voxels);
    EXPECT_EQ(one.of_cubes, many.of_cubes);
}

// Without a device only the cubes that the wall or a cap enters are held, where all is as if every
// voxel were; elsewhere a cube has the side of all its voxels and the distance of its middle, from
// which no voxel's differs by more than half the cube's diagonal.
TEST(VoxelWallDistance, HoldsTheWallAndOneNumberForOtherCubes)
{
    const Vessel vessel = bent_tube();
    const VoxelGrid grid = grid_around(vessel, 0.05e-3);
    const VoxelWallDistance all = distance_everywhere(grid, vessel);
    const VoxelWallDistance sparse = voxel_wall_distance(grid, vessel, CubeMarks(grid));
    EXPECT_EQ(all.cubes.held.size(), all.cubes.num_cubes());
    EXPECT_LT(sparse.cubes.held.size(), sparse.cubes.num_cubes());
    const double half_diagonal = 0.5 * 7.0 * std::sqrt(3.0) * grid.spacing;
    for (int k = 0; k < grid.dims[2]; ++k) {
        for (int j = 0; j < grid.dims[1]; ++j) {
            for (int i = 0; i < grid.dims[0]; ++i) {
                const double dense = static_cast<double>(distance_at(all, i, j, k));
                const double found = static_cast<double>(distance_at(sparse, i, j, k));
                ASSERT_EQ(found < 0.0, dense < 0.0);
                ASSERT_NEAR(found, dense, half_diagonal + 0.5 * grid.spacing);
            }
        }
    }
}

// Half the spacing, four times the voxels, because the wall's area counts; the box's volume would
// make it eight.
TEST(VoxelWallDistance, MemoryGrowsWithTheWallsArea)
{
    const Vessel vessel = test::tube_vessel(radius, length, 96, 48);
    std::vector<double> held;
    for (const double spacing : {0.08e-3, 0.04e-3, 0.02e-3}) {
        const VoxelGrid grid = grid_around(vessel, spacing);
        const auto field = voxel_wall_distance(grid, vessel, CubeMarks(grid));
        held.push_back(static_cast<double>(field.of_voxels.size()));
    }
    EXPECT_NEAR(held[1] / held[0], 4.0, 0.5);
    EXPECT_NEAR(held[2] / held[1], 4.0, 0.5);
}

}  // namespace
}  // namespace braidzone
