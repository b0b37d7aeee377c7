// The exported folder in the hands of a lattice-Boltzmann solver: what it reads from the files, and
// nothing else, must give the pressure that the sheet costs and the flow that the walls let
// through. NumPy reads the arrays; the solver is `tests/support/lattice_boltzmann.hpp`.

#include "export/lattice_export.hpp"
#include "export/lattice_nodes.hpp"
#include "porous/porous_field.hpp"
#include "support/braids.hpp"
#include "support/lattice_boltzmann.hpp"
#include "support/steady_flow.hpp"
#include "support/temporary_folder.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <array>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <numbers>
#include <string>
#include <vector>

namespace braidzone {
namespace {

namespace fs = std::filesystem;
using test::DragCell;
using test::LatticeFlow;
using test::PeriodicBox;

constexpr double h = 0.1e-3;
constexpr SheetLoss loss{490.0, 330.0};
constexpr double velocity = 0.1;
constexpr double expected_drop = loss.linear * velocity + loss.quadratic * velocity * velocity;
const Fluid blood;

/// A rectangular duct along y with a sheet across it, no two lengths the same. Its walls lie
/// half-way between nodes, at whole multiples of the spacing along each axis and a half.
struct Duct {
    static constexpr int across_x = 20, along_y = 40, across_z = 14;
    Vec3 lower = h * Vec3(3.5, -7.5, 11.5);
    Vessel vessel;
    ResistanceSheet sheet;

    Duct()
    {
        const Vec3 size = h * Vec3(across_x, along_y, across_z);
        TriangleMesh wall;
        for (int k = 0; k < 8; ++k)
            wall.points.emplace_back(lower + Vec3(k & 1 ? size.x() : 0.0, k & 2 ? size.y() : 0.0,
                                                  k & 4 ? size.z() : 0.0));
        wall.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6},
                          {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
        vessel = make_vessel(wall, LengthUnit{"mm", 1e-3});
        const Vec3 origin = lower + Vec3(0.0, 19.7 * h, 0.0);
        const BraidSurface surface =
            test::flat_braid(origin, Vec3(0, 0, h), across_z, Vec3(h, 0, 0), across_x, 30e-6);
        sheet = make_resistance_sheet(surface, ConstantLaw{loss}, blood);
    }
};

class LatticeFolder : public ::testing::Test {
protected:
    LatticeFolder()
    {
        const PorousField field = deposit(duct.sheet, duct.vessel, {.spacing = h});
        LatticeExportOptions options;
        options.targets = {LatticeTarget::numpy, LatticeTarget::hemoflow};
        // The inlet is the lower end, so that blood flows towards +y.
        options.inlet = duct.vessel.openings[0].normal.y() < 0.0 ? 0 : 1;
        export_lattice(folder.path(), field, duct.vessel, blood, options);
    }

    /// What a Python script prints, run in the folder, as numbers.
    std::vector<double> numbers_of(const std::string& script) const
    {
        std::ofstream(folder.path() / "script.py") << script;
        const std::string command =
            fmt::format("cd '{}' && /usr/bin/python3 script.py > printed", folder.path().string());
        EXPECT_EQ(std::system(command.c_str()), 0) << script;
        std::vector<double> numbers;
        std::ifstream printed(folder.path() / "printed");
        for (double number = 0.0; printed >> number;)
            numbers.push_back(number);
        return numbers;
    }

    nlohmann::json description() const
    {
        return nlohmann::json::parse(std::ifstream(folder.path() / "lattice.json"));
    }

    Duct duct;
    test::TemporaryFolder folder;
};

/// Part of the lattice well inside the duct: four nodes from the walls, where the kernel reaches no
/// solid node, and between the openings. Taken as periodic, the flow through it is plug flow.
const PeriodicBox core{{Duct::across_x - 8, Duct::along_y, Duct::across_z - 8}, 0};

/// Prints the drag of the core's nodes: i j k, then values of each.
std::string core_script(const std::string& load, const std::string& values)
{
    return fmt::format(
        "import json, re, numpy as n\n"
        "{}"
        "w = n.argwhere(flags == 2)\n"
        "x, y, z = w.min(axis=0) + [4, 0, 4]\n"
        "for i in range({}):\n"
        "  for j in range({}):\n"
        "    for k in range({}):\n"
        "      p = (x + i, y + j, z + k)\n"
        "      assert flags[p] == 2\n"
        "      if drag[p] != 0: print(i, j, k, {})\n",
        load, core.dims[0], core.dims[1], core.dims[2], values);
}

/// Pressure drop of the core in lattice units, per density [(dx / dt)^2].
double drop_through_core(const std::vector<DragCell>& drag, double viscosity_lu, double velocity_lu)
{
    LatticeFlow flow(core, {.viscosity_lu = viscosity_lu, .inertia = true}, {}, drag);
    const test::SteadyFlow steady =
        test::drive_to_flux(flow, Vec3::UnitY(), velocity_lu,
                            {.relative_change = 1e-5, .window_steps = 100, .most_steps = 20000});
    EXPECT_TRUE(steady.converged);
    return steady.body_force * core.dims[1];
}

// With the time step, viscosity and resistance of the files, in the convention that lattice.json
// states, flow loses a v + b v^2 = 52.3 Pa.
TEST_F(LatticeFolder, NumpyArraysLoseThePressureOfTheSheet)
{
    const std::vector<double> numbers = numbers_of(
        core_script("flags, drag = n.load('numpy/cell_type.npy'), n.load('numpy/darcy.npy')\n"
                    "f, o = n.load('numpy/forchheimer.npy'), n.load('numpy/normal.npy')\n",
                    "drag[p], f[p], *o[(slice(None), *p)]"));
    const nlohmann::json json = description();
    const double dx = json["spacing_m"], dt = json["units"]["time_step_s"];
    std::vector<DragCell> drag;
    for (std::size_t at = 0; at + 8 <= numbers.size(); at += 8) {
        DragCell cell;
        for (std::size_t axis = 0; axis < 3; ++axis)
            cell.cell[axis] = static_cast<int>(numbers[at + axis]);
        cell.darcy_normal_lu = cell.darcy_tangential_lu = numbers[at + 3] * dx * dx;
        cell.forchheimer_normal_lu = cell.forchheimer_tangential_lu = numbers[at + 4] * dx;
        cell.normal = Vec3(numbers[at + 5], numbers[at + 6], numbers[at + 7]);
        EXPECT_NEAR(std::abs(cell.normal.y()), 1.0, 1e-6);
        drag.push_back(cell);
    }
    const double density = json["fluid"]["density_kg_m3"];
    const double drop = drop_through_core(drag, json["units"]["viscosity_lu"], velocity * dt / dx) *
                        density * std::pow(dx / dt, 2);
    fmt::print("numpy: {:+.3f} %\n", 100.0 * (drop / expected_drop - 1.0));
    EXPECT_NEAR(drop / expected_drop, 1.0, 0.02);
}

// HemoFlow's own units (hemoFlow.cpp:198): 0.05 for the inlet's mean velocity, which the Reynolds
// number gives; lin_lu = w lin dt / (rho dx), quad_lu = w quad / rho.
TEST_F(LatticeFolder, HemoFlowsNumbersLoseThePressureOfTheSheet)
{
    constexpr double viscosity = 3.22e-6, density = 1055.0, velocity_lu = 0.05;
    std::vector<double> numbers =
        numbers_of(core_script("c = n.load('hemoflow/case.npz')\n"
                               "flags, drag = c['geometryFlag'], c['stent']\n"
                               "xml = open('hemoflow/setup.xml').read()\n"
                               "for t in ['Re', 'linCoeff', 'quadCoeff']:\n"
                               "  print(re.search('<' + t + '>(.*)</' + t + '>', xml)[1])\n"
                               "print(c['dx'][0], c['openingRadius'][0])\n",
                               "drag[p]"));
    const double reynolds = numbers[0], linear = numbers[1], quadratic = numbers[2];
    const double dx = numbers[3], radius = numbers[4];
    const double dt = velocity_lu * dx / (reynolds * viscosity / (2.0 * radius));
    const double viscosity_lu = viscosity * dt / (dx * dx);
    std::vector<DragCell> drag;
    for (std::size_t at = 5; at + 4 <= numbers.size(); at += 4) {
        DragCell cell;
        for (std::size_t axis = 0; axis < 3; ++axis)
            cell.cell[axis] = static_cast<int>(numbers[at + axis]);
        const double weight = numbers[at + 3];
        cell.darcy_normal_lu = cell.darcy_tangential_lu =
            weight * linear * dt / (density * dx) / viscosity_lu;
        cell.forchheimer_normal_lu = cell.forchheimer_tangential_lu =
            2.0 * weight * quadratic / density;
        drag.push_back(cell);
    }
    const double drop =
        drop_through_core(drag, viscosity_lu, velocity * dt / dx) * density * std::pow(dx / dt, 2);
    fmt::print("hemoflow: {:+.3f} %\n", 100.0 * (drop / expected_drop - 1.0));
    EXPECT_NEAR(drop / expected_drop, 1.0, 0.02);
}

/// Mean velocity over g / nu of flow through a rectangle (Boussinesq 1868; White, Viscous Fluid
/// Flow, eq. 3-48), narrow side s, wide side w:
///
///     s^2 / 12 (1 - 192 s / (pi^5 w) sum over odd n of tanh(n pi w / (2 s)) / n^5)
double rectangle_permeability(double s, double w)
{
    double sum = 0.0;
    for (int n = 1; n < 40; n += 2)
        sum += std::tanh(n * std::numbers::pi * w / (2.0 * s)) / std::pow(n, 5);
    return s * s / 12.0 * (1.0 - 192.0 * s / (std::pow(std::numbers::pi, 5) * w) * sum);
}

// The node types are the duct: what lies between the walls, half-way to the first nodes that are
// not fluid, is 2.0 mm by 1.4 mm. Slow flow, without the sheet, periodic between the openings.
TEST_F(LatticeFolder, NodeTypesLetThroughTheFlowOfTheDuct)
{
    const std::vector<double> numbers = numbers_of(
        "import numpy as n\n"
        "t = n.load('numpy/cell_type.npy')\n"
        "w = n.argwhere(t == 2)\n"
        "t = t[:, w[:, 1].min():w[:, 1].max() + 1, :]\n"
        "print(*t.shape)\n"
        "print(*(t != 2).astype(int).ravel(order='F'))\n");
    const PeriodicBox box{
        {static_cast<int>(numbers[0]), static_cast<int>(numbers[1]), static_cast<int>(numbers[2])},
        0};
    ASSERT_EQ(box.dims[1], Duct::along_y);
    const std::vector<char> is_solid(numbers.begin() + 3, numbers.end());
    LatticeFlow flow(box, test::halfway_walls(box, is_solid), {.viscosity_lu = 0.5}, {});
    constexpr double force = 1e-6;
    flow.body_force = force * Vec3::UnitY();
    for (int step = 0; step < 1500; ++step)  // 14^2 / nu = 400 steps
        flow.step();
    const double dx_cells = 1.0 * box.dims[0] * box.dims[2];
    const double area = Duct::across_x * Duct::across_z;
    const double mean = flow.superficial_velocity().y() * dx_cells / area;
    const double permeability = mean * 0.5 / force;
    const double expected = rectangle_permeability(Duct::across_z, Duct::across_x);
    fmt::print("duct: {:+.3f} %\n", 100.0 * (permeability / expected - 1.0));
    EXPECT_NEAR(permeability / expected, 1.0, 0.01);
}

}  // namespace
}  // namespace braidzone
