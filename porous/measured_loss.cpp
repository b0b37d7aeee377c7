#include "porous/measured_loss.hpp"

#include "core/csv_fields.hpp"
#include "core/error.hpp"
#include "porous/braid_stokes.hpp"
#include "porous/two_term_fit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>
#include <string>
#include <utility>

namespace braidzone {

namespace {

constexpr const char* header = "metal_coverage,wire_spacing_um,velocity_mm_s,pressure_drop_Pa";

/// Coverage and wire spacing [m], by which the lines of one braid are known.
using BraidKey = std::pair<double, double>;

/// The loss of an orthogonal braid of a coverage and spacing by the recommended law.
SheetLoss recommended_loss(const MeasuredBraid& braid, const Fluid& fluid)
{
    // coverage = 1 - (1 - s)^2
    const double solidity = 1.0 - std::sqrt(1.0 - braid.metal_coverage);
    const Rhombus cell =
        measure_rhombus(braid.wire_spacing * Vec3::UnitX(), braid.wire_spacing * Vec3::UnitY(),
                        solidity * braid.wire_spacing, Vec3(1, 1, 0));
    return sheet_loss(BraidStokesLaw{}, cell, fluid);
}

/// By how much a measured braid differs from the recommended law.
struct Factors {
    double linear = 1.0;
    double quadratic = 1.0;
};

Factors factors_of(const MeasuredBraid& braid, const Fluid& bench_fluid)
{
    const SheetLoss recommended = recommended_loss(braid, bench_fluid);
    return {braid.loss.linear / recommended.linear, braid.loss.quadratic / recommended.quadratic};
}

Factors factors_at(const MeasuredLaw& law, double metal_coverage)
{
    const auto after = std::find_if(
        law.braids.begin(), law.braids.end(),
        [&](const MeasuredBraid& braid) { return braid.metal_coverage > metal_coverage; });
    if (after == law.braids.begin()) return factors_of(*after, law.bench_fluid);
    if (after == law.braids.end()) return factors_of(law.braids.back(), law.bench_fluid);
    const MeasuredBraid& before = *(after - 1);
    const double part =
        (metal_coverage - before.metal_coverage) / (after->metal_coverage - before.metal_coverage);
    const Factors lower = factors_of(before, law.bench_fluid);
    const Factors upper = factors_of(*after, law.bench_fluid);
    return {std::lerp(lower.linear, upper.linear, part),
            std::lerp(lower.quadratic, upper.quadratic, part)};
}

/// The table's lines by braid, in the order of their coverage.
std::map<BraidKey, std::vector<LossSample>> read_samples(const std::filesystem::path& path)
{
    std::ifstream file(path);
    if (!file) throw IoError(fmt::format("{} cannot be read", path.string()));
    std::string line;
    std::getline(file, line);
    if (line.ends_with('\r')) line.pop_back();
    if (csv_fields(line) != csv_fields(header)) {
        throw InputError(
            fmt::format("{}:1: \"{}\" is not the header of a table of pressure drops; expected is "
                        "{}",
                        path.string(), line, header));
    }
    std::map<BraidKey, std::vector<LossSample>> samples;
    for (int number = 2; std::getline(file, line); ++number) {
        if (line.find_first_not_of(" \t\r") == std::string::npos) continue;
        std::vector<double> values;
        for (const std::string_view field : csv_fields(line)) {
            if (const auto value = csv_number(field)) values.push_back(*value);
        }
        const bool valid = csv_fields(line).size() == 4 && values.size() == 4 && values[0] > 0.0 &&
                           values[0] < 1.0 && values[1] > 0.0 && values[2] > 0.0 && values[3] > 0.0;
        if (!valid) {
            throw InputError(fmt::format(
                "{}:{}: \"{}\" is no measurement; expected are four numbers: a coverage between 0 "
                "and 1, and a spacing, a velocity and a pressure drop, all positive",
                path.string(), number, line));
        }
        samples[{values[0], 1e-6 * values[1]}].push_back({1e-3 * values[2], values[3]});
    }
    if (file.bad()) throw IoError(fmt::format("{} cannot be read to its end", path.string()));
    if (samples.empty()) {
        throw InputError(
            fmt::format("{} holds no measurement; at least two are expected", path.string()));
    }
    return samples;
}

}  // namespace

MeasuredLaw read_measured_law(const std::filesystem::path& table, const Fluid& bench_fluid)
{
    MeasuredLaw law{table, bench_fluid, {}};
    for (const auto& [key, samples] : read_samples(table)) {
        MeasuredBraid braid;
        braid.metal_coverage = key.first;
        braid.wire_spacing = key.second;
        const auto refuse = [&](const std::string& finding) {
            return InputError(fmt::format("{}: braid of coverage {:.6g} and spacing {:.6g} um: {}",
                                          table.string(), key.first, 1e6 * key.second, finding));
        };
        const auto [slowest, fastest] = std::minmax_element(
            samples.begin(), samples.end(),
            [](const LossSample& s, const LossSample& t) { return s.velocity < t.velocity; });
        if (!(fastest->velocity > slowest->velocity)) {
            throw refuse("measured at one velocity only; two or more are needed to tell a from b");
        }
        if (!law.braids.empty() && law.braids.back().metal_coverage == key.first) {
            throw refuse("another braid of the same coverage is in the table; allowed is one");
        }
        try {
            braid.loss = two_term_fit(samples);
        } catch (const InputError& error) {
            throw refuse(error.what());
        }
        braid.fit_error = two_term_error(braid.loss, samples);
        braid.highest_velocity = fastest->velocity;
        law.braids.push_back(braid);
    }
    return law;
}

SheetLoss sheet_loss(const MeasuredLaw& law, const Rhombus& rhombus, const Fluid& fluid)
{
    if (law.braids.empty()) throw InputError("measured resistance without a measured braid");
    const Factors factors = factors_at(law, rhombus.metal_coverage);
    const SheetLoss recommended = sheet_loss(BraidStokesLaw{}, rhombus, fluid);
    return {factors.linear * recommended.linear, factors.quadratic * recommended.quadratic};
}

std::vector<RangeCheck> range_checks(const MeasuredLaw& law, const Rhombus& rhombus,
                                     const Fluid& /*fluid*/)
{
    if (law.braids.empty()) return {};
    constexpr double slack = 0.1;
    double fastest = 0.0;
    for (const MeasuredBraid& braid : law.braids)
        fastest = std::max(fastest, braid.highest_velocity);
    return {{"metal coverage", rhombus.metal_coverage,
             (1.0 - slack) * law.braids.front().metal_coverage,
             (1.0 + slack) * law.braids.back().metal_coverage},
            {"velocity at the neck [m/s]", neck_velocity, 0.0, fastest}};
}

}  // namespace braidzone
