#include "core/rounded_ends.hpp"
#include "core/vessel.hpp"
#include "support/shapes.hpp"

#include <gtest/gtest.h>

namespace braidzone {
namespace {

std::vector<RoundedEnd> ends_of(const TriangleMesh& mesh)
{
    Vessel vessel;
    vessel.wall = mesh;
    return rounded_ends(mesh, measured_openings(mesh), WallTree(vessel));
}

TEST(RoundedEnds, OfACapsuleAreItsTwoTips)
{
    const std::vector<RoundedEnd> ends = ends_of(test::capsule(2e-3, 12e-3, 48, 48));
    ASSERT_EQ(ends.size(), 2u);
    for (const RoundedEnd& end : ends) {
        const double side = end.tip.z() > 6e-3 ? 1.0 : -1.0;
        EXPECT_GT(side * end.outwards.z(), 0.9);
        EXPECT_NEAR(end.radius, 2e-3, 0.1e-3);
    }
    EXPECT_LT(ends[0].tip.z() * ends[1].tip.z(), 0.0);
}

TEST(RoundedEnds, OfAnOpenTubeAreNone)
{
    EXPECT_TRUE(ends_of(test::tube(2e-3, 20e-3, 48, 60)).empty());
}

}  // namespace
}  // namespace braidzone
