#include "discrepancy/error_model.hpp"
#include "discrepancy/planned_measurement.hpp"
#include "support/devices.hpp"
#include "support/shapes.hpp"

#include <gtest/gtest.h>

namespace braidzone {
namespace {

/// A device in a straight tube.
const Simulation& simulation()
{
    static const Simulation result = [] {
        Vessel vessel = test::tube_vessel(1.85e-3, 16e-3);
        WallTree wall(vessel);
        const Lumen lumen{std::move(vessel), std::move(wall),
                          test::tube_centerline(1.85e-3, 16e-3)};
        Model model;
        model.device = test::pipeline_4x20();
        model.device.nominal_length = 8e-3;
        model.landing_distal = 13e-3;
        return simulate(model, lumen);
    }();
    return result;
}

}  // namespace

// Points on the device's surface, seen as the case says it is seen, leave no residual.
TEST(PlannedObservations, AgreeWithTheCase)
{
    Imaging imaging;
    for (const double size : {0.0, 1.0}) {
        imaging.blooming = size * 0.1e-3;
        imaging.shift = size * Vec3(0.2e-3, -0.1e-3, 0.3e-3);
        imaging.rotation = size * Vec3(0.02, 0.01, -0.03);
        imaging.pivot = size * Vec3(1e-3, 2e-3, 8e-3);
        const Observations planned = planned_observations(simulation(), imaging);
        EXPECT_GT(planned.field.patches.size(), 80u);
        const Eigen::VectorXd left =
            residuals(planned, simulation(), imaging, simulation().surface);
        // Normals of triangles and of the surface between crossings differ by a few degrees.
        EXPECT_LT(left.cwiseAbs().maxCoeff(), 1e-6);
    }
}

// Variance of a mean: sd^2 / n, with ends known to 0.3 mm.
TEST(PlannedObservations, HaveThePlannedNoise)
{
    const Observations planned = planned_observations(
        simulation(), {}, {.point_sd = 0.05e-3, .points_per_patch = 10, .end_sd = 0.2e-3});
    NoiseFloor floor;
    floor.white_scale = 1.0;
    const ErrorModel error = make_error_model(planned, floor);
    const Eigen::Index middle = error.num_patches / 2;
    EXPECT_EQ(planned.field.patches[static_cast<std::size_t>(middle)].points.size(), 10u);
    EXPECT_NEAR(error.white[middle], 0.05e-3 * 0.05e-3 / 10.0, 1e-13);
    EXPECT_DOUBLE_EQ(error.white[error.num_patches], 0.2e-3 * 0.2e-3);
    EXPECT_EQ(residual_rows(planned).num_lengths, 2);
    const ResidualRows rows = residual_rows(planned);
    const DensityField& density = planned.density;
    // 8 mm and 2 pi 2 mm in squares of 1.5 mm
    EXPECT_EQ(rows.num_density, 5 * 8);
    EXPECT_NEAR(density.places[0].sd / density.scale[0], 0.15, 1e-12);
    const auto& force = planned.scalars.contact_force;
    ASSERT_TRUE(force.has_value());
    EXPECT_NEAR(force->force.sd / force->force.value, 0.15, 1e-12);
}

TEST(PlannedRows, AreThoseThatWereNotMeasured)
{
    Observations measured = planned_observations(simulation(), {});
    measured.scalars.values = {MeasuredValue{13e-3, 0.1e-3}, std::nullopt, std::nullopt};
    measured.scalars.contact_force.reset();
    const Observations planned = with_further_channels(measured, simulation(), {});
    EXPECT_EQ(planned.scalars.values[0]->sd, 0.1e-3);
    EXPECT_EQ(planned.scalars.values[2]->sd, 0.5e-3);
    const PlannedRows rows = planned_rows(measured, planned);
    const auto num_patches = static_cast<std::size_t>(residual_rows(planned).num_patches);
    // patches, the distal end and the density were measured
    EXPECT_EQ(rows.measured.size(), num_patches + 1 + planned.density.places.size());
    ASSERT_EQ(rows.channels.size(), 3u);
    EXPECT_EQ(rows.channels[0].name, "end_markers");
    EXPECT_EQ(rows.channels[0].measurement, "the proximal end to 0.3 mm");
    EXPECT_EQ(rows.channels[0].rows, std::vector<int>{static_cast<int>(num_patches) + 1});
    EXPECT_EQ(rows.channels[1].name, "implanted_length");
    EXPECT_EQ(rows.channels[2].name, "contact_force");
    EXPECT_EQ(rows.channels[2].rows.front(), static_cast<int>(num_residuals(planned)) - 1);
}

}  // namespace braidzone
