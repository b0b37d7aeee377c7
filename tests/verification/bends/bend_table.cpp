// Tables of devices in single bends. See README.md beside it.
//
//     bend_table sweep              rings locked in their planes, nominal and force-free
//     bend_table network RATIO...   beside the network of wires that slide along the vessel, in
//     bends
//                                   of these radii over the vessel's

#include "verification/bends/bend.hpp"

#include <fmt/format.h>

#include <cstdlib>
#include <iostream>
#include <string>
#include <vector>

namespace braidzone::test {
namespace {

std::string line_of(const Bend& bend, const BendOutcome& outcome)
{
    const std::string model = bend.axially_free
                                  ? (bend.friction > 0.0 ? "network, sticks" : "network, slides")
                                  : (bend.force_free ? "force-free" : "nominal");
    std::string line = fmt::format("| {:.2f} | {:.0f} | {:.2f} | {} |", bend.bend_ratio,
                                   bend.angle * 180.0 / std::numbers::pi, bend.device_ratio, model);
    if (!outcome.refused.empty()) return line + " " + outcome.refused + " |";
    return line + fmt::format(
                      " {} | {} | {} | {:.2f} | {:+.2f} | {:.3f} | {:.3f} | {:.3f} | {:.0f} "
                      "| {:.0f} | {:.2f} | {:.2f}{} |",
                      outcome.inverted, outcome.outside, outcome.jammed, 1e3 * outcome.length,
                      1e2 * outcome.wire_stretch, outcome.coverage, outcome.inner_coverage,
                      outcome.outer_coverage, 1e6 * outcome.inner_gap, outcome.pressure,
                      outcome.contact, outcome.cpu_time, outcome.converged ? "" : ", not at rest");
}

void print_header()
{
    std::cout
        << "| bend | deg | device | rings | inverted | outside | jammed | length, mm | wires, % | "
           "coverage | inner | outer | inner gap, um | pressure, Pa | contact | CPU, s |\n"
        << "|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|\n";
}

void print(const Bend& bend)
{
    std::cout << line_of(bend, outcome_of(bend)) << std::endl;
}

void print_sweep()
{
    for (const double angle : {0.5 * std::numbers::pi, 0.75 * std::numbers::pi}) {
        for (const double bend_ratio : {1.0, 1.1, 1.25, 1.5, 2.0, 3.0}) {
            for (const double device_ratio : {1.01, 1.08, 1.16, 1.25}) {
                for (const bool force_free : {false, true}) {
                    print({.bend_ratio = bend_ratio,
                           .angle = angle,
                           .device_ratio = device_ratio,
                           .force_free = force_free});
                }
            }
        }
    }
}

void print_network(const std::vector<double>& bend_ratios)
{
    for (const double bend_ratio : bend_ratios) {
        // Half the wires, since the network takes a hundred times as long as rays.
        Bend bend{.bend_ratio = bend_ratio, .device_ratio = 1.08, .num_wires = 24};
        bend.force_free = true;
        print(bend);
        bend.force_free = false;
        bend.axially_free = true;
        for (const double friction : {0.0, infinite_friction}) {
            bend.friction = friction;
            print(bend);
        }
    }
}

}  // namespace
}  // namespace braidzone::test

int main(int argc, char** argv)
{
    const std::string wanted = argc > 1 ? argv[1] : "";
    if (wanted != "sweep" && wanted != "network") {
        std::cerr << "bend_table sweep | network RATIO...\n";
        return 2;
    }
    braidzone::test::print_header();
    if (wanted == "sweep") {
        braidzone::test::print_sweep();
        return EXIT_SUCCESS;
    }
    std::vector<double> ratios;
    for (int i = 2; i < argc; ++i)
        ratios.push_back(std::stod(argv[i]));
    braidzone::test::print_network(ratios);
    return EXIT_SUCCESS;
}
