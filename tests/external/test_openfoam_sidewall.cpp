// The whole chain on the sidewall case: deployed, exported, meshed and solved by OpenFOAM, with and
// without the device.

#include "external/openfoam.hpp"
#include "support/temporary_folder.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <cstdio>

namespace braidzone {
namespace {

TEST(OpenFoamSidewall, DeviceSlowsTheFlowInTheSac)
{
    if (!test::has_openfoam()) GTEST_SKIP() << "simpleFoam is not installed";
    const test::TemporaryFolder temporary;
    const auto output = temporary.path() / "out";
    const std::string case_file = BRAIDZONE_SOURCE_DIR "/cases/sidewall_aneurysm/case.toml";
    ASSERT_TRUE(test::run_in(
        temporary.path(),
        "'" BRAIDZONE_PROGRAM "' run '" + case_file + "' --output '" + output.string() + "'",
        "log.run"));

    const auto foam = output / "openfoam";
    ASSERT_TRUE(test::run_in(foam, "./Allrun --both", "log.Allrun"));
    EXPECT_NE(test::file_text(foam / "log.checkMesh").find("Mesh OK"), std::string::npos);

    // Sums over cells are the sheet's integrals.
    const auto report = nlohmann::json::parse(test::file_text(foam / "fd_export.json"));
    EXPECT_GT(report["resistance_integral_surface"]["value"].get<double>(), 0.0);
    EXPECT_LT(std::abs(report["relative_difference"].get<double>()), 1e-9);
    EXPECT_TRUE(report["warnings"].empty()) << report["warnings"];

    // The sac of the phantom, a sphere of 7 mm, holds 180 mm^3; the part beyond the kernel less.
    const double sac = report["sac_volume"]["value"].get<double>();
    EXPECT_GT(sac, 140e-9);
    EXPECT_LT(sac, 190e-9);

    const int iterations = test::iterations_to_convergence(foam / "log.simpleFoam");
    const int untreated_iterations =
        test::iterations_to_convergence(foam / "log.simpleFoam.without_device");
    EXPECT_GT(iterations, 0) << "not converged with the device";
    EXPECT_GT(untreated_iterations, 0) << "not converged without the device";

    const std::string speed_file = "postProcessing/sacSpeed/0/volFieldValue.dat";
    const double speed = test::last_row(foam / speed_file).at(1);
    const double untreated_speed = test::last_row(foam / "without_device" / speed_file).at(1);
    std::printf(
        "%d cells; mean speed in the sac %.4g m/s untreated (%d iterations), %.4g m/s with "
        "the device (%d iterations)\n",
        report["num_cells"].get<int>(), untreated_speed, untreated_iterations, speed, iterations);
    // Flow diverters of this coverage take more than a third off the sac's mean speed; that nothing
    // passes would be as wrong.
    EXPECT_LT(speed, 0.65 * untreated_speed);
    EXPECT_GT(speed, 0.01 * untreated_speed);

    // The printed figures are those of the function objects. Inflow in mL/s, its part of the parent
    // flow of 0.25 m/s, speed in mm/s, wall shear stress in Pa.
    const auto rows = test::figures(foam);
    const auto& sac_speed = rows.at("mean speed in the sac [mm/s]");
    EXPECT_NEAR(sac_speed[0], 1e3 * untreated_speed, 1e-4 * sac_speed[0]);
    EXPECT_NEAR(sac_speed[1], 1e3 * speed, 1e-4 * sac_speed[1]);
    EXPECT_NEAR(sac_speed[2], 100.0 * (1.0 - speed / untreated_speed), 0.01);
    const auto& inflow = rows.at("inflow through the neck [mL/s]");
    const auto& share = rows.at("inflow through the neck [% of the parent flow]");
    const double parent =
        -test::last_row(foam / "postProcessing/inletFlow/0/surfaceFieldValue.dat").at(1);
    for (const std::size_t variant : {0U, 1U})
        EXPECT_NEAR(share[variant], 100.0 * 1e-6 * inflow[variant] / parent, 1e-4 * share[variant]);
    // The neck of this phantom takes less than a fifth of the flow, the device most of that off.
    EXPECT_LT(share[0], 20.0);
    EXPECT_GT(share[0], 1.0);
    const std::string printed = test::file_text(foam / "log.Allrun");
    for (const auto& [name, values] : rows) {
        EXPECT_GT(values[2], 35.0) << name;
        EXPECT_LT(values[2], 99.0) << name;
        EXPECT_NE(printed.find(fmt::format("{:.4g} %", values[2])), std::string::npos) << name;
        std::printf("%s: %.4g untreated, %.4g with the device\n", name.c_str(), values[0],
                    values[1]);
    }

    // The exact resistance of every cell on the same mesh: 64 zones are within 2 % of it.
    test::replace_in(foam / "braidzone/case.toml", "form = \"zones\"", "form = \"per_cell\"");
    ASSERT_TRUE(test::run_in(foam, "./Allrun", "log.Allrun.per_cell"));
    EXPECT_TRUE(std::filesystem::exists(foam / "0/fdNuD_x"));
    const double exact_speed = test::last_row(foam / speed_file).at(1);
    std::printf("%.4g m/s with the resistance of every cell\n", exact_speed);
    EXPECT_NEAR(speed / exact_speed, 1.0, 0.02);

    // What the solver wrote survives the next run into the same folder.
    const auto solved = test::latest_time(foam).lexically_relative(output) / "U";
    const std::string velocities = test::file_text(output / solved);
    ASSERT_TRUE(test::run_in(
        temporary.path(),
        "'" BRAIDZONE_PROGRAM "' porous '" + case_file + "' --output '" + output.string() + "'",
        "log.porous"));
    EXPECT_EQ(test::file_text(temporary.path() / "out.kept-1" / solved), velocities);
    EXPECT_NE(test::file_text(temporary.path() / "log.porous").find("out.kept-1"),
              std::string::npos);
    EXPECT_FALSE(std::filesystem::exists(foam));
}

}  // namespace
}  // namespace braidzone
