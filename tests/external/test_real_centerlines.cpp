#include "core/centerline_compute.hpp"
#include "core/centerline_io.hpp"
#include "core/surface_io.hpp"
#include "core/vessel.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <limits>
#include <string>
#include <utility>

namespace braidzone {
namespace {

const LengthUnit mm{"mm", 1e-3};

class RealCenterlines : public testing::Test {
protected:
    void SetUp() override
    {
        const char* data = std::getenv("BRAIDZONE_EXTERNAL_DATA");
        if (data == nullptr) GTEST_SKIP() << "BRAIDZONE_EXTERNAL_DATA is not set";
        folder = data;
    }

    Vessel vessel(const char* surface) const
    {
        return make_vessel(read_surface(folder / surface, mm), mm);
    }

    std::filesystem::path folder;
};

double tightest_bend(const Centerline& centerline)
{
    double tightest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 1; i < centerline.sections.size(); ++i) {
        const double turn =
            (centerline.sections[i].tangent - centerline.sections[i - 1].tangent).norm();
        if (turn > 0.0) tightest = std::min(tightest, centerline.spacing / turn);
    }
    return tightest;
}

// The given centerline is VMTK's, from the Voronoi diagram. It runs through the centres of
// inscribed spheres, ours through those of cross-sections; where the lumen is not round they
// differ.
TEST_F(RealCenterlines, AgreesWithVmtkOnATortuousCarotid)
{
    const Vessel carotid = vessel("endobeams_sidewall_ica/model.stl");
    const WallTree wall(carotid);
    const Polyline given = with_inscribed_radii(
        read_centerline(folder / "endobeams_sidewall_ica/cl_model.vtk", mm), wall);
    ASSERT_EQ(carotid.openings.size(), 2u);
    Vec3 from = carotid.openings[0].centre, to = carotid.openings[1].centre;
    const Vec3& start = given.points.front();
    if ((to - start).norm() < (from - start).norm()) std::swap(from, to);

    const auto begin = std::chrono::steady_clock::now();
    const Polyline path = compute_centerline(carotid, wall, from, to);
    const std::chrono::duration<double> time = std::chrono::steady_clock::now() - begin;
    RecordProperty("seconds", std::to_string(time.count()));
    EXPECT_LT(time.count(), 5.0);

    const Centerline computed = resample(path);
    const Centerline reference = resample(given);
    double mean = 0.0;
    for (const CrossSection& section : reference.sections) {
        const double arc_length = nearest_arc_length(computed, section.origin);
        const CrossSection here = section_at(computed, arc_length);
        const double distance = (here.origin - section.origin).norm() / section.inscribed_radius;
        EXPECT_LT(distance, 0.12);
        EXPECT_LT(std::acos(std::min(1.0, here.tangent.dot(section.tangent))), 0.2);
        mean += distance / static_cast<double>(reference.sections.size());
    }
    EXPECT_LT(mean, 0.05);
    const double shared_length = nearest_arc_length(computed, given.points.back()) -
                                 nearest_arc_length(computed, given.points.front());
    EXPECT_NEAR(shared_length, reference.length(), 0.02 * reference.length());
    EXPECT_GT(tightest_bend(computed), 2.5e-3);
}

TEST_F(RealCenterlines, RunsThroughEveryPairOfOpeningsOfABifurcation)
{
    const Vessel bifurcation = vessel("dolfin_bifurcation/aneurysm_boundary_derived.stl");
    const WallTree wall(bifurcation);
    ASSERT_EQ(bifurcation.openings.size(), 3u);
    for (std::size_t a = 0; a < 3; ++a) {
        for (std::size_t b = a + 1; b < 3; ++b) {
            const Opening& from = bifurcation.openings[a];
            const Opening& to = bifurcation.openings[b];
            const Polyline path = compute_centerline(bifurcation, wall, from.centre, to.centre);
            const Centerline centerline = resample(path);
            EXPECT_LT((centerline.sections.front().origin - from.centre).norm(), 1e-9);
            EXPECT_LT((centerline.sections.back().origin - to.centre).norm(), 1e-9);
            const auto smallest =
                std::min_element(path.inscribed_radii.begin(), path.inscribed_radii.end());
            EXPECT_GT(*smallest, 0.5 * to.radius);
            // Radii are smooth: over a radius of path they change by less than a half of it.
            const double step = to.radius;
            for (double s = 0.0; s + step < centerline.length(); s += 0.1 * step) {
                EXPECT_NEAR(section_at(centerline, s + step).inscribed_radius,
                            section_at(centerline, s).inscribed_radius, 0.5 * step);
            }
            EXPECT_GT(tightest_bend(centerline), 1.2e-3);
        }
    }
}

}  // namespace
}  // namespace braidzone
