// Curves with a hidden effect, and what the search for a missing effect makes of them; see README.

#include "discrepancy/blind_curves/hidden_force.hpp"
#include "discrepancy/blind_curves/hidden_pressure.hpp"
#include "discrepancy/blind_curves/score.hpp"
#include "discrepancy/force_effects.hpp"
#include "discrepancy/pressure_effects.hpp"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <fstream>
#include <string>

namespace {

using namespace braidzone;

std::map<std::string, int> numbers_of_cases(const std::vector<std::string>& effects,
                                            const std::vector<std::string>& outside)
{
    std::map<std::string, int> numbers = {{"none", 60}};
    for (const std::string& effect : effects)
        numbers[effect] = 12;
    for (const std::string& kind : outside)
        numbers[kind] = 10;
    return numbers;
}

void run_pressure(unsigned first_seed)
{
    const std::vector<std::string> effects = {"viscosity", "leakage", "missing_inertia", "density",
                                              "second_layer"};
    std::map<std::string, test::Tally> tallies;
    unsigned seed = first_seed;
    for (const auto& [kind, number] : numbers_of_cases(effects, {"sine", "step", "clipped"})) {
        for (int i = 0; i < number; ++i) {
            const test::HiddenPressure hidden = test::PressureMaker(seed++).make(kind);
            const Explanation found = explain(
                make_curve_problem(hidden.measured, pressure_noise(),
                                   pressure_curve_bench(hidden.stated, hidden.measured.abscissae)),
                curve_options());
            const bool known = std::find(effects.begin(), effects.end(), kind) != effects.end();
            test::count(tallies, {kind, known, hidden.value}, found);
        }
    }
    test::print(tallies);
}

void run_force(unsigned first_seed)
{
    const std::vector<std::string> effects = {"zero_offset",        "friction",
                                              "wire_diameter",      "surface_coefficient",
                                              "radial_coefficient", "stiffening"};
    std::vector<test::HiddenPressTest> tests(test::ForceMaker::num_tests);
    tbb::parallel_for(std::size_t{0}, tests.size(), [&](std::size_t i) {
        tests[i] = test::ForceMaker::pressed(static_cast<int>(i), first_seed);
    });
    const PressResponse response = make_press_response(test::stated_press(), 3.25e-3);
    std::map<std::string, test::Tally> tallies;
    unsigned seed = first_seed;
    int failed = 0;
    for (const auto& [kind, number] : numbers_of_cases(effects, {"sine", "slip", "hysteresis"})) {
        for (int i = 0; i < number; ++i) {
            const test::HiddenForce hidden = test::ForceMaker(seed++).make(kind, tests);
            const MeasuredCurve& curve = hidden.measured;
            failed += curve.abscissae.empty() ? 1 : 0;
            if (curve.abscissae.empty()) continue;
            const Explanation found =
                explain(make_curve_problem(curve, force_noise(),
                                           force_curve_bench(response, curve.abscissae)),
                        curve_options());
            const bool known = std::find(effects.begin(), effects.end(), kind) != effects.end();
            test::count(tallies, {kind, known, hidden.value}, found);
        }
    }
    test::print(tallies);
    fmt::print("\n{} cases of press tests without a state of rest are left out\n", failed);
}

/// The measurement of cases/bench_pressure: a Pipeline of 4 x 20 mm in water and glycerine, with
/// another density than its figures say.
void write_example(const std::filesystem::path& folder)
{
    PressureBench bench;
    bench.device = test::stated_press().device;
    bench.diameter = bench.device.nominal_diameter;
    bench.channel_diameter = bench.diameter;
    bench.fluid = {1060.0, 3.5e-3};
    constexpr unsigned seed = 4;
    const test::HiddenPressure hidden = test::PressureMaker(seed).make("density", bench);
    std::ofstream file(folder / "measured.csv");
    file << "velocity_m_s,pressure_drop_Pa\n";
    for (std::size_t i = 0; i < hidden.measured.abscissae.size(); ++i) {
        file << fmt::format("{:.4f},{:.2f}\n", hidden.measured.abscissae[i],
                            hidden.measured.ordinates[i]);
    }
    fmt::print("hidden: density_change = {:.3f}\n", *hidden.value);
}

}  // namespace

int main(int argc, char** argv)
{
    if (argc != 3) {
        fmt::print(stderr, "usage: blind_curves pressure|force FIRST_SEED, or example FOLDER\n");
        return 2;
    }
    try {
        if (std::string(argv[1]) == "example") {
            write_example(argv[2]);
            return 0;
        }
        const auto seed = static_cast<unsigned>(std::strtoul(argv[2], nullptr, 10));
        if (std::string(argv[1]) == "pressure") {
            run_pressure(seed);
        } else {
            run_force(seed);
        }
    } catch (const std::exception& error) {
        fmt::print(stderr, "{}\n", error.what());
        return 1;
    }
    return 0;
}
