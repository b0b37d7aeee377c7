#include "discrepancy/observations.hpp"
#include "support/straight_device.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

namespace braidzone {
namespace {

constexpr double turn = 2.0 * std::numbers::pi;

Simulation straight_simulation(double radius, double length = 10e-3)
{
    Deployment device = test::straight_device(radius, length);
    DeviceSurface surface(device);
    return {std::move(device), std::move(surface)};
}

/// Points at radius r(angle, z), every tenth of a millimetre.
template <typename Radius>
std::vector<Vec3> cylinder_points(const Radius& radius_at, double from, double to)
{
    std::vector<Vec3> points;
    for (double z = from + 0.05e-3; z < to; z += 0.1e-3) {
        for (int j = 0; j < 48; ++j) {
            const double angle = turn * (j + 0.5) / 48, r = radius_at(angle, z);
            points.emplace_back(r * std::cos(angle), r * std::sin(angle), z);
        }
    }
    return points;
}

/// Outward sagitta of the rhombi, in which distances to a cylinder are uncertain [m].
constexpr double sagitta = 0.018e-3;

}  // namespace

TEST(DiscrepancyField, HasTheGapOfEachPatch)
{
    const Simulation base = straight_simulation(2e-3);
    // 0.1 mm outside over one patch, 3.2 to 4.0 mm and 30 to 60 degrees, else on the surface.
    const auto points = cylinder_points(
        [](double angle, double z) {
            const bool inside = z > 3.2e-3 && z < 4e-3 && angle > turn / 12 && angle < turn / 6;
            return inside ? 2.1e-3 : 2e-3;
        },
        1e-3, 9e-3);
    const DiscrepancyField field = make_discrepancy_field(points, {}, base);
    // 8 mm hold parts of eleven rows of 0.8 mm.
    EXPECT_EQ(field.patches.size(), 11u * 12u);
    for (const Patch& patch : field.patches) {
        const bool inside = patch.row == 4 && patch.column == 1;
        EXPECT_NEAR(patch.gap, (inside ? 0.1e-3 : 0.0) + 0.5 * sagitta, 0.5 * sagitta);
        EXPECT_DOUBLE_EQ(patch.contact_share, 1.0);
        EXPECT_NEAR(patch.arc_length, (patch.row + 0.5) * 0.8e-3, 1e-12);
        // pi / 6 of 2 mm by 0.8 mm
        EXPECT_NEAR(patch.area, 0.8e-3 * turn / 12 * 2e-3, 0.02e-6);
    }
}

TEST(DiscrepancyField, CountsWhatItLeavesOut)
{
    const Simulation base = straight_simulation(2e-3);
    auto points = cylinder_points([](double, double) { return 2e-3; }, 1e-3, 9e-3);
    const auto used = static_cast<int>(points.size());
    points.emplace_back(2e-3, 0.0, 11e-3);   // beyond the rim
    points.emplace_back(4.5e-3, 0.0, 5e-3);  // no device
    points.emplace_back(0.0, 2e-3, 0.6e-3);  // alone in its patch
    const DiscrepancyField field = make_discrepancy_field(points, {}, base);
    EXPECT_EQ(field.num_points, used + 3);
    EXPECT_EQ(field.num_on_rim, 1);
    EXPECT_EQ(field.num_far, 1);
    EXPECT_EQ(field.num_in_sparse, 1);
}

TEST(DiscrepancyField, ScatterIsThatOfTheNormalPoints)
{
    const Simulation base = straight_simulation(2e-3);
    std::mt19937 random(3);
    std::normal_distribution<double> noise(0.0, 0.08e-3);
    const auto points =
        cylinder_points([&](double, double) { return 2e-3 + noise(random); }, 1e-3, 9e-3);
    double sum = 0.0;
    const DiscrepancyField field = make_discrepancy_field(points, {}, base);
    for (const Patch& patch : field.patches)
        sum += patch.point_sd / static_cast<double>(field.patches.size());
    EXPECT_NEAR(sum, 0.08e-3, 0.006e-3);  // 132 patches of about 30 points
}

TEST(PatchGaps, AreThoseOfAnotherSurfaceForTheSamePoints)
{
    const Simulation base = straight_simulation(2e-3), wider = straight_simulation(2.1e-3);
    const auto points = cylinder_points([](double, double) { return 2e-3; }, 1e-3, 9e-3);
    const DiscrepancyField field = make_discrepancy_field(points, {}, base);
    const Eigen::VectorXd gaps = patch_gaps(points, field, {}, wider.surface, base.surface);
    ASSERT_EQ(gaps.size(), static_cast<Eigen::Index>(field.patches.size()));
    for (Eigen::Index i = 0; i < gaps.size(); ++i)
        EXPECT_NEAR(gaps[i], -0.1e-3 + 0.5 * sagitta, 0.5 * sagitta);
}

// A device that ends at 5 mm says nothing of the surface from there on.
TEST(PatchGaps, TakeTheBaseSurfaceBeyondTheEnds)
{
    const Simulation base = straight_simulation(2e-3), shorter = straight_simulation(2.1e-3, 5e-3);
    const auto points = cylinder_points([](double, double) { return 2.3e-3; }, 1e-3, 9e-3);
    const DiscrepancyField field = make_discrepancy_field(points, {}, base);
    const Eigen::VectorXd gaps = patch_gaps(points, field, {}, shorter.surface, base.surface);
    for (std::size_t i = 0; i < field.patches.size(); ++i) {
        const double expected = field.patches[i].arc_length > 5.4e-3 ? 0.3e-3 : 0.2e-3;
        if (std::abs(field.patches[i].arc_length - 5e-3) < 0.9e-3) continue;
        EXPECT_NEAR(gaps[static_cast<Eigen::Index>(i)], expected + 0.5 * sagitta,
                    0.5 * sagitta + 1e-6);
    }
}

// A scan moved by (0.1, 0, 0.3) mm has points beyond the rim, but is misplaced there as elsewhere:
// a point at (x, y) is sqrt((x + 0.1)^2 + y^2) from the axis. The plane that continues the surface
// leans with the rim's normals, by 3 um over the moved distance.
TEST(PatchGaps, OfAMovedScanAreContinuedBeyondTheRim)
{
    const Simulation base = straight_simulation(2e-3);
    const auto points = cylinder_points([](double, double) { return 2e-3; }, 1e-3, 10e-3);
    const DiscrepancyField field = make_discrepancy_field(points, {}, base);
    Imaging imaging;
    imaging.shift = Vec3(0.1e-3, 0.0, 0.3e-3);
    const Eigen::VectorXd gaps = patch_gaps(points, field, imaging, base.surface, base.surface);
    for (std::size_t i = 0; i < field.patches.size(); ++i) {
        std::vector<double> expected;
        for (const int point : field.patches[i].points) {
            const Vec3 moved = points[static_cast<std::size_t>(point)] + imaging.shift;
            expected.push_back(std::hypot(moved.x(), moved.y()) - 2e-3);
        }
        EXPECT_NEAR(gaps[static_cast<Eigen::Index>(i)], median_of(expected) + 0.5 * sagitta,
                    0.5 * sagitta + 3e-6)
            << "at " << field.patches[i].arc_length;
    }
}

TEST(Imaging, MovesTheScanAboutItsPivot)
{
    Imaging imaging;
    imaging.pivot = Vec3(1, 0, 0);
    imaging.rotation = Vec3(0, 0, 0.25 * turn);
    imaging.shift = Vec3(0, 0, 5);
    // (2, 0, 0) is 1 along x from the pivot, a quarter turn about z brings it to (1, 1, 0).
    EXPECT_LT((in_vessel_frame(imaging, Vec3(2, 0, 0)) - Vec3(1, 1, 5)).norm(), 1e-12);
    EXPECT_EQ(in_vessel_frame(Imaging{}, Vec3(1, 2, 3)), Vec3(1, 2, 3));
}

// A quarter turn about z through (1, 0, 0) after one about x: (1, 2, 3) goes to (1, -3, 2), then to
// (4, 0, 2), and by the shift to (4, 0, 7).
TEST(Imaging, MovesOnFromWhereItIs)
{
    const double quarter = 0.5 * std::numbers::pi;
    Imaging imaging;
    imaging.rotation = Vec3(quarter, 0, 0);
    const Imaging moved = moved_on(imaging, Vec3(0, 0, 5), Vec3(0, 0, quarter), Vec3(1, 0, 0));
    EXPECT_LT((in_vessel_frame(moved, Vec3(1, 2, 3)) - Vec3(4, 0, 7)).norm(), 1e-12);
}

TEST(Residuals, EndWithTheScalarsThatWereMeasured)
{
    const Simulation base = straight_simulation(2e-3);
    Observations observations;
    observations.points = cylinder_points([](double, double) { return 2e-3; }, 1e-3, 9e-3);
    observations.field = make_discrepancy_field(observations.points, {}, base);
    observations.scalars.values[0] = {10.2e-3, 0.1e-3};
    observations.scalars.values[2] = {9.7e-3, 0.1e-3};
    Imaging blooming;
    blooming.blooming = 0.05e-3;
    const Eigen::VectorXd all = residuals(observations, base, blooming, base.surface);
    ASSERT_EQ(all.size(), static_cast<Eigen::Index>(observations.field.patches.size()) + 2);
    EXPECT_NEAR(all[0], -0.05e-3 + 0.5 * sagitta, 0.5 * sagitta);
    EXPECT_NEAR(all[all.size() - 2], 0.2e-3, 1e-9);   // the distal end is at 10 mm
    EXPECT_NEAR(all[all.size() - 1], -0.3e-3, 1e-9);  // it is 10 mm long
}

TEST(MedianOf, IsTheMiddle)
{
    std::vector<double> odd = {5.0, 1.0, 3.0}, even = {4.0, 1.0, 3.0, 2.0};
    EXPECT_DOUBLE_EQ(median_of(odd), 3.0);
    EXPECT_DOUBLE_EQ(median_of(even), 2.5);
}

}  // namespace braidzone
