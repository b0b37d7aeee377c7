#include "core/error.hpp"
#include "core/triangle_mesh.hpp"
#include "support/shapes.hpp"

#include <gtest/gtest.h>

namespace braidzone {
namespace {

// Half of the cross product of (2, 0, 0) and (0, 3, 0).
TEST(AreaVector, IsHalfTheCrossProductAlongTheNormal)
{
    const TriangleMesh mesh{{Vec3(1, 1, 5), Vec3(3, 1, 5), Vec3(1, 4, 5)}, {{0, 1, 2}, {0, 2, 1}}};
    EXPECT_EQ(area_vector(mesh, 0), Vec3(0, 0, 3));
    EXPECT_EQ(area_vector(mesh, 1), Vec3(0, 0, -3));
}

// A box of 1 x 2 x 3: 2 (2 + 3 + 6) and 6.
TEST(SurfaceArea, OfABoxMatchesHandCalculation)
{
    EXPECT_DOUBLE_EQ(surface_area(test::box(Vec3(0, 0, 0), Vec3(1, 2, 3))), 22.0);
}

TEST(EnclosedVolume, OfABoxMatchesHandCalculation)
{
    EXPECT_DOUBLE_EQ(enclosed_volume(test::box(Vec3(0, 0, 0), Vec3(1, 2, 3))), 6.0);
}

TEST(EnclosedVolume, DoesNotDependOnThePlace)
{
    const Vec3 far(1e3, -2e3, 5e3);
    // The coordinates are rounded at 1e3 * 2e-16.
    EXPECT_NEAR(enclosed_volume(test::box(far, far + Vec3(1, 2, 3))), 6.0, 1e-10);
}

TEST(EnclosedVolume, IsNegativeIfTheNormalsPointInwards)
{
    TriangleMesh mesh = test::box(Vec3(0, 0, 0), Vec3(1, 2, 3));
    for (auto& corners : mesh.triangles)
        std::swap(corners[0], corners[1]);
    EXPECT_DOUBLE_EQ(enclosed_volume(mesh), -6.0);
}

TEST(BoundingBox, HoldsEveryPoint)
{
    const Box box = bounding_box(TriangleMesh{{Vec3(1, -2, 0), Vec3(-3, 4, 0), Vec3(0, 0, 7)}, {}});
    EXPECT_EQ(box.lower, Vec3(-3, -2, 0));
    EXPECT_EQ(box.upper, Vec3(1, 4, 7));
}

TEST(BoundingBox, OfNoPointsIsRefused)
{
    EXPECT_THROW(bounding_box(TriangleMesh{}), InputError);
}

}  // namespace
}  // namespace braidzone
