#include "porous/range_check.hpp"

#include "core/error.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace braidzone {

void require_pores(const Rhombus& rhombus, const char* law)
{
    constexpr double jammed_solidity = 0.95;
    const double densest = densest_solidity(rhombus);
    if (densest < jammed_solidity) return;
    throw InputError(fmt::format(
        "jammed braid: wires of {:.6g} m at a spacing of {:.6g} m, solidity {:.6g}; {} needs less "
        "than {:.6g}",
        rhombus.wire_diameter, std::min(rhombus.spacing_a, rhombus.spacing_b), densest, law,
        jammed_solidity));
}

std::vector<std::string> range_warnings(const std::string& law,
                                        const std::vector<std::vector<RangeCheck>>& checks)
{
    std::vector<std::string> warnings;
    const std::size_t num_quantities = checks.empty() ? 0 : checks.front().size();
    for (std::size_t i = 0; i < num_quantities; ++i) {
        std::size_t below = 0, above = 0;
        double lowest = checks.front()[i].value, highest = lowest;
        for (const std::vector<RangeCheck>& cell : checks) {
            const double value = cell[i].value;
            below += value < cell[i].lowest;
            above += value > cell[i].highest;
            lowest = std::min(lowest, value);
            highest = std::max(highest, value);
        }
        const RangeCheck& range = checks.front()[i];
        const auto warn = [&](std::size_t count, const char* side, double limit, const char* far,
                              double extreme) {
            if (count == 0) return;
            warnings.push_back(fmt::format(
                "{}: {} of {} rhombi have a {} {} {:.6g}, {} to {:.6g}; the law is verified for "
                "{:.6g} to {:.6g}",
                law, count, checks.size(), range.quantity, side, limit, far, extreme, range.lowest,
                range.highest));
        };
        warn(below, "below", range.lowest, "down", lowest);
        warn(above, "above", range.highest, "up", highest);
    }
    return warnings;
}

}  // namespace braidzone
