// Plane channel flow of Carreau-Yasuda blood against its closed form.

#include "core/carreau_yasuda.hpp"
#include "export/foam_apply.hpp"
#include "external/foam_box_case.hpp"
#include "external/openfoam.hpp"
#include "support/foam_box.hpp"
#include "support/temporary_folder.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

namespace braidzone {
namespace {

constexpr int along = 32, across = 16;
constexpr double stretch = 6.0;         // of the cells, along the channel
constexpr double cell = 1e-3 / across;  // 1 mm high [m]
constexpr double height = across * cell;
constexpr double velocity = 5e-3;  // mean [m/s]
const Fluid blood;

/// The shear rate at which the fluid bears a shear stress: mu(g) g = stress, by bisection.
double shear_rate_at(const CarreauYasuda& fluid, double stress)
{
    double below = 0.0, above = stress / fluid.infinite_shear_viscosity;
    for (int i = 0; i < 100; ++i) {
        const double middle = 0.5 * (below + above);
        (viscosity(fluid, middle) * middle < stress ? below : above) = middle;
    }
    return 0.5 * (below + above);
}

/// Mean velocity between two plates under a pressure gradient G: the stress is G y at y from the
/// middle, and the mean is the integral of y g(G y) over the half height H/2, divided by it.
double mean_velocity(const CarreauYasuda& fluid, double gradient)
{
    const int steps = 2000;
    const double step = 0.5 * height / steps;
    double integral = 0.0;
    for (int i = 0; i < steps; ++i) {
        const double y = (i + 0.5) * step;
        integral += y * shear_rate_at(fluid, gradient * y) * step;
    }
    return integral / (0.5 * height);
}

double gradient_for(const CarreauYasuda& fluid, double mean)
{
    double below = 0.0, above = 1e6;
    for (int i = 0; i < 100; ++i) {
        const double middle = 0.5 * (below + above);
        (mean_velocity(fluid, middle) < mean ? below : above) = middle;
    }
    return 0.5 * (below + above);
}

// A check of the closed form itself: a Newtonian fluid needs 12 mu v / H^2.
TEST(ChannelOfCarreauYasuda, IsPoiseuillesForANewtonianFluid)
{
    CarreauYasuda newtonian;
    newtonian.zero_shear_viscosity = newtonian.infinite_shear_viscosity;
    EXPECT_NEAR(gradient_for(newtonian, velocity) /
                    (12.0 * newtonian.infinite_shear_viscosity * velocity / (height * height)),
                1.0, 1e-5);
}

// A Reynolds number of about 1: the flow is developed after some channel heights of the twelve.
TEST(OpenFoamRheology, ChannelLosesThePressureOfTheClosedForm)
{
    if (!test::has_openfoam()) GTEST_SKIP() << "simpleFoam is not installed";
    const test::TemporaryFolder temporary;
    const auto& folder = temporary.path();
    FoamMesh mesh = test::foam_box({along, across, 1}, cell);
    for (Vec3& point : mesh.points)
        point.x() *= stretch;
    test::split_patch(mesh, "wall", {"sides", "wall"}, [](const Vec3& centre) {
        return centre.y() > 0.1 * cell && centre.y() < height - 0.1 * cell;
    });
    FoamFlow flow;
    flow.inlet_velocity = velocity;
    flow.rheology = CarreauYasuda{};
    const double area = height * cell;
    test::write_box_case(folder, mesh,
                         {{.name = "inlet", .area = area}, {.name = "outlet", .area = area}}, flow,
                         blood);
    test::add_walls(folder, {"sides"}, "slip");
    // The middle, where the fluid is thickest, comes to rest last.
    for (const char* field : {"p", "U"})
        test::replace_in(folder / "system/fvSolution", std::string(field) + "               1e-05",
                         std::string(field) + " 1e-6");
    ASSERT_TRUE(test::allrun(folder, ""));
    const auto pressure = test::scalar_field(test::latest_time(folder) / "p");
    const auto mean_at = [&](int column) {
        double sum = 0.0;
        for (int j = 0; j < across; ++j)
            sum += pressure[static_cast<std::size_t>(column + along * j)] / across;
        return sum;
    };
    const int first = 18, last = 28;
    const double gradient =
        blood.density * (mean_at(first) - mean_at(last)) / ((last - first) * stretch * cell);
    const double expected = gradient_for(*flow.rheology, velocity);
    const double newtonian = 12.0 * blood.viscosity * velocity / (height * height);
    std::printf("pressure gradient %.5g Pa/m, closed form %.5g, Newtonian %.5g\n", gradient,
                expected, newtonian);
    // Second order, with 16 cells across: some tenths of a percent.
    EXPECT_NEAR(gradient / expected, 1.0, 0.005);
    EXPECT_GT(expected, 1.2 * newtonian);  // else the test would not see the model
}

// Uniform flow, no shear: the solver's viscosity is that of blood at rest, 16 times the Newtonian
// one. The sheet loses a v + b v^2 = 49 + 3.3 Pa all the same.
TEST(OpenFoamRheology, DeviceKeepsItsViscosity)
{
    if (!test::has_openfoam()) GTEST_SKIP() << "simpleFoam is not installed";
    const test::TemporaryFolder temporary;
    const auto& folder = temporary.path();
    constexpr double edge = 0.1e-3;
    FoamFlow flow;
    flow.inlet_velocity = 0.1;
    flow.rheology = CarreauYasuda{};
    const double area = edge * edge;
    test::write_box_case(folder, test::foam_box({40, 1, 1}, edge),
                         {{.name = "inlet", .area = area}, {.name = "outlet", .area = area}}, flow,
                         blood);
    test::let_slip(folder);
    apply_to_foam_case(folder, test::flat_sheet(0, Vec3(20.23 * edge, 0, 0), edge, edge),
                       {.deposit = {.kernel_half_width = 4.0}, .shear_thinning = true});
    ASSERT_TRUE(test::allrun(folder, ""));
    const double pressure =
        blood.density *
        test::last_row(folder / "postProcessing/inletPressure/0/surfaceFieldValue.dat").at(1);
    std::printf("pressure drop %.5g Pa for 52.3 Pa\n", pressure);
    EXPECT_NEAR(pressure / 52.3, 1.0, 0.02);  // 1.1 % is lost in eight cells across
}

}  // namespace
}  // namespace braidzone
