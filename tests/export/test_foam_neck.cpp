#include "export/foam_neck.hpp"
#include "support/foam_box.hpp"

#include <gtest/gtest.h>

namespace braidzone {
namespace {

/// Area vector of the zone's faces, turned to the zone's side; cubes of edge 1.
Vec3 area(const FoamFaceZone& zone, const FoamMesh& mesh)
{
    Vec3 sum = Vec3::Zero();
    for (std::size_t i = 0; i < zone.faces.size(); ++i) {
        const auto& face = mesh.faces[static_cast<std::size_t>(zone.faces[i])];
        const auto point = [&](std::size_t corner) -> const Vec3& {
            return mesh.points[static_cast<std::size_t>(face[corner])];
        };
        sum += (zone.flipped[i] ? -1.0 : 1.0) * (point(1) - point(0)).cross(point(2) - point(0));
    }
    return sum;
}

// Cells 18 to 26 of a block of 3 x 3 x 3 are its upper layer: nine faces below it, their sum 9 up.
TEST(SacNeck, IsTurnedIntoTheSac)
{
    const FoamMesh mesh = test::foam_box({3, 3, 3}, 1.0);
    std::vector<int> upper, lower;
    for (int cell = 0; cell < 9; ++cell) {
        lower.push_back(cell);
        upper.push_back(18 + cell);
    }
    const FoamFaceZone below = sac_neck("neck", upper, mesh);
    EXPECT_EQ(below.faces.size(), 9U);
    EXPECT_LT((area(below, mesh) - Vec3(0, 0, 9)).norm(), 1e-12);
    EXPECT_LT((area(sac_neck("neck", lower, mesh), mesh) - Vec3(0, 0, -9)).norm(), 1e-12);
    EXPECT_TRUE(sac_neck("neck", {}, mesh).faces.empty());
}

// The upper layer has its roof and the sides in y on the patch "wall"; those in x are openings.
TEST(SacWall, LeavesOpeningsOut)
{
    const FoamMesh mesh = test::foam_box({3, 3, 3}, 1.0);
    std::vector<int> upper;
    for (int cell = 18; cell < 27; ++cell)
        upper.push_back(cell);
    const FoamFaceZone wall = sac_wall("wall", upper, mesh);
    EXPECT_EQ(wall.faces.size(), 9U + 3U + 3U);
    EXPECT_LT((area(wall, mesh) - Vec3(0, 0, 9)).norm(), 1e-12);
    EXPECT_EQ(wall.flipped, std::vector<int>(15, 0));
}

}  // namespace
}  // namespace braidzone
