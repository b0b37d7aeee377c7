#include "cli/apposition_notes.hpp"
#include "core/phantom.hpp"
#include "deploy/opening_kind.hpp"
#include "support/devices.hpp"
#include "support/shapes.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace braidzone {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

constexpr double vessel_length = 32e-3;

/// A tube of one radius up to 12 mm, and of another one from 14 mm on.
TriangleMesh widening_tube(double radius, double distal_radius)
{
    TriangleMesh mesh = test::tube(radius, vessel_length, 96, 160);
    for (Vec3& point : mesh.points) {
        const double share = std::clamp((point.z() - 12e-3) / 2e-3, 0.0, 1.0);
        const double factor = 1.0 + share * (distal_radius / radius - 1.0);
        point.x() *= factor;
        point.y() *= factor;
    }
    return mesh;
}

std::vector<std::string> notes_of(const TriangleMesh& mesh, const Centerline& line,
                                  const ReleaseSchedule& schedule = {})
{
    const LengthUnit unit{"mm", 1e-3};
    const Vessel vessel = make_vessel(mesh, unit);
    const WallTree wall(vessel);
    const FlowDiverter device = test::pipeline_4x20();
    const Deployment deployment = deploy(device, line, wall, 26e-3, schedule);
    const std::vector<WallOpening> openings =
        told_apart(find_openings(deployment, wall), deployment, {vessel, wall, line});
    return apposition_notes({device, schedule, deployment, openings}, wall, unit);
}

}  // namespace

// Nearly as wide as the vessel: wires of 4.00 mm in 3.98 mm keep their length to 1 %.
TEST(AppositionNotes, AreNoneForADeviceThatFits)
{
    EXPECT_THAT(notes_of(test::tube(1.99e-3, vessel_length, 96, 160),
                         test::tube_centerline(1.99e-3, vessel_length)),
                IsEmpty());
}

// From 14 mm on the vessel is 4.8 mm wide and the device at most 4 mm: its wires' middle is 0.4 mm
// off the wall at the end, and Pipeline is made in 4.75 and 5 mm.
TEST(AppositionNotes, NameTheGapAndTheSizeThatFits)
{
    const auto notes =
        notes_of(widening_tube(1.99e-3, 2.4e-3), test::tube_centerline(1.99e-3, vessel_length));
    ASSERT_GE(notes.size(), 2U);
    EXPECT_THAT(notes[0],
                AllOf(HasSubstr("where no sac or branch opens, the device touches the wall on"),
                      HasSubstr("at most 0.4 mm"),
                      HasSubstr("the vessel is up to 4.8 mm wide there and the device 4 mm: the "
                                "size of 5 mm would fit")));
    EXPECT_THAT(notes[1], HasSubstr("the distal end of the device does not lie on the wall"));
}

// 3.6 mm: R / R0 = 0.9, L / L0 = sqrt(0.4^2 + 1 - 0.81) / 0.4 = 1.479. The arms at nominal spacing
// are shortened from sqrt(0.4^2 + 1) to sqrt(0.4^2 + 0.81) dR0, by 8.56 %.
TEST(AppositionNotes, NameTheLengthThatWiresOfConstantLengthGive)
{
    const TriangleMesh tube = test::tube(1.8e-3, vessel_length, 96, 160);
    const Centerline line = test::tube_centerline(1.8e-3, vessel_length);
    EXPECT_THAT(notes_of(tube, line),
                ElementsAre(AllOf(HasSubstr("the wires are 8.6 %"), HasSubstr("% shorter"),
                                  HasSubstr("about 29.6 mm long, not 20 mm"))));
    // Where the spacing is the operator's the sentence ends before.
    EXPECT_THAT(notes_of(tube, line, {.windows = {{10e-3, 14e-3, 0.95}}}),
                ElementsAre(AllOf(HasSubstr("% shorter"), Not(HasSubstr("long")))));
}

TEST(AppositionNotes, NameTheBranchThatIsCrossed)
{
    Phantom phantom;
    phantom.segments = {{vessel_length, 0.0, 0.0}};
    phantom.proximal_radius = phantom.distal_radius = 1.99e-3;
    phantom.blend_radius = 0.2e-3;
    PhantomBranch branch;
    branch.position = 16e-3;
    branch.radius = 1e-3;
    branch.length = 8e-3;
    phantom.branches = {branch};
    const PhantomVessel vessel = make_phantom(phantom);
    EXPECT_THAT(notes_of(vessel.wall, resample(vessel.centerline)),
                ElementsAre(HasSubstr("the device crosses the ostium of the branch that leads to "
                                      "opening 2: ")));
}

}  // namespace braidzone
