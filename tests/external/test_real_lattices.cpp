// Openings of real vessels, cut across the vessel as they are, continued to the faces of a
// lattice's box.

#include "core/surface_check.hpp"
#include "core/surface_io.hpp"
#include "export/vessel_extension.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>

namespace braidzone {
namespace {

class RealLattices : public testing::Test {
protected:
    void SetUp() override
    {
        const char* data = std::getenv("BRAIDZONE_EXTERNAL_DATA");
        if (data == nullptr) GTEST_SKIP() << "BRAIDZONE_EXTERNAL_DATA is not set";
        vessels = data;
    }

    /// Every opening lies in a face of the box of the whole vessel, and nothing crosses itself.
    void expect_flat(const std::string& file, OpeningFaces faces, std::size_t num_openings) const
    {
        SCOPED_TRACE(file);
        const LengthUnit mm;
        const Vessel vessel = make_vessel(read_surface(vessels / file, mm), mm);
        const ExtendedVessel extended =
            extend_openings(vessel, {.faces = faces, .inlet = 0, .clearance = 0.3e-3});
        EXPECT_TRUE(is_sound(find_defects(extended.vessel.wall)));
        const Box box = bounding_box(extended.vessel.wall);
        ASSERT_EQ(extended.vessel.openings.size(), num_openings);
        for (const Opening& opening : extended.vessel.openings) {
            Eigen::Index axis = 0;
            EXPECT_NEAR(opening.normal.cwiseAbs().maxCoeff(&axis), 1.0, 1e-12);
            const double face = opening.normal[axis] > 0.0 ? box.upper[axis] : box.lower[axis];
            for (const int point : opening.rim)
                EXPECT_NEAR(extended.vessel.wall.points[static_cast<std::size_t>(point)][axis],
                            face, 1e-12);
        }
        EXPECT_GT(enclosed_volume(close_openings(extended.vessel).mesh),
                  enclosed_volume(close_openings(vessel).mesh));
    }

    std::filesystem::path vessels;
};

TEST_F(RealLattices, HaveFlatOpenings)
{
    for (const OpeningFaces faces : {OpeningFaces::extended, OpeningFaces::extended_z}) {
        expect_flat("endobeams_sidewall_ica/model.stl", faces, 2);
        expect_flat("dolfin_bifurcation/aneurysm_boundary_derived.stl", faces, 3);
    }
}

}  // namespace
}  // namespace braidzone
