// A flat sheet of braid across a channel with slip walls, deposited and exported by the code that
// exports devices, solved by OpenFOAM: the pressure drop is that of the closed form.

#include "export/foam_apply.hpp"
#include "export/foam_fluid.hpp"
#include "export/foam_format.hpp"
#include "export/foam_solver.hpp"
#include "export/text_file.hpp"
#include "external/openfoam.hpp"
#include "support/braids.hpp"
#include "support/temporary_folder.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <numbers>

namespace braidzone {
namespace {

constexpr double cell = 0.1e-3;         // [m]
constexpr int across = 16, along = 60;  // cells
constexpr double width = across * cell, length = along * cell;
constexpr double velocity = 0.1;  // [m/s]
const Fluid blood;                // 1056 kg/m^3, 3.5 mPa s
// The reference cell of a 48-wire device: a = 490 Pa s/m, b = 330 Pa s^2/m^2.
const SheetLoss loss{490.0, 330.0};

/// A flat sheet across the channel whose normal is turned by `slant` from the channel's axis (x)
/// towards y. Its middle lies off the cells' centres and faces.
ResistanceSheet sheet_across(double slant, double tangential_ratio)
{
    const Vec3 up(-std::sin(slant), std::cos(slant), 0.0);
    const int count = 20;
    const Vec3 edge_a = up * (width / std::cos(slant) / count);
    const Vec3 edge_b = Vec3::UnitZ() * (width / count);
    const Vec3 middle(0.5 * length + 0.23 * cell, 0.5 * width, 0.0);
    const Vec3 origin = middle - 0.5 * count * edge_a;
    const auto surface = test::flat_braid(origin, edge_a, count, edge_b, count, 30e-6);
    return make_resistance_sheet(surface, ConstantLaw{loss}, blood,
                                 {.tangential_ratio = tangential_ratio});
}

std::string block_mesh()
{
    return foam_header("dictionary", "system", "blockMeshDict") + fmt::format(R"(scale 1;
vertices
(
    (0 0 0) ({0} 0 0) ({0} {1} 0) (0 {1} 0) (0 0 {1}) ({0} 0 {1}) ({0} {1} {1}) (0 {1} {1})
);
blocks ( hex (0 1 2 3 4 5 6 7) ({2} {3} {3}) simpleGrading (1 1 1) );
edges ();
boundary
(
    inlet {{ type patch; faces ((0 4 7 3)); }}
    outlet {{ type patch; faces ((1 2 6 5)); }}
    sides {{ type wall; faces ((0 1 5 4) (3 7 6 2) (0 3 2 1) (4 5 6 7)); }}
);
)",
                                                                              length, width, along,
                                                                              across);
}

std::string channel_control()
{
    return foam_header("dictionary", "system", "controlDict") + fmt::format(R"(
application simpleFoam; startFrom latestTime; startTime 0; stopAt endTime; endTime 2000; deltaT 1;
writeControl timeStep; writeInterval 2000; writeFormat binary; writePrecision 12;
functions
{{
    #includeIfPresent "fdFunctions"
    inletPressure
    {{
        type surfaceFieldValue; libs ("libfieldFunctionObjects.so"); regionType patch; name inlet;
        operation areaAverage; fields (p); writeFields no; log no;
    }}
    deviceForce
    {{
        type forces; libs ("libforces.so"); patches (sides); rho rhoInf; rhoInf {};
        CofR (0 0 0); porosity yes; log no;
    }}
}}
)",
                                                                            blood.density);
}

void write_channel(const std::filesystem::path& folder, FoamForm form)
{
    const auto system = folder / "system", constant = folder / "constant";
    write_text_file(system / "blockMeshDict", block_mesh());
    write_text_file(system / "controlDict", channel_control());
    write_text_file(system / "fvSchemes", fv_schemes());
    write_text_file(system / "fvSolution", fv_solution({.tolerance = 1e-6, .form = form}));
    write_text_file(constant / "transportProperties", transport_properties(blood));
    write_text_file(constant / "turbulenceProperties", turbulence_properties());
    write_text_file(
        folder / "0" / "U",
        foam_header("volVectorField", "0", "U") +
            fmt::format("dimensions [0 1 -1 0 0 0 0]; internalField uniform ({0} 0 0);\n"
                        "boundaryField {{\n"
                        "inlet {{ type fixedValue; value uniform ({0} 0 0); }}\n"
                        "outlet {{ type zeroGradient; }}\nsides {{ type slip; }}\n}}\n",
                        velocity));
    write_text_file(
        folder / "0" / "p",
        foam_header("volScalarField", "0", "p") +
            "dimensions [0 2 -2 0 0 0 0]; internalField uniform 0;\nboundaryField {\n"
            "inlet { type zeroGradient; }\noutlet { type fixedValue; value uniform 0; }\n"
            "sides { type slip; }\n}\n");
}

struct SlabResult {
    double pressure_drop = 0.0;  ///< [Pa]
    double device_force = 0.0;   ///< of the flow on the device, along the channel [N]
    int iterations = -1;
};

SlabResult result_in(const std::filesystem::path& folder, const std::string& start = "0")
{
    SlabResult result;
    result.iterations = test::iterations_to_convergence(folder / "log.simpleFoam");
    result.pressure_drop = blood.density * test::last_row(folder / "postProcessing/inletPressure" /
                                                          start / "surfaceFieldValue.dat")
                                               .at(1);
    // Columns: time, then pressure, viscous and porous force.
    result.device_force =
        test::last_row(folder / "postProcessing/deviceForce" / start / "force.dat").at(10);
    std::printf("%d iterations, dp %.6g Pa, force %.6g N\n", result.iterations,
                result.pressure_drop, result.device_force);
    return result;
}

/// Meshes the channel and applies the sheet.
bool prepare(const std::filesystem::path& folder, const ResistanceSheet& sheet,
             double kernel_half_width, FoamForm form)
{
    write_channel(folder, form);
    if (!test::run_in(folder, "blockMesh", "log.blockMesh")) return false;
    const FoamApplication application = apply_to_foam_case(
        folder, sheet, {.deposit = {.kernel_half_width = kernel_half_width}, .form = form});
    EXPECT_NEAR(application.integral_mesh / application.integral_sheet, 1.0, 1e-12);
    return form != FoamForm::baffles ||
           test::run_in(folder, "createBaffles -overwrite -dict system/fdBaffles",
                        "log.createBaffles");
}

SlabResult solve_slab(const ResistanceSheet& sheet, double kernel_half_width,
                      FoamForm form = FoamForm::zones)
{
    const test::TemporaryFolder temporary;
    const auto& folder = temporary.path();
    if (!prepare(folder, sheet, kernel_half_width, form)) return {};
    if (!test::run_in(folder, "simpleFoam", "log.simpleFoam")) return {};
    return result_in(folder);
}

class OpenFoamSlab : public ::testing::Test {
protected:
    void SetUp() override
    {
        if (!test::has_openfoam()) GTEST_SKIP() << "simpleFoam is not installed";
    }
};

// dp = a v + b v^2 = 490 0.1 + 330 0.01 = 52.3 Pa. The tolerances leave room for the collocated
// scheme's error for a thin layer, which falls with the number of cells across the kernel.
TEST_F(OpenFoamSlab, PressureDropIsThatOfTheClosedForm)
{
    const double expected = loss.linear * velocity + loss.quadratic * velocity * velocity;
    const auto sheet = sheet_across(0.0, 1.0);
    const SlabResult six_cells = solve_slab(sheet, 3.0);
    EXPECT_GT(six_cells.iterations, 0) << "not converged";
    EXPECT_NEAR(six_cells.pressure_drop / expected, 1.0, 0.03);

    const SlabResult eight_cells = solve_slab(sheet, 4.0);
    EXPECT_GT(eight_cells.iterations, 0) << "not converged";
    EXPECT_NEAR(eight_cells.pressure_drop / expected, 1.0, 0.02);
    EXPECT_LT(std::abs(eight_cells.pressure_drop - expected),
              0.7 * std::abs(six_cells.pressure_drop - expected));

    const SlabResult twelve_cells = solve_slab(sheet, 6.0);
    EXPECT_NEAR(twelve_cells.pressure_drop / expected, 1.0, 0.01);
    // Momentum: with slip walls and the same uniform flow at both ends, nothing but the device
    // bears the pressure drop.
    EXPECT_NEAR(eight_cells.device_force / (eight_cells.pressure_drop * width * width), 1.0, 1e-3);
}

// The same tensor in every cell is the same resistance, whether zones or fields hold it; 1e-5 is
// the solver's tolerance.
TEST_F(OpenFoamSlab, FieldsOfTheCellsGiveWhatZonesGive)
{
    for (const double ratio : {1.0, 0.2}) {
        const auto sheet = sheet_across(30.0 * std::numbers::pi / 180.0, ratio);
        const SlabResult zones = solve_slab(sheet, 3.0);
        const SlabResult cells = solve_slab(sheet, 3.0, FoamForm::per_cell);
        EXPECT_GT(cells.iterations, 0) << "not converged";
        EXPECT_NEAR(cells.pressure_drop / zones.pressure_drop, 1.0, 0.002) << ratio;
    }
}

// Stopped after ten iterations and taken up again: the fields of the cells are there, and the
// result is that of the run in one go.
TEST_F(OpenFoamSlab, FieldsOfTheCellsSurviveARestart)
{
    const auto sheet = sheet_across(0.0, 1.0);
    const SlabResult whole = solve_slab(sheet, 3.0, FoamForm::per_cell);
    const test::TemporaryFolder temporary;
    const auto& folder = temporary.path();
    ASSERT_TRUE(prepare(folder, sheet, 3.0, FoamForm::per_cell));
    const auto run_until = [&](const char* time) {
        return test::run_in(folder,
                            std::string("foamDictionary system/controlDict -entry endTime -set ") +
                                time +
                                " && foamDictionary system/controlDict -entry writeInterval "
                                "-set 10 && simpleFoam",
                            "log.simpleFoam");
    };
    ASSERT_TRUE(run_until("10"));
    EXPECT_TRUE(std::filesystem::exists(folder / "10/fdNuD_x"));
    ASSERT_TRUE(run_until("2000"));
    const SlabResult restarted = result_in(folder, "10");
    EXPECT_GT(restarted.iterations, 0) << "not converged";
    EXPECT_NEAR(restarted.pressure_drop / whole.pressure_drop, 1.0, 1e-4);
}

// On faces there is no thickness to smear: a v + b v^2. The residuals of the velocities across,
// which are round-off, never fall; 200 iterations are enough for five digits of the pressure.
TEST_F(OpenFoamSlab, BafflesLoseWhatTheClosedFormSays)
{
    const test::TemporaryFolder temporary;
    const auto& folder = temporary.path();
    ASSERT_TRUE(prepare(folder, sheet_across(0.0, 1.0), 3.0, FoamForm::baffles));
    ASSERT_TRUE(test::run_in(folder,
                             "foamDictionary system/controlDict -entry endTime -set 200 && "
                             "simpleFoam",
                             "log.simpleFoam"));
    EXPECT_NEAR(result_in(folder).pressure_drop / 52.3, 1.0, 1e-4);
}

// Without tangential resistance uniform flow is the exact solution through a slanted sheet too:
// the jump of the pressure is (a + b |U|) U.n with U.n = v cos(30 degrees).
TEST_F(OpenFoamSlab, SlantedSheetResistsTheNormalVelocity)
{
    const double slant = 30.0 * std::numbers::pi / 180.0;
    const double expected = (loss.linear + loss.quadratic * velocity) * velocity * std::cos(slant);
    const SlabResult result = solve_slab(sheet_across(slant, 0.0), 4.0);
    EXPECT_GT(result.iterations, 0) << "not converged";
    EXPECT_NEAR(result.pressure_drop / expected, 1.0, 0.03);
}

}  // namespace
}  // namespace braidzone
