#include "core/error.hpp"
#include "core/line_frame.hpp"
#include "support/bent_tubes.hpp"

#include <gtest/gtest.h>

#include <string>

namespace braidzone {
namespace {

// A U away from the origin and without a symmetry that one of the frames has.
class SameFrame : public testing::Test {
protected:
    SameFrame()
    {
        TriangleMesh mesh = tube.wall();
        for (Vec3& point : mesh.points)
            point += offset;
        vessel = make_vessel(mesh, LengthUnit{"mm", 1e-3});
    }

    Polyline line() const
    {
        Polyline line;
        for (int i = 0; i <= 60; ++i)
            line.points.push_back(tube.axis(tube.length() * i / 60) + offset);
        return line;
    }

    template <typename Change>
    std::string refusal(const Change& change) const
    {
        Polyline moved = line();
        for (Vec3& point : moved.points)
            point = change(point);
        try {
            require_same_frame({moved}, vessel, WallTree(vessel));
        } catch (const GeometryError& error) {
            return error.what();
        }
        return "";
    }

    const test::UTube tube{1.9e-3, 5e-3, 10e-3};
    const Vec3 offset{30e-3, 41e-3, -17e-3};
    Vessel vessel;
};

TEST_F(SameFrame, AcceptsALineInTheVessel)
{
    EXPECT_EQ(refusal([](const Vec3& point) { return point; }), "");
}

TEST_F(SameFrame, NamesTheFrameThatWouldFit)
{
    struct Frame {
        Vec3 signs;
        double scale;
        std::string words;
    };
    const Frame frames[] = {
        {{-1, -1, 1},
         1.0,
         "with x and y negated it lies in the lumen: one of the two is written "
         "in RAS and the other in LPS coordinates"},
        {{-1, 1, 1}, 1.0, "; with x negated it lies in the lumen: x is mirrored"},
        {{1, -1, 1}, 1.0, "; with y negated it lies in the lumen"},
        {{1, 1, -1}, 1.0, "; with z negated it lies in the lumen"},
        {{1, 1, 1},
         10.0,
         "; divided by 10 it lies in the lumen: its unit of length is not that of "
         "the surface, and length_unit holds for both"},
        {{1, 1, 1}, 0.1, "; multiplied by 10 it"},
        {{1, 1, 1}, 1e3, "; divided by 1000 it"},
        {{1, 1, 1}, 1e-3, "; multiplied by 1000 it"},
        {{1, 1, 1}, 1.0 / 25.4, "; multiplied by 25.4 it"},
        {{1, 1, 1}, 25.4, "; divided by 25.4 it"},
        {{-1, -1, 1}, 1e-3, "with x and y negated and multiplied by 1000 it lies in the lumen"},
    };
    for (const Frame& frame : frames) {
        const std::string text = refusal([&](const Vec3& point) -> Vec3 {
            return frame.scale * frame.signs.cwiseProduct(point);
        });
        EXPECT_NE(text.find(frame.words), std::string::npos) << frame.words << "\n" << text;
    }
}

TEST_F(SameFrame, SaysSoWhereNoneFits)
{
    const std::string text =
        refusal([](const Vec3& point) -> Vec3 { return point + Vec3(0, 9e-3, 0); });
    EXPECT_NE(text.find("from (30, 50, -17) mm to (40, 50, -17) mm, lies off the vessel; no change "
                        "of signs or unit"),
              std::string::npos)
        << text;
}

// Lines of branches that the surface does not have are no reason to refuse.
TEST_F(SameFrame, AcceptsOneLineInTheVesselAmongOthers)
{
    Polyline off = line();
    for (Vec3& point : off.points)
        point.y() += 9e-3;
    EXPECT_NO_THROW(require_same_frame({off, line()}, vessel, WallTree(vessel)));
}

}  // namespace
}  // namespace braidzone
