// A channel with two outlets beside each other: what leaves through each.

#include "external/foam_box_case.hpp"
#include "external/openfoam.hpp"
#include "support/foam_box.hpp"
#include "support/temporary_folder.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

namespace braidzone {
namespace {

constexpr double cell = 0.25e-3;  // [m]
const Fluid blood;

/// 24 x 6 x 9 cells; outlet_1 is the lower six layers of the far end, outlet_2 the upper three.
Vessel forked_channel()
{
    Vessel vessel;
    for (const int layers : {9, 6, 3}) {
        Opening opening;
        opening.area = 6 * layers * cell * cell;
        vessel.openings.push_back(opening);
    }
    return vessel;
}

class OpenFoamOutlets : public ::testing::Test {
protected:
    void SetUp() override
    {
        if (!test::has_openfoam()) GTEST_SKIP() << "simpleFoam is not installed";
    }

    void solve(const FoamFlow& flow)
    {
        FoamMesh mesh = test::foam_box({24, 6, 9}, cell);
        mesh.patches[1].name = "outlet_1";
        test::split_patch(mesh, "outlet_1", {"outlet_2", "patch"},
                          [](const Vec3& centre) { return centre.z() > 6 * cell; });
        test::write_box_case(folder_, mesh, foam_openings(forked_channel(), 0, flow.outlets), flow,
                             blood);
        ASSERT_TRUE(test::allrun(folder_, ""));
        EXPECT_NE(test::file_text(folder_ / "log.Allrun").find("there are no figures"),
                  std::string::npos);
    }

    /// Last value that a function of the case's controlDict wrote.
    double last(const std::string& function) const
    {
        return test::last_row(test::table_of(folder_, function)).at(1);
    }

    test::TemporaryFolder temporary_;
    std::filesystem::path folder_ = temporary_.path();
};

// Areas 2 : 1, so radii sqrt(2) : 1 and shares 2^1.5 : 1 of the inflow 0.25 m/s times the area.
TEST_F(OpenFoamOutlets, MurraysSharesLeave)
{
    FoamFlow flow;
    flow.outlets = MurraySplit{};
    solve(flow);
    const double inflow = 0.25 * 6 * 9 * cell * cell;
    const double smaller = 1.0 / (1.0 + std::pow(2.0, 1.5));
    EXPECT_NEAR(last("inletFlow") / inflow, -1.0, 1e-9);
    EXPECT_NEAR(last("outlet_2Flow") / inflow, smaller, 1e-6);
    EXPECT_NEAR(last("outlet_1Flow") / inflow, 1.0 - smaller, 1e-4);
    std::printf("shares %.6g and %.6g\n", last("outlet_1Flow") / inflow,
                last("outlet_2Flow") / inflow);
}

// At every time, also while the inflow changes; 0.02 s is not at a point of the table.
TEST_F(OpenFoamOutlets, SharesFollowAPulsatileInflow)
{
    FoamFlow flow;
    flow.outlets = OutletShares{{0.25, 0.75}};
    const double area = 6 * 9 * cell * cell;
    flow.waveform = FlowWaveform{{}, {0.0, 0.015, 0.03, 0.05}, {1e-1, 3e-1, 2e-1, 1e-1}};
    for (double& flow_rate : flow.waveform->flow_rates)
        flow_rate *= area;
    flow.cycles = 1;
    solve(flow);
    EXPECT_NEAR(last("inletFlow") / (0.1 * area), -1.0, 1e-6);
    for (const auto& name : {"outlet_1Flow", "outlet_2Flow"}) {
        std::istringstream rows(test::file_text(test::table_of(folder_, name)));
        std::istringstream inlet_rows(test::file_text(test::table_of(folder_, "inletFlow")));
        const double share = name == std::string("outlet_1Flow") ? 0.25 : 0.75;
        int count = 0;
        for (std::string row, inlet_row; std::getline(rows, row);) {
            std::getline(inlet_rows, inlet_row);
            double time = 0.0, out = 0.0, in = 0.0;
            if (!(std::istringstream(row) >> time >> out)) continue;
            std::istringstream(inlet_row) >> time >> in;
            ++count;
            ASSERT_NEAR(out / -in, share, 1e-4) << name << " at " << time << " s";
        }
        EXPECT_GE(count, 200);
    }
}

// The same pressure at every outlet is only an offset: 1056 Pa is 1 m^2/s^2.
TEST_F(OpenFoamOutlets, PressuresAreThoseGiven)
{
    solve({});
    const double base = last("inletPressure");
    const double share = last("outlet_2Flow");
    FoamFlow flow;
    flow.outlets = OutletPressures{{1056.0, 1056.0}};
    solve(flow);
    EXPECT_NEAR(last("inletPressure") - base, 1.0, 1e-4);
    EXPECT_NEAR(last("outlet_2Flow") / share, 1.0, 1e-4);
    // Higher at one outlet: less leaves there.
    flow.outlets = OutletPressures{{0.0, 20.0}};
    solve(flow);
    EXPECT_LT(last("outlet_2Flow"), 0.9 * share);
}

}  // namespace
}  // namespace braidzone
