// A vessel of square cross-section with a sac on it, a flat braid between them: the figures that
// Allrun prints, and what several processes or a stopped run change of them (nothing).

#include "export/foam_apply.hpp"
#include "export/foam_cell_zones.hpp"
#include "export/foam_face_zones.hpp"
#include "external/foam_box_case.hpp"
#include "external/openfoam.hpp"
#include "support/foam_box.hpp"
#include "support/temporary_folder.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <map>
#include <numbers>
#include <sstream>

namespace braidzone {
namespace {

constexpr double cell = 0.25e-3;  // [m]
constexpr std::array<int, 3> size{12, 8, 22};
constexpr double vessel_height = 8 * cell;
constexpr double inlet_area = 8 * 8 * cell * cell;
const Fluid blood;

/// Writes the case and applies the device: a vessel 2 mm high, the braid 0.8 mm above it, the rest
/// a sac.
void write_case(const std::filesystem::path& folder, const FoamFlow& flow)
{
    FoamMesh mesh = test::foam_box(size, cell);
    for (const char* patch : {"inlet", "outlet"})
        test::split_patch(mesh, patch, {std::string(patch) + "_rest", "wall"},
                          [](const Vec3& centre) { return centre.z() > vessel_height; });
    const std::vector<FoamOpening> openings{{.name = "inlet", .area = inlet_area},
                                            {.name = "outlet", .area = inlet_area}};
    test::write_box_case(folder, mesh, openings, flow, blood);
    test::add_walls(folder, {"inlet_rest", "outlet_rest"});
    const auto sheet =
        test::flat_sheet(2, Vec3(0, 0, vessel_height + 0.8e-3), size[0] * cell, size[1] * cell);
    const FoamApplication applied = apply_to_foam_case(folder, sheet);
    ASSERT_EQ(applied.sac_volumes.size(), 1U);
}

constexpr const char* neck_inflow = "inflow through the neck [mL/s]";
constexpr const char* neck_share = "inflow through the neck [% of the parent flow]";
constexpr const char* sac_speed = "mean speed in the sac [mm/s]";
constexpr const char* wall_shear = "mean wall shear stress in the sac [Pa]";

/// The figures again, from the fields at the last iteration.
std::map<std::string, double> figures_of_fields(const std::filesystem::path& folder,
                                                const std::filesystem::path& variant)
{
    const auto time = test::latest_time(variant);
    const auto velocity = test::vector_field(time / "U");
    const auto flux = test::scalar_field(time / "phi");
    const auto sac = read_cell_zones(folder).back();
    const auto faces = read_face_zones(folder);
    const FoamMesh mesh = read_foam_mesh(folder);
    std::map<std::string, double> all;
    for (const int face : faces.at(0).faces)
        all[neck_inflow] += 0.5e6 * std::abs(flux[static_cast<std::size_t>(face)]);
    all[neck_share] = all[neck_inflow] / (1e6 * 0.25 * inlet_area) * 100.0;
    for (const int i : sac.cells)
        all[sac_speed] += 1e3 * velocity[static_cast<std::size_t>(i)].norm() /
                          static_cast<double>(sac.cells.size());
    // Along a plane wall: mu times the velocity along it over half a cell.
    for (const int i : faces.at(1).faces) {
        const auto face = static_cast<std::size_t>(i);
        const auto& corners = mesh.faces[face];
        const auto point = [&](std::size_t k) -> const Vec3& {
            return mesh.points[static_cast<std::size_t>(corners[k])];
        };
        const Vec3 normal = (point(1) - point(0)).cross(point(2) - point(0)).normalized();
        const Vec3& u = velocity[static_cast<std::size_t>(mesh.owner[face])];
        all[wall_shear] += blood.viscosity * (u - u.dot(normal) * normal).norm() / (0.5 * cell) /
                           static_cast<double>(faces.at(1).faces.size());
    }
    return all;
}

class OpenFoamFigures : public ::testing::Test {
protected:
    void SetUp() override
    {
        if (!test::has_openfoam()) GTEST_SKIP() << "simpleFoam is not installed";
    }
    test::TemporaryFolder temporary_;
    std::filesystem::path folder_ = temporary_.path();
};

TEST_F(OpenFoamFigures, AreThoseOfTheFields)
{
    write_case(folder_, {});
    ASSERT_TRUE(test::run_in(folder_, "checkMesh", "log.checkMesh"));
    EXPECT_NE(test::file_text(folder_ / "log.checkMesh").find("Mesh OK"), std::string::npos);
    ASSERT_TRUE(test::allrun(folder_, "--both"));
    const auto with = figures_of_fields(folder_, folder_);
    const auto without = figures_of_fields(folder_, folder_ / "without_device");
    for (const auto& [name, values] : test::figures(folder_)) {
        // OpenFOAM's wall shear stress has the velocity's gradients along the wall, too: zero at a
        // wall, but some percent in cells of this size.
        const double tolerance = name == wall_shear ? 0.05 : 2e-5;
        EXPECT_NEAR(values[0] / without.at(name), 1.0, tolerance) << name;
        EXPECT_NEAR(values[1] / with.at(name), 1.0, tolerance) << name;
        EXPECT_NEAR(values[2], 100.0 * (1.0 - values[1] / values[0]), 0.01) << name;
        EXPECT_LT(values[1], 0.8 * values[0]) << name;
        std::printf("%s: %.4g without, %.4g with\n", name.c_str(), values[0], values[1]);
    }
}

TEST_F(OpenFoamFigures, AreThoseOfOneVariantUntilBothAreSolved)
{
    write_case(folder_, {});
    ASSERT_TRUE(test::allrun(folder_, "--without-device"));
    auto one = test::figures(folder_);
    EXPECT_GT(one.at(sac_speed)[0], 0.0);
    EXPECT_TRUE(std::isnan(one.at(sac_speed)[1]));
    EXPECT_TRUE(std::isnan(one.at(sac_speed)[2]));
    ASSERT_TRUE(test::allrun(folder_, ""));
    auto both = test::figures(folder_);
    EXPECT_EQ(both.at(sac_speed)[0], one.at(sac_speed)[0]);
    EXPECT_GT(both.at(sac_speed)[2], 0.0);
}

/// Largest relative difference of the figures with the device.
double difference(const std::map<std::string, std::array<double, 3>>& a,
                  const std::map<std::string, std::array<double, 3>>& b)
{
    double largest = 0.0;
    for (const auto& [name, values] : a)
        largest = std::max(largest, std::abs(b.at(name)[1] / values[1] - 1.0));
    return largest;
}

TEST_F(OpenFoamFigures, AreTheSameOnTwoProcesses)
{
    write_case(folder_, {});
    test::replace_in(folder_ / "system/fvSolution", "p               1e-05", "p 1e-7");
    test::replace_in(folder_ / "system/fvSolution", "U               1e-05", "U 1e-7");
    ASSERT_TRUE(test::allrun(folder_, ""));
    const auto one = test::figures(folder_);
    const auto speed = test::vector_field(test::latest_time(folder_) / "U");
    ASSERT_TRUE(test::allrun(folder_, "--processes 2"));
    EXPECT_NE(test::file_text(folder_ / "log.simpleFoam").find("nProcs : 2"), std::string::npos);
    // Cut across the longest axis, z.
    EXPECT_NE(test::file_text(folder_ / "system/decomposeParDict").find("n (1 1 2)"),
              std::string::npos);
    EXPECT_FALSE(std::filesystem::exists(folder_ / "processor0"));
    const double figures_differ = difference(one, test::figures(folder_));
    const auto parallel_speed = test::vector_field(test::latest_time(folder_) / "U");
    ASSERT_EQ(parallel_speed.size(), speed.size());
    double worst = 0.0;
    for (std::size_t i = 0; i < speed.size(); ++i)
        worst = std::max(worst, (speed[i] - parallel_speed[i]).norm());
    std::printf("figures differ by %.2g, velocities by %.2g m/s\n", figures_differ, worst);
    EXPECT_LT(figures_differ, 2e-5);
    EXPECT_LT(worst, 1e-5 * 0.25);
}

// Stopped at iteration 40 and, by a higher end, continued; the report of the first part counts.
TEST_F(OpenFoamFigures, AreTheSameAfterASteadyRunIsContinued)
{
    write_case(folder_, {});
    ASSERT_TRUE(test::allrun(folder_, ""));
    const auto straight = test::figures(folder_);
    const std::string control = test::file_text(folder_ / "system/controlDict");
    test::replace_in(folder_ / "system/controlDict", "endTime         3000", "endTime 50");
    test::replace_in(folder_ / "system/controlDict", "writeInterval   200", "writeInterval 40");
    EXPECT_TRUE(test::run_in(folder_, "! sh ./Allrun", "log.stopped"));
    EXPECT_EQ(test::latest_time(folder_).filename(), "40");
    write_text_file(folder_ / "system/controlDict", control);
    ASSERT_TRUE(test::allrun(folder_, "--continue"));
    EXPECT_TRUE(std::filesystem::exists(folder_ / "postProcessing/sacSpeed/0"));
    EXPECT_TRUE(std::filesystem::exists(folder_ / "postProcessing/sacSpeed/40"));
    EXPECT_LT(difference(straight, test::figures(folder_)), 1e-4);
}

FoamFlow pulsatile()
{
    FlowWaveform wave;
    for (int i = 0; i <= 20; ++i) {
        wave.times.push_back(1e-3 * i);
        wave.flow_rates.push_back(0.2 * inlet_area *
                                  (1.0 + 0.5 * std::sin(2.0 * std::numbers::pi * (i % 20) / 20.0)));
    }
    FoamFlow flow;
    flow.waveform = wave;
    flow.cycles = 2;
    return flow;
}

// Of two processes, stopped in the second cycle and continued on them, against one run of one.
TEST_F(OpenFoamFigures, ArePulsatileMeansOnTwoProcessesAfterAStop)
{
    write_case(folder_, pulsatile());
    test::replace_in(folder_ / "system/controlDict", "maxDeltaT       0.0001", "maxDeltaT 5e-4");
    ASSERT_TRUE(test::allrun(folder_, ""));
    const auto straight = test::figures(folder_);
    EXPECT_GT(straight.at(sac_speed)[1], 0.0);

    const std::string control = test::file_text(folder_ / "system/controlDict");
    test::replace_in(folder_ / "system/controlDict", "endTime         0.04", "endTime 0.0305");
    EXPECT_TRUE(test::allrun(folder_, "--processes 2"));
    // Not at the cycle's end: no figure of it.
    EXPECT_TRUE(std::isnan(test::figures(folder_).at(sac_speed)[1]));
    write_text_file(folder_ / "system/controlDict", control);
    ASSERT_TRUE(test::allrun(folder_, "--continue --processes 2"));
    const double differ = difference(straight, test::figures(folder_));
    std::printf("figures differ by %.2g\n", differ);
    EXPECT_LT(differ, 5e-5);  // the linear solvers' tolerance
}

}  // namespace
}  // namespace braidzone
