// A case whose vessel is straightened: the chain deploys where the diagnosis that found it did.

#include "cli/case_file.hpp"
#include "cli/diagnosed_case.hpp"
#include "cli/effect_case.hpp"
#include "cli/pipeline.hpp"
#include "support/temporary_folder.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

namespace braidzone {

TEST(RunChain, DeploysInTheStraightenedVesselAsADiagnosisDoes)
{
    const std::filesystem::path source =
        std::filesystem::path(BRAIDZONE_SOURCE_DIR) / "cases/sidewall_aneurysm";
    const test::TemporaryFolder folder;
    const auto text = [&](const std::string& landing) {
        return "[vessel]\nsurface = \"" + (source / "vessel.stl").string() +
               "\"\nlength_unit = \"mm\"\ncenterline = \"" + (source / "centerline.vtp").string() +
               "\"\nstraightening = { share = 0.5, centre = \"15 mm\", half_width = \"8 mm\" }\n"
               "[device]\nname = \"pipeline-flex\"\ndiameter = \"4 mm\"\nlength = \"20 mm\"\n"
               "[deployment]\nlanding_distal = " +
               landing;
    };
    const Case job = read_case(folder.write("case.toml", text("\"25 mm\"\n")));
    Progress progress(true);
    const Chain chain = run_chain(job, Stage::deploy, progress);

    const Lumen lumen = lumen_of(job);
    const Simulation simulation = simulate(model_of(job, lumen.centerline), lumen);
    // A diagnosis solves for the shape at rest, a run moves there: within 50 nm.
    ASSERT_EQ(simulation.deployment.nodes.size(), chain.deployment.nodes.size());
    for (std::size_t i = 0; i < simulation.deployment.nodes.size(); ++i)
        ASSERT_LT((simulation.deployment.nodes[i] - chain.deployment.nodes[i]).norm(), 50e-9);

    // Half of the turn goes between 11 and 19 mm, where the window is full.
    const auto turn = [](const Centerline& line) {
        return std::acos(section_at(line, 11e-3).tangent.dot(section_at(line, 19e-3).tangent));
    };
    EXPECT_GT(turn(lumen.centerline), 0.1);
    EXPECT_NEAR(turn(chain.centerline), 0.5 * turn(lumen.centerline), 1e-3);

    // A landing point is one of the vessel as its file has it.
    const Vec3 place = 1e3 * section_at(lumen.centerline, 25e-3).origin;
    const Case by_point = read_case(folder.write(
        "by_point.toml", text(fmt::format("[\"{:.9g} mm\", \"{:.9g} mm\", \"{:.9g} mm\"]\n",
                                          place.x(), place.y(), place.z()))));
    EXPECT_NEAR(run_chain(by_point, Stage::deploy, progress).deployment.ring_arc_length.front(),
                25e-3, 1e-6);
}

}  // namespace braidzone
