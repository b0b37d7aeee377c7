#include "export/lattice_stability.hpp"
#include "support/lattices.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

namespace braidzone {
namespace {

using ::testing::HasSubstr;

// The asymmetric lattice: dx = 0.2 mm, D = 1.5e9 and 2.5e9 1/m^2, F = 6144 and 7168 1/m;
// nu = 4e-6 m^2/s. The mean of D weighted with itself is (1.5^2 + 2.5^2) / 4 1e9 = 2.125e9.
const Fluid fluid{1000.0, 4e-3};

TargetStability stability(LatticeTarget target, double peak_velocity = 0.6,
                          double velocity_lu = 0.05)
{
    return stability_of(target, test::asymmetric_lattice(), fluid,
                        {.peak_velocity = peak_velocity, .velocity_lu = velocity_lu});
}

/// Whether a target has nothing to say on a lattice with its proposal, where D grows as 1 / dx.
void expect_stable_as_proposed(const TargetStability& first)
{
    LatticeNodes nodes = test::asymmetric_lattice();
    const double finer = nodes.grid.spacing / first.proposal.spacing;
    nodes.grid.spacing = first.proposal.spacing;
    for (double& darcy : nodes.darcy)
        darcy *= finer;
    for (double& forchheimer : nodes.forchheimer)
        forchheimer *= finer;
    const LatticeFlowOptions flow{first.proposal.peak_velocity, first.proposal.velocity_lu};
    const TargetStability second = stability_of(first.target, nodes, fluid, flow);
    EXPECT_THAT(second.doubts, ::testing::IsEmpty());
    EXPECT_NEAR(second.time_step, first.proposal.time_step, 1e-12);
}

// dt = 1.6667e-5 s: tau = 0.505, a = 0.16667, the density's error 3 0.141667 0.05 = 2.125 %.
TEST(TargetStability, MatchesHandCalculation)
{
    const TargetStability openlb = stability(LatticeTarget::openlb);
    EXPECT_NEAR(openlb.time_step, 1.66667e-5, 1e-10);
    EXPECT_NEAR(openlb.relaxation_time_lu, 0.505, 1e-9);
    EXPECT_NEAR(openlb.largest_drag_lu, 0.166667, 1e-6);
    EXPECT_NEAR(openlb.density_error, 0.02125, 1e-7);
    ASSERT_EQ(openlb.doubts.size(), 1U);
    EXPECT_THAT(openlb.doubts[0], HasSubstr("relaxation time 0.505 is not above 0.51"));
    expect_stable_as_proposed(openlb);
}

// The density allows u = sqrt(0.01 0.6 / (4e-6 2.125e9 2e-4)) = 0.0594, 0.0566 with the reserve;
// with it the spacing may be 3 4e-6 0.0566 / (0.01 0.6 1.05) = 0.1078 mm.
TEST(TargetStability, RaisesTheVelocityBeforeItRefines)
{
    const TargetStability numpy = stability(LatticeTarget::numpy);
    EXPECT_EQ(numpy.proposal.changes, "velocity_lu = 0.0566 and grid.spacing = \"0.108 mm\"");
    expect_stable_as_proposed(numpy);
    // The walls alone bear 0.1: 3 4e-6 0.1 / (0.01 0.6 1.05) = 0.190 mm.
    const TargetStability palabos = stability(LatticeTarget::palabos);
    EXPECT_EQ(palabos.largest_drag_lu, 0.0);
    EXPECT_EQ(palabos.proposal.changes, "velocity_lu = 0.1 and grid.spacing = \"0.19 mm\"");
    expect_stable_as_proposed(palabos);
    // At 0.3 m/s tau is 0.51 and 0.0525 is enough.
    EXPECT_EQ(stability(LatticeTarget::palabos, 0.3).proposal.changes, "velocity_lu = 0.0525");
}

TEST(TargetStability, LeavesWhatIsStable)
{
    const TargetStability palabos = stability(LatticeTarget::palabos, 0.2);
    EXPECT_THAT(palabos.doubts, ::testing::IsEmpty());
    EXPECT_EQ(palabos.proposal.changes, "");
    EXPECT_EQ(palabos.proposal.spacing, 0.2e-3);
    EXPECT_EQ(palabos.proposal.time_step, palabos.time_step);
}

// u_lu = 0.11: a mean of 0.31167 and an error of 10.3 %.
TEST(TargetStability, LowersTheVelocityForTheDensity)
{
    const TargetStability numpy = stability(LatticeTarget::numpy, 0.6, 0.11);
    ASSERT_EQ(numpy.doubts.size(), 1U);
    EXPECT_THAT(numpy.doubts[0], HasSubstr("change the density by 10 %, allowed is 3 %"));
    EXPECT_THAT(numpy.proposal.changes, HasSubstr("velocity_lu = 0.0566"));
    expect_stable_as_proposed(numpy);
}

// LBPM's MRT bears 0.508: tau = 0.5085 at 0.6 m/s with u_lu = 0.085.
TEST(TargetStability, KnowsTheCollisionOfLbpm)
{
    EXPECT_THAT(stability(LatticeTarget::lbpm).doubts[0],
                HasSubstr("relaxation time 0.505 is not above 0.508: its MRT collision"));
    EXPECT_THAT(stability(LatticeTarget::lbpm, 0.6, 0.085).doubts,
                ::testing::Each(::testing::Not(HasSubstr("relaxation"))));
    expect_stable_as_proposed(stability(LatticeTarget::lbpm));
}

// 1 / (3 nu_lu) = 200; a of 240 needs D = 3.6e12 1/m^2.
TEST(TargetStability, KnowsWhatOpenLbsPorosityExpresses)
{
    LatticeNodes nodes = test::asymmetric_lattice();
    nodes.darcy[0] = 3.6e12;
    const TargetStability openlb = stability_of(LatticeTarget::openlb, nodes, fluid, {});
    EXPECT_THAT(openlb.doubts, ::testing::Contains(HasSubstr("a drag of 240 a time step is beyond "
                                                             "what a porosity expresses, 200")));
}

// Its peak is 0.1 in lattice units: dt = 0.1 2e-4 / 0.1 = 2e-4 s, a = 4e-6 2.5e9 2e-4 = 2, b =
// 0.7168: a + 2 b 0.1 = 2.143; tau = 0.5 + 3 3.22e-6 2e-4 / 4e-8 = 0.548. The force needs a peak
// velocity of 4e-6 2.5e9 2e-4 0.1 / (0.9 - 0.14336) = 0.264 m/s, the density 4e-6 2.125e9 2e-4 0.1
// 0.3 / 0.03 = 1.7 m/s, 1.785 with the reserve; then tau needs 3 3.22e-6 0.1 / (0.01 1.785 1.05) =
// 0.0515 mm.
TEST(TargetStability, KnowsHemoFlowsOwnUnits)
{
    const TargetStability hemoflow = stability(LatticeTarget::hemoflow, 0.1);
    EXPECT_NEAR(hemoflow.time_step, 2e-4, 1e-12);
    EXPECT_NEAR(hemoflow.relaxation_time_lu, 0.5483, 1e-6);
    EXPECT_THAT(hemoflow.doubts,
                ::testing::Contains(HasSubstr("its explicit force diverges with a drag of 2.14")));
    EXPECT_EQ(hemoflow.proposal.changes,
              "peak_velocity = \"1.79 m/s\" and grid.spacing = \"0.0515 mm\"");
    expect_stable_as_proposed(hemoflow);
}

TEST(StabilityNotes, NameTargetsThatShareADoubt)
{
    const std::vector<std::string> notes = stability_notes(
        {stability(LatticeTarget::palabos, 0.3), stability(LatticeTarget::walberla, 0.3)});
    ASSERT_EQ(notes.size(), 1U);
    EXPECT_THAT(notes[0], HasSubstr("lattice (palabos, walberla): relaxation time 0.51 is not"));
    EXPECT_THAT(notes[0], HasSubstr("; take velocity_lu = 0.0525"));
}

}  // namespace
}  // namespace braidzone
