// Writes the tables of wire-resolved flow through braids: see README.md.
//
//     unit_cell_table <folder> slow-flow | inertia | slip

#include "porous/braid_stokes.hpp"
#include "verification/unit_cell/braid_cell.hpp"
#include "verification/unit_cell/cell_flow.hpp"
#include "verification/unit_cell/table_grids.hpp"

#include <fmt/core.h>
#include <fmt/os.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

namespace braidzone::test {
namespace {

constexpr double degree = std::numbers::pi / 180.0;

/// Cells along a line of the finer of two grids over those of the coarser one.
constexpr double grid_ratio = std::numbers::sqrt2;

/// An error of second order is a third of the difference to the value on half as many cells, and
/// equal to the difference to that between.
double grid_uncertainty(double fine, double between, double coarse)
{
    return std::max(std::abs(fine - between), std::abs(fine - coarse) / 3.0);
}

void write_slow_flow(const std::filesystem::path& folder)
{
    auto file = fmt::output_file((folder / "unit_cell.csv").string());
    file.print(
        "solidity,metal_coverage,crossing_angle_deg,cells_per_diameter,p_a_over_mu,"
        "grid_uncertainty,law,deviation\n");
    for (const auto& [solidity, spacing] : table_resolutions) {
        for (const double angle : {90.0, 60.0, 42.0}) {
            const std::vector<BraidCell> cells = table_grids({solidity, angle * degree}, spacing);
            std::vector<double> losses;
            for (const BraidCell& cell : cells)
                losses.push_back(slow_loss(cell));
            const double uncertainty = grid_uncertainty(losses[2], losses[1], losses[0]);
            for (std::size_t i = 0; i < cells.size(); ++i) {
                const double law =
                    cells[i].spacing * braid_stokes_linear(rhombus_of(cells[i]), 1.0);
                file.print("{:.3f},{:.4f},{:.2f},{:.2f},{:.3f},{:.3f},{:.3f},{:.4f}\n", solidity,
                           rhombus_of(cells[i]).metal_coverage, cells[i].crossing_angle / degree,
                           cells[i].wire_diameter, losses[i],
                           uncertainty + std::abs(losses[i] - losses[2]), law,
                           law / losses[i] - 1.0);
            }
            file.flush();
        }
    }
}

struct ResolvedBraid {
    double solidity = 0.0;
    double crossing_angle_deg = 0.0;
    double cells_per_diameter = 0.0;  ///< on the finer grid
};

/// The cell of a braid on a coarser grid and on its own.
std::pair<BraidCell, BraidCell> two_grids(const ResolvedBraid& braid, double height)
{
    const Braid shape{braid.solidity, braid.crossing_angle_deg * degree};
    return {make_braid_cell(shape, braid.cells_per_diameter / grid_ratio, height),
            make_braid_cell(shape, braid.cells_per_diameter, height)};
}

void write_inertia(const std::filesystem::path& folder)
{
    const std::vector<double> reynolds_numbers{1.0, 2.0};
    constexpr double viscosity_lu = 0.24, height = 3.5;
    auto file = fmt::output_file((folder / "unit_cell_inertia.csv").string());
    file.print(
        "solidity,crossing_angle_deg,cells_per_diameter,reynolds,p_a_over_mu,increment,"
        "grid_uncertainty,quadratic_over_density,law_quadratic_over_density,quadratic_deviation,"
        "loss_deviation\n");
    for (const ResolvedBraid& braid : {ResolvedBraid{0.10, 90.0, 5.5},
                                       {0.14, 90.0, 6.3},
                                       {0.176, 90.0, 7.5},
                                       {0.176, 42.0, 7.0},
                                       {0.22, 90.0, 8.5},
                                       {0.30, 90.0, 10.0},
                                       {0.40, 90.0, 12.0}}) {
        const auto [coarse_cell, cell] = two_grids(braid, height);
        const std::vector<double> coarse =
            losses_with_inertia(coarse_cell, reynolds_numbers, viscosity_lu);
        const std::vector<double> fine = losses_with_inertia(cell, reynolds_numbers, viscosity_lu);
        const Rhombus rhombus = rhombus_of(cell);
        const double linear_law = cell.spacing * braid_stokes_linear(rhombus, 1.0);
        const double quadratic_law = braid_stokes_quadratic(rhombus, 1.0);
        for (std::size_t i = 1; i < fine.size(); ++i) {
            const double reynolds = reynolds_numbers[i - 1];
            const double increment = fine[i] - fine[0];
            // dp p / (mu v) = p A / mu + (b / rho) (Re / s)
            const double quadratic = increment * braid.solidity / reynolds;
            const double law = linear_law + quadratic_law * reynolds / braid.solidity;
            file.print(
                "{:.3f},{:.2f},{:.2f},{:.2f},{:.3f},{:.3f},{:.3f},{:.4f},{:.4f},{:.3f},"
                "{:.4f}\n",
                braid.solidity, cell.crossing_angle / degree, cell.wire_diameter, reynolds, fine[0],
                increment, std::abs(increment - (coarse[i] - coarse[0])), quadratic, quadratic_law,
                quadratic_law / quadratic - 1.0, law / fine[i] - 1.0);
        }
        file.flush();
    }
}

void write_slip(const std::filesystem::path& folder)
{
    constexpr double height = 1.5;
    auto file = fmt::output_file((folder / "unit_cell_slip.csv").string());
    file.print(
        "solidity,crossing_angle_deg,flow_direction_deg,cells_per_diameter,slip_over_diameter,"
        "grid_uncertainty\n");
    for (const ResolvedBraid& braid : {ResolvedBraid{0.10, 90.0, 5.5},
                                       {0.176, 90.0, 8.0},
                                       {0.176, 60.0, 8.0},
                                       {0.176, 42.0, 7.5},
                                       {0.30, 90.0, 12.0}}) {
        const auto [coarse_cell, cell] = two_grids(braid, height);
        for (const double direction : {0.0, 90.0}) {
            if (direction > 0.0 && braid.crossing_angle_deg == 90.0)
                continue;  // the same by symmetry
            const Vec3 along(std::cos(direction * degree), std::sin(direction * degree), 0.0);
            const double coarse = mean(slip_lengths(coarse_cell, along));
            const SlipLengths fine = slip_lengths(cell, along);
            // Both sides are equal but for the wires' places on the lattice.
            const double uncertainty =
                std::max(std::abs(mean(fine) - coarse), 0.5 * std::abs(fine.above - fine.below));
            file.print("{:.3f},{:.2f},{:.0f},{:.2f},{:.3f},{:.3f}\n", braid.solidity,
                       cell.crossing_angle / degree, direction, cell.wire_diameter, mean(fine),
                       uncertainty);
            file.flush();
        }
    }
}

}  // namespace
}  // namespace braidzone::test

int main(int argc, char** argv)
{
    const std::string table = argc == 3 ? argv[2] : "";
    if (table == "slow-flow") {
        braidzone::test::write_slow_flow(argv[1]);
    } else if (table == "inertia") {
        braidzone::test::write_inertia(argv[1]);
    } else if (table == "slip") {
        braidzone::test::write_slip(argv[1]);
    } else {
        fmt::print(stderr, "usage: unit_cell_table <folder> slow-flow | inertia | slip\n");
        return 2;
    }
    return 0;
}
