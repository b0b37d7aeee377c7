#include "core/error.hpp"
#include "core/wall_offset.hpp"
#include "support/shapes.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace braidzone {

TEST(WithWallOffset, WidensATubeByTheOffset)
{
    const TriangleMesh tube = test::tube(2e-3, 10e-3, 96, 40);
    const TriangleMesh moved = with_wall_offset(tube, 0.1e-3);
    for (std::size_t i = 0; i < tube.points.size(); ++i) {
        // The prism's corners lie on the circle, and their normals along its radii, by symmetry;
        // at the rims the two diagonals tilt them by less than half the corner's angle.
        EXPECT_NEAR(std::hypot(moved.points[i].x(), moved.points[i].y()), 2.1e-3, 1e-7);
        EXPECT_DOUBLE_EQ(moved.points[i].z(), tube.points[i].z());
    }
}

// Angle weights make the normal at a box's corner its diagonal, however the faces are cut.
TEST(WithWallOffset, MovesABoxCornerAlongItsDiagonal)
{
    const TriangleMesh moved = with_wall_offset(test::unit_box(), -std::sqrt(3.0) * 0.1);
    for (std::size_t i = 0; i < moved.points.size(); ++i) {
        const Vec3 expected = test::unit_box().points[i] * 0.8 + Vec3::Constant(0.1);
        EXPECT_LT((moved.points[i] - expected).norm(), 1e-12) << i;
    }
}

TEST(WithWallOffset, RefusesAnOffsetThatIsNoNumber)
{
    EXPECT_THROW(with_wall_offset(test::unit_box(), std::nan("")), InputError);
}

}  // namespace braidzone
