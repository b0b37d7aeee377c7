#include "core/error.hpp"
#include "core/line_ends.hpp"
#include "support/bent_tubes.hpp"

#include <gtest/gtest.h>

#include <string>

namespace braidzone {
namespace {

Polyline along_z(double from, double to, int num_points)
{
    Polyline line;
    for (int i = 0; i < num_points; ++i)
        line.points.emplace_back(0.0, 0.0, from + (to - from) * i / (num_points - 1));
    return line;
}

class TrimmedAtOpenings : public testing::Test {
protected:
    TrimmedLine trimmed(const Polyline& line) const
    {
        return trimmed_at_openings(line, vessel, wall);
    }

    void expect_refused(const Polyline& line, const std::string& words) const
    {
        try {
            trimmed(line);
            FAIL() << "not refused: " << words;
        } catch (const GeometryError& error) {
            EXPECT_NE(std::string(error.what()).find(words), std::string::npos) << error.what();
        }
    }

    const Vessel vessel = test::tube_vessel(2e-3, 20e-3, 48, 40);
    const WallTree wall{vessel};
    const int lower = vessel.openings[0].centre.z() < 10e-3 ? 0 : 1;
};

// 0.3 mm beyond at one end, 5 mm at the other; few points count like many.
TEST_F(TrimmedAtOpenings, TakesOffWhatLiesBeyond)
{
    for (const int num_points : {2, 3, 80, 1000}) {
        const TrimmedLine found = trimmed(along_z(-0.3e-3, 25e-3, num_points));
        EXPECT_NEAR(found.first.trimmed, 0.3e-3, 1e-12);
        EXPECT_NEAR(found.last.trimmed, 5e-3, 1e-12);
        EXPECT_EQ(found.first.opening, lower);
        EXPECT_EQ(found.last.opening, 1 - lower);
        EXPECT_NEAR(found.line.points.front().z(), 0.0, 1e-12);
        EXPECT_NEAR(found.line.points.back().z(), 20e-3, 1e-12);
        for (std::size_t i = 1; i < found.line.points.size(); ++i)
            EXPECT_GT(found.line.points[i].z(), found.line.points[i - 1].z());
    }
}

TEST_F(TrimmedAtOpenings, InterpolatesTheRadiiThere)
{
    Polyline line = along_z(-1e-3, 19e-3, 11);  // every 2 mm
    for (int i = 0; i < 11; ++i)
        line.inscribed_radii.push_back(1e-3 + 0.1e-3 * i);
    const TrimmedLine found = trimmed(line);
    ASSERT_EQ(found.line.points.size(), found.line.inscribed_radii.size());
    EXPECT_NEAR(found.line.inscribed_radii[0], 1.05e-3, 1e-12);
    EXPECT_NEAR(found.line.inscribed_radii[1], 1.1e-3, 1e-15);
}

// On the opening, short of it, or beyond it by rounding, 1e-3 of the radius.
TEST_F(TrimmedAtOpenings, LeavesEndsThatLieOnOpeningsOrBeforeThem)
{
    for (const double end : {0.0, 0.2e-3, -2e-6}) {
        const Polyline line = along_z(end, 20e-3 - end, 21);
        const TrimmedLine found = trimmed(line);
        EXPECT_EQ(found.line.points, line.points);
        EXPECT_EQ(found.first.trimmed, 0.0);
        EXPECT_EQ(found.first.opening, lower);
        EXPECT_EQ(found.last.opening, 1 - lower);
    }
    EXPECT_EQ(trimmed(along_z(8e-3, 12e-3, 5)).first.opening, -1);
}

TEST_F(TrimmedAtOpenings, RefusesPointsOutsideElsewhere)
{
    Polyline line = along_z(-1e-3, 21e-3, 23);
    line.points[8].x() = 4e-3;
    line.points[9].x() = 4e-3;
    expect_refused(line,
                   "2 of the centerline's 23 points lie outside the lumen; the first is "
                   "point 8 at (4, 0, 7) mm");
    const Polyline through_the_wall{{Vec3(5e-3, 0, 10e-3), Vec3(0, 0, 10.5e-3), Vec3(0, 0, 20e-3)},
                                    {}};
    expect_refused(through_the_wall, "comes into the lumen through the wall, at (2, 0, 10.3) mm");
    expect_refused(along_z(30e-3, 40e-3, 5), "lies in the lumen");
}

}  // namespace
}  // namespace braidzone
