#include "core/error.hpp"
#include "core/line_in_lumen.hpp"
#include "support/bent_tubes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace braidzone {
namespace {

Polyline part_of(const test::UTube& tube, double from, double to, double step)
{
    Polyline line;
    const int num = static_cast<int>(std::lround((to - from) / step));
    for (int i = 0; i <= num; ++i)
        line.points.push_back(tube.axis(from + (to - from) * i / num));
    return line;
}

void append(Polyline& line, const Polyline& more)
{
    line.points.insert(line.points.end(), more.points.begin(), more.points.end());
}

// A line through every 40 degrees of a bend of 6 mm: the straight segments stay in the lumen of
// 1.9 mm, as 6 mm (1 - cos 20 deg) = 0.36 mm, and so does the spline.
TEST(WithPathInLumen, LeavesSparsePointsInABend)
{
    const test::UTube tube{1.9e-3, 6e-3, 4e-3};
    const Vessel vessel = tube.vessel();
    Polyline line = part_of(tube, 0.1e-3, tube.length() - 0.1e-3, 4.2e-3);
    const LineInLumen laid = with_path_in_lumen(line, WallTree(vessel));
    EXPECT_EQ(laid.line.points, line.points);
    EXPECT_TRUE(laid.recentred.empty());
}

// 98 degrees of the bend are missing: the segment across them passes 6 mm cos 49 deg = 3.94 mm from
// the bend's centre, where the wall is at 4.1 mm. The spline stays in the lumen, within half a
// radius of its middle.
TEST(WithPathInLumen, RecentresASegmentThatCutsABend)
{
    const test::UTube tube{1.9e-3, 6e-3, 4e-3};
    const Vessel vessel = tube.vessel();
    const double gap = 6e-3 * 98.0 / 180.0 * 3.14159265, middle = 0.5 * tube.length();
    Polyline line = part_of(tube, 0.1e-3, middle - 0.5 * gap, 0.5e-3);
    append(line, part_of(tube, middle + 0.5 * gap, tube.length() - 0.1e-3, 0.5e-3));
    const LineInLumen laid = with_path_in_lumen(line, WallTree(vessel));
    ASSERT_EQ(laid.recentred.size(), 1u);
    EXPECT_GT(laid.recentred[0].share, 0.05);
    EXPECT_LT(laid.recentred[0].share, 0.5);
    EXPECT_NEAR(laid.recentred[0].place.z(), 4e-3 + 3.94e-3, 0.05e-3);
    // The new path is the axis, up to the width of the computed line's tolerance.
    for (const Vec3& point : laid.line.points) {
        if (point.z() < 4e-3) continue;
        EXPECT_NEAR(std::hypot(point.x() - 6e-3, point.z() - 4e-3), 6e-3, 0.05 * 1.9e-3);
        EXPECT_NEAR(point.y(), 0.0, 0.05 * 1.9e-3);
    }
    EXPECT_GT(laid.line.points.size(), line.points.size() + 10);
}

// The whole bend is missing: the way between the legs is 5 mm off the straight segment.
TEST(WithPathInLumen, RefusesASegmentFarFromTheLumensMiddle)
{
    const test::UTube tube{1.9e-3, 6e-3, 10e-3};
    const Vessel vessel = tube.vessel();
    Polyline line = part_of(tube, 0.1e-3, 6e-3, 0.5e-3);
    append(line, part_of(tube, tube.length() - 6e-3, tube.length() - 0.1e-3, 0.5e-3));
    try {
        with_path_in_lumen(line, WallTree(vessel));
        FAIL() << "accepted";
    } catch (const GeometryError& error) {
        const std::string text = error.what();
        EXPECT_NE(text.find("between (0, 0, 6) mm and (12, 0, 6) mm the centerline passes through "
                            "the wall, at (1.9, 0, 6) mm"),
                  std::string::npos)
            << text;
        EXPECT_NE(text.find("at most 0.5 is re-centred"), std::string::npos) << text;
    }
}

// Radii are those of the file where there are any; new points have the distance to the wall.
TEST(WithPathInLumen, GivesNewPointsTheirRadii)
{
    const test::UTube tube{1.9e-3, 6e-3, 4e-3};
    const Vessel vessel = tube.vessel();
    const double middle = 0.5 * tube.length();
    Polyline line = part_of(tube, 0.1e-3, middle - 5.2e-3, 0.5e-3);
    append(line, part_of(tube, middle + 5.2e-3, tube.length() - 0.1e-3, 0.5e-3));
    line.inscribed_radii.assign(line.points.size(), 1e-3);
    const LineInLumen laid = with_path_in_lumen(line, WallTree(vessel));
    ASSERT_EQ(laid.line.points.size(), laid.line.inscribed_radii.size());
    EXPECT_EQ(std::count(laid.line.inscribed_radii.begin(), laid.line.inscribed_radii.end(), 1e-3),
              static_cast<std::ptrdiff_t>(line.points.size()));
    EXPECT_NEAR(
        *std::max_element(laid.line.inscribed_radii.begin(), laid.line.inscribed_radii.end()),
        1.9e-3, 0.02e-3);
}

}  // namespace
}  // namespace braidzone
