#include "core/error.hpp"
#include "core/given_centerline.hpp"
#include "core/line_points.hpp"
#include "core/phantom.hpp"
#include "support/bent_tubes.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

namespace braidzone {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

const LengthUnit mm{"mm", 1e-3};

Polyline straight_line(const Vec3& from, const Vec3& to, int num_points)
{
    Polyline line;
    for (int i = 0; i < num_points; ++i)
        line.points.push_back(from + (to - from) * i / (num_points - 1));
    return line;
}

TEST(GivenCenterline, SaysWhatWasTrimmed)
{
    const Vessel vessel = test::tube_vessel(2e-3, 20e-3, 48, 40);
    const int lower = vessel.openings[0].centre.z() < 10e-3 ? 0 : 1;
    const GivenCenterline given = given_centerline(
        {straight_line(Vec3(0, 0, -0.3e-3), Vec3(0, 0, 20.1e-3), 80)}, vessel, WallTree(vessel));
    EXPECT_NEAR(length_of(given.line), 20e-3, 1e-12);
    const std::string first = "beyond opening " + std::to_string(lower);
    EXPECT_THAT(given.notes,
                ElementsAre("trimmed 0.3 mm of the centerline's proximal end, " + first,
                            HasSubstr("trimmed 0.1 mm of the centerline's distal end")));
    EXPECT_NEAR(given.line.inscribed_radii[40], 2e-3, 0.01e-3);
}

TEST(GivenCenterline, LeavesAGoodLineWithoutANote)
{
    const Vessel vessel = test::tube_vessel(2e-3, 20e-3, 48, 40);
    Polyline line = straight_line(Vec3(0, 0, 0), Vec3(0, 0, 20e-3), 21);
    line.inscribed_radii.assign(21, 1.5e-3);
    const GivenCenterline given = given_centerline({line}, vessel, WallTree(vessel));
    EXPECT_EQ(given.line.points, line.points);
    EXPECT_EQ(given.line.inscribed_radii, line.inscribed_radii);
    EXPECT_THAT(given.notes, IsEmpty());
    const GivenCenterline turned =
        given_centerline({line}, vessel, WallTree(vessel), {.reverse = true});
    EXPECT_EQ(turned.line.points.front(), line.points.back());
}

// A vessel with an inlet of 2 mm, daughters of 1.4 mm at 45 degrees, and a side branch of 1 mm;
// lines as VMTK writes them, one from the inlet to each outlet, reaching 0.4 mm beyond.
class LinesOfBranches : public testing::Test {
protected:
    LinesOfBranches()
    {
        Phantom phantom;
        phantom.segments = {{.length = 14e-3}};
        phantom.branches = {{.position = 6e-3, .radius = 1e-3, .length = 8e-3}};
        phantom.bifurcation = PhantomBifurcation{.radius = 1.4e-3, .length = 9e-3};
        vessel = make_vessel(make_phantom(phantom).wall, mm);
        const double half = std::sqrt(0.5);
        tips = {Vec3(14e-3, 0, 0) + 9e-3 * half * Vec3(1, 1, 0),
                Vec3(14e-3, 0, 0) + 9e-3 * half * Vec3(1, -1, 0),
                Vec3(6e-3, 0, 0) + 8e-3 * Vec3(0.5, std::sqrt(0.75), 0)};
        inlet = opening_at(Vec3::Zero());
        for (const Vec3& tip : tips)
            outlets.push_back(opening_at(tip));
    }

    int opening_at(const Vec3& point) const
    {
        for (std::size_t k = 0; k < vessel.openings.size(); ++k) {
            if ((vessel.openings[k].centre - point).norm() < 0.5e-3) return static_cast<int>(k);
        }
        ADD_FAILURE() << "no opening at " << point.transpose();
        return -1;
    }

    Polyline line_to(std::size_t outlet) const
    {
        const Vec3 fork = outlet == 2 ? Vec3(6e-3, 0, 0) : Vec3(14e-3, 0, 0);
        const Vec3 beyond = tips[outlet] + 0.4e-3 * (tips[outlet] - fork).normalized();
        Polyline line = straight_line(Vec3(-0.4e-3, 0, 0), fork, 30);
        const Polyline rest = straight_line(fork, beyond, 30);
        line.points.insert(line.points.end(), rest.points.begin() + 1, rest.points.end());
        return line;
    }

    GivenCenterline given(const std::vector<Polyline>& lines, const LineChoice& choice) const
    {
        return given_centerline(lines, vessel, WallTree(vessel), choice);
    }

    Vessel vessel;
    std::vector<Vec3> tips;
    int inlet = -1;
    std::vector<int> outlets;
};

TEST_F(LinesOfBranches, TheOneBetweenTheStatedOpeningsIsTaken)
{
    const std::vector<Polyline> lines{line_to(0), line_to(1), line_to(2)};
    for (std::size_t k = 0; k < 3; ++k) {
        const GivenCenterline found = given(lines, {.from = inlet, .to = outlets[k]});
        EXPECT_LT((found.line.points.front()).norm(), 0.05e-3);
        EXPECT_LT((found.line.points.back() - tips[k]).norm(), 0.05e-3);
        EXPECT_THAT(found.notes[0], HasSubstr("the file holds 2 other lines, of branches"));
        // The other way round: from the outlet to the inlet.
        const GivenCenterline back = given(lines, {.from = outlets[k], .to = inlet});
        EXPECT_LT((back.line.points.front() - tips[k]).norm(), 0.05e-3);
    }
    EXPECT_LT((given(lines, {.line = 2}).line.points.back() - tips[2]).norm(), 0.05e-3);
}

TEST_F(LinesOfBranches, AreListedWhereTheyAreAmbiguous)
{
    try {
        given({line_to(0), line_to(1), line_to(2)}, {});
        FAIL() << "accepted";
    } catch (const ConfigError& error) {
        const std::string text = error.what();
        EXPECT_THAT(text, HasSubstr("the file holds 3 lines, so vessel.from and vessel.to"));
        for (std::size_t k = 0; k < 3; ++k) {
            // With 0.4 mm beyond either end.
            EXPECT_THAT(text,
                        HasSubstr(std::to_string(k) + ": from opening " + std::to_string(inlet) +
                                  " to opening " + std::to_string(outlets[k]) + ", " +
                                  (k == 2 ? "14.8 mm" : "23.8 mm")));
        }
    }
    EXPECT_THROW(given({line_to(0), line_to(1)}, {.from = inlet, .to = outlets[2]}), ConfigError);
    EXPECT_THROW(given({line_to(0), line_to(1)}, {.line = 2}), InputError);
}

// Merged files hold one cell for each stretch between bifurcations, in any direction; the side
// branch begins at a point within the trunk.
TEST_F(LinesOfBranches, AreJoinedWhereTheyMeet)
{
    const Vec3 side(6e-3, 0, 0), fork(14e-3, 0, 0);
    const std::vector<Polyline> cells{
        reversed(straight_line(Vec3(-0.4e-3, 0, 0), side, 20)), straight_line(side, fork, 20),
        straight_line(fork, tips[0], 20), straight_line(fork, tips[1], 20),
        straight_line(side, tips[2], 20)};
    for (std::size_t k = 0; k < 3; ++k) {
        const GivenCenterline found = given(cells, {.from = inlet, .to = outlets[k]});
        EXPECT_LT((found.line.points.front()).norm(), 0.05e-3);
        EXPECT_LT((found.line.points.back() - tips[k]).norm(), 0.05e-3);
        EXPECT_NEAR(length_of(found.line), k == 2 ? 14e-3 : 23e-3, 0.1e-3);
    }
    const GivenCenterline across = given(cells, {.from = outlets[0], .to = outlets[1]});
    EXPECT_NEAR(length_of(across.line), 18e-3, 0.1e-3);
}

// Both lines lead from one opening of a tube to the other; the first is taken.
TEST(GivenCenterline, OfLinesBetweenTheSameOpeningsTheFirstIsTaken)
{
    const Vessel vessel = test::tube_vessel(2e-3, 20e-3, 48, 40);
    const Polyline first = straight_line(Vec3(0.1e-3, 0, 0), Vec3(0.1e-3, 0, 20e-3), 20);
    const Polyline second = straight_line(Vec3(0, 0, 20e-3), Vec3(0, 0, 0), 20);
    EXPECT_EQ(given_centerline({first, second}, vessel, WallTree(vessel)).line.points,
              first.points);
}

}  // namespace
}  // namespace braidzone
