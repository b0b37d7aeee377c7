#include "core/surface_io.hpp"
#include "core/vessel.hpp"
#include "core/wall_tree.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>

namespace braidzone {
namespace {

/// Real vessels are not part of the repository: their folder is given by the environment.
class RealVessel : public testing::Test {
protected:
    void SetUp() override
    {
        const char* folder = std::getenv("BRAIDZONE_EXTERNAL_DATA");
        if (folder == nullptr) GTEST_SKIP() << "BRAIDZONE_EXTERNAL_DATA is not set";
        folder_ = folder;
    }
    Vessel read(const std::string& name) const
    {
        const LengthUnit mm{"mm", 1e-3};
        return make_vessel(read_surface(folder_ / name, mm), mm);
    }
    std::filesystem::path folder_;
};

// The data's own description: two open ends of 3.58 and 3.42 mm (to a hundredth of a millimetre,
// as mean diameters; the rims are not quite circular).
TEST_F(RealVessel, SidewallAneurysmIsOpenAtBothEnds)
{
    const Vessel vessel = read("endobeams_sidewall_ica/model.stl");
    EXPECT_EQ(vessel.wall.triangles.size(), 10566u);
    EXPECT_EQ(vessel.wall.points.size(), 5333u);
    ASSERT_EQ(vessel.openings.size(), 2u);
    EXPECT_NEAR(2.0 * vessel.openings[0].radius, 3.58e-3, 0.02e-3);
    EXPECT_NEAR(2.0 * vessel.openings[1].radius, 3.42e-3, 0.02e-3);
    EXPECT_TRUE(vessel.notes.empty());
}

// Closed, with three flat caps over openings of 3.4, 3.0 and 3.05 mm; 778.36 mm^3.
TEST_F(RealVessel, BifurcationIsOpenedAtItsCaps)
{
    const Vessel vessel = read("dolfin_bifurcation/aneurysm_boundary_derived.stl");
    ASSERT_EQ(vessel.openings.size(), 3u);
    EXPECT_NEAR(2.0 * vessel.openings[0].radius, 3.4e-3, 0.05e-3);
    EXPECT_NEAR(2.0 * vessel.openings[1].radius, 3.05e-3, 0.05e-3);
    EXPECT_NEAR(2.0 * vessel.openings[2].radius, 3.0e-3, 0.05e-3);
    EXPECT_NEAR(enclosed_volume(close_openings(vessel).mesh), 778.36e-9, 0.01e-9);
}

// A little inside an opening is in the lumen, a little outside is not, and between the two
// nothing is hit.
TEST_F(RealVessel, LumenBeginsAtTheOpenings)
{
    for (const char* name :
         {"endobeams_sidewall_ica/model.stl", "dolfin_bifurcation/aneurysm_boundary_derived.stl"}) {
        const Vessel vessel = read(name);
        const WallTree wall(vessel);
        for (const Opening& opening : vessel.openings) {
            const Vec3 step = 0.1 * opening.radius * opening.normal;
            EXPECT_TRUE(wall.contains(opening.centre - step)) << name;
            EXPECT_FALSE(wall.contains(opening.centre + step)) << name;
            EXPECT_FALSE(wall.first_hit(opening.centre - step, opening.centre + step)) << name;
        }
    }
}

}  // namespace
}  // namespace braidzone
