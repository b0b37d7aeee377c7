#include "core/error.hpp"
#include "export/foam_block.hpp"
#include "support/shapes.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace braidzone {
namespace {

TEST(PointInLumen, LiesOnTheAxisOfATube)
{
    const Vessel vessel = test::tube_vessel(2e-3, 20e-3);
    const WallTree wall(vessel);
    const Vec3 point = point_in_lumen(vessel, wall);
    EXPECT_TRUE(wall.contains(point));
    // On the axis, at least a radius from both ends: nowhere is further from every surface.
    EXPECT_LT(Vec2(point.x(), point.y()).norm(), 1e-6);
    EXPECT_GE(std::min(point.z(), 20e-3 - point.z()), 1.9e-3);
}

TEST(BlockAround, ExceedsTheVesselByACellAndHoldsThePointAtAThird)
{
    const Vessel vessel = test::tube_vessel(2e-3, 20e-3);
    const Vec3 inside(0.1e-3, -0.05e-3, 3.21e-3);
    for (const double cell : {0.45e-3, 0.3e-3, 0.117e-3}) {
        const FoamBlock block = block_around(vessel, inside, cell);
        const Box box = bounding_box(vessel.wall);
        const double least = cell * (1.0 - 1e-9);  // round-off
        for (int axis = 0; axis < 3; ++axis) {
            EXPECT_GE(box.lower[axis] - block.lower[axis], least);
            EXPECT_GE(block.upper()[axis] - box.upper[axis], least);
            EXPECT_LT(box.lower[axis] - block.lower[axis], 3.0 * cell);
            const double cells = (inside[axis] - block.lower[axis]) / cell;
            EXPECT_NEAR(cells - std::floor(cells), 1.0 / 3.0, 1e-9);
        }
    }
}

TEST(BlockAround, RefusesCellsWithoutSize)
{
    const Vessel vessel = test::tube_vessel(2e-3, 20e-3);
    EXPECT_THROW(block_around(vessel, Vec3::Zero(), 0.0), InputError);
    EXPECT_THROW(block_around(vessel, Vec3::Zero(), std::nan("")), InputError);
}

}  // namespace
}  // namespace braidzone
