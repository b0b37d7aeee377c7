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
// near the wall and may be off by a fraction of the spacing where parts of the wall are equally
// far.
TEST(VoxelWallDistance, AgreesWithTheWallTree)
{
    const Vessel vessel = bent_tube();
    const WallTree tree(vessel);
    const VoxelGrid grid = grid_around(vessel, 0.1e-3);
    const std::vector<float> distances = voxel_wall_distance(grid, vessel);
    ASSERT_EQ(distances.size(), grid.num_voxels());
    double largest_error_near_wall = 0.0, largest_error = 0.0;
    int wrong_sides = 0;
    for (int k = 0; k < grid.dims[2]; k += 2) {
        for (int j = 0; j < grid.dims[1]; j += 3) {
            for (int i = 0; i < grid.dims[0]; ++i) {
                const Vec3 centre = grid.centre(i, j, k);
                const double distance = distances[grid.index(i, j, k)];
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
    EXPECT_LT(largest_error, 0.1 * grid.spacing);
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
    const std::vector<float> distances = voxel_wall_distance(grid, vessel);
    const double apothem = radius * std::cos(std::numbers::pi / 48);
    for (int k = 6; k < 20; ++k) {  // centres from z = 0.05 mm on
        const double on_axis = distances[grid.index(20, 20, k)];
        EXPECT_LE(on_axis, -apothem + 1e-9);
        EXPECT_GE(on_axis, -radius - 1e-9);
    }
    for (int k = 0; k < 6; ++k) {  // up to z = -0.05 mm
        const double beyond = distances[grid.index(20, 20, k)];
        EXPECT_GT(beyond, apothem - 1e-9) << k;
    }
}

TEST(VoxelWallDistance, DoesNotDependOnTheNumberOfThreads)
{
    const Vessel vessel = bent_tube();
    const VoxelGrid grid = grid_around(vessel, 0.15e-3);
    const std::vector<float> many = voxel_wall_distance(grid, vessel);
    const tbb::global_control one_thread(tbb::global_control::max_allowed_parallelism, 1);
    EXPECT_EQ(voxel_wall_distance(grid, vessel), many);
}

}  // namespace
}  // namespace braidzone
