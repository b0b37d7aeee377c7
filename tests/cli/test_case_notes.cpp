#include "cli/case_notes.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

namespace braidzone {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// A straight vessel, 4 mm wide.
Centerline vessel_line()
{
    Centerline line;
    line.spacing = 1e-3;
    line.sections.resize(5);
    for (CrossSection& section : line.sections)
        section.inscribed_radius = 2e-3;
    return line;
}

Case plain_case()
{
    Case job;
    job.exports.openfoam = FoamCaseOptions{};
    return job;
}

TEST(UnitSlipNotes, BloodInAnArteryHasNone)
{
    EXPECT_THAT(unit_slip_notes(plain_case(), vessel_line()), IsEmpty());
}

TEST(UnitSlipNotes, NamesWhatIsLikelyASlip)
{
    Case job = plain_case();
    job.fluid.viscosity = 3.5;
    EXPECT_THAT(unit_slip_notes(job, vessel_line()),
                ElementsAre(HasSubstr("fluid.viscosity = 3.5 Pa s")));
    job = plain_case();
    job.fluid.density = 1.056;
    EXPECT_THAT(unit_slip_notes(job, vessel_line()),
                ElementsAre(HasSubstr("fluid.density = 1.056 kg/m^3")));
    job = plain_case();
    job.exports.openfoam->flow.inlet_velocity = 20.0;
    EXPECT_THAT(unit_slip_notes(job, vessel_line()),
                ElementsAre(HasSubstr("export.inlet_velocity = 20 m/s")));
    job = plain_case();
    job.sheet.tangential_ratio = 0.5;
    EXPECT_THAT(unit_slip_notes(job, vessel_line()),
                ElementsAre(HasSubstr("porous.tangential_ratio = 0.5")));
}

// A tenth of 4 mm is 0.4 mm.
TEST(UnitSlipNotes, VoxelsCoarserThanATenthOfTheVessel)
{
    Case job = plain_case();
    job.deposit.spacing = 0.39e-3;
    EXPECT_THAT(unit_slip_notes(job, vessel_line()), IsEmpty());
    job.deposit.spacing = 0.41e-3;
    EXPECT_THAT(unit_slip_notes(job, vessel_line()),
                ElementsAre(HasSubstr("grid.spacing = 0.41 mm is more than a tenth of the vessel's "
                                      "mean diameter of 4 mm")));
}

/// Two rings or more of four nodes around a straight axis, at rest on a radius of 1 mm.
Deployment straight_braid()
{
    Deployment deployment;
    deployment.lattice.num_rings = 4;
    deployment.lattice.nodes_per_ring = 8;
    for (int ring = 0; ring < 4; ++ring) {
        CrossSection section;
        section.origin = Vec3(0.0, 0.0, -0.2e-3 * ring);
        section.tangent = Vec3::UnitZ();
        section.normal = Vec3::UnitX();
        section.binormal = Vec3::UnitY();
        deployment.rings.push_back(section);
        deployment.ring_arc_length.push_back(10e-3 - 0.2e-3 * ring);
        for (int column = 0; column < 8; ++column) {
            const double angle = deployment.lattice.angle(ring, column);
            deployment.nodes.push_back(section.origin +
                                       1e-3 * Vec3(std::cos(angle), std::sin(angle), 0.0));
        }
    }
    return deployment;
}

TEST(InversionNotes, ASoundBraidHasNone)
{
    EXPECT_THAT(inversion_notes(straight_braid(), LengthUnit{}), IsEmpty());
}

// The node of the second ring is carried along the axis beyond the fourth: rhombi turn over there.
TEST(InversionNotes, SaysHowManyAndWhere)
{
    Deployment deployment = straight_braid();
    deployment.nodes[static_cast<std::size_t>(deployment.lattice.node(0, 2))].z() -= 2e-3;
    const auto notes = inversion_notes(deployment, LengthUnit{});
    ASSERT_EQ(notes.size(), 1U);
    EXPECT_THAT(notes.front(), HasSubstr("turned over"));
    EXPECT_THAT(notes.front(), HasSubstr("mm along the centerline"));
}

}  // namespace
}  // namespace braidzone
