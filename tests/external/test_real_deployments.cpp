// The whole chain, but for the solver, on real vessels.

#include "core/centerline_io.hpp"
#include "support/program.hpp"
#include "support/temporary_folder.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

namespace braidzone {
namespace {

class RealDeployments : public testing::Test {
protected:
    void SetUp() override
    {
        const char* data = std::getenv("BRAIDZONE_EXTERNAL_DATA");
        if (data == nullptr) GTEST_SKIP() << "BRAIDZONE_EXTERNAL_DATA is not set";
        vessels = data;
    }

    /// Runs a case and returns the quantities of its summary; none if it failed.
    nlohmann::json run(const std::string& name, const std::string& case_text) const
    {
        const auto case_file = temporary.path() / (name + ".toml");
        std::ofstream(case_file) << case_text;
        const test::Program program({"run", case_file.string()}, temporary.path());
        EXPECT_EQ(program.wait(), 0) << program.err();
        const auto summary = temporary.path() / (name + ".out") / "summary.json";
        if (!std::filesystem::exists(summary)) return {};
        return nlohmann::json::parse(std::ifstream(summary))["quantities"];
    }

    std::filesystem::path vessels;
    test::TemporaryFolder temporary;
};

double value(const nlohmann::json& quantities, const std::string& name)
{
    return quantities.at(name).at("value").get<double>();
}

void expect_sound(const nlohmann::json& quantities)
{
    EXPECT_EQ(value(quantities, "inverted_rhombi"), 0.0);
    EXPECT_EQ(value(quantities, "nodes_outside_vessel"), 0.0);
    const double surface = value(quantities, "resistance_integral_surface");
    EXPECT_NEAR(value(quantities, "resistance_integral_field"), surface, 1e-6 * surface);
}

std::string in_mm(const Vec3& point)
{
    return fmt::format(R"(["{:.6f} mm", "{:.6f} mm", "{:.6f} mm"])", 1e3 * point.x(),
                       1e3 * point.y(), 1e3 * point.z());
}

}  // namespace

// The device must not end up elsewhere because the centerline was made by another program. The
// distal end lies at one point of the vessel in both runs.
TEST_F(RealDeployments, AgreeBetweenAGivenAndAComputedCenterline)
{
    const auto folder = vessels / "endobeams_sidewall_ica";
    const Centerline given =
        resample(read_centerline(folder / "cl_model.vtk", LengthUnit{"mm", 1e-3}));
    const auto case_text = [&](const std::string& centerline) {
        return fmt::format(R"([vessel]
surface = "{}"
length_unit = "mm"
{}
[device]
name = "pipeline-flex"
diameter = "3.5 mm"
length = "12 mm"
[deployment]
landing_distal = {}
)",
                           (folder / "model.stl").string(), centerline,
                           in_mm(section_at(given, 19e-3).origin));
    };
    const nlohmann::json with_given =
        run("given", case_text("centerline = \"" + (folder / "cl_model.vtk").string() + "\""));
    const nlohmann::json with_computed = run("computed", case_text(""));
    ASSERT_FALSE(with_given.is_null());
    ASSERT_FALSE(with_computed.is_null());
    expect_sound(with_given);
    expect_sound(with_computed);
    for (const std::string name : {"implanted_length", "contact_area_fraction"}) {
        const double reference = value(with_given, name);
        EXPECT_NEAR(value(with_computed, name), reference, 0.03 * reference) << name;
        std::printf("%s: %.4g with the given centerline, %.4g with the computed one\n",
                    name.c_str(), reference, value(with_computed, name));
    }
    // Rings at nominal spacing, 12 mm by the label.
    EXPECT_NEAR(value(with_given, "implanted_length"), 12e-3, 0.1e-3);
}

// A closed surface with flat caps and no centerline, across the neck of a bifurcation aneurysm,
// whose mouth runs into the ostium of the other daughter.
TEST_F(RealDeployments, CrossABifurcationWithoutAGivenCenterline)
{
    const auto surface = vessels / "dolfin_bifurcation" / "aneurysm_boundary_derived.stl";
    const nlohmann::json quantities = run("bifurcation", fmt::format(R"([vessel]
surface = "{}"
length_unit = "mm"
from = 0
to = 1
[device]
name = "pipeline-flex"
diameter = "3 mm"
length = "14 mm"
[deployment]
landing_distal = "35 mm"
)",
                                                                     surface.string()));
    ASSERT_FALSE(quantities.is_null());
    expect_sound(quantities);
    EXPECT_NEAR(value(quantities, "implanted_length"), 14e-3, 0.1e-3);
    EXPECT_FALSE(quantities.at("mean_metal_coverage_neck").is_null());
}

}  // namespace braidzone
