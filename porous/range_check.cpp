#include "porous/range_check.hpp"

#include "core/error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace braidzone {

namespace {

/// Over the limit: rounding of a cell that was opened to it.
constexpr double solidity_rounding = 1e-9;

}  // namespace

bool is_jammed(const Rhombus& rhombus)
{
    return !(densest_solidity(rhombus) <= jammed_solidity * (1.0 + solidity_rounding));
}

Rhombus opened_to_limit(const Rhombus& rhombus)
{
    if (!is_jammed(rhombus)) return rhombus;
    const double spacing = rhombus.wire_diameter / jammed_solidity;
    const double length_a = std::max(spacing, rhombus.edge_a.norm());
    const double length_b = std::max(spacing, rhombus.edge_b.norm());
    const double sine = spacing / std::min(length_a, length_b);
    const Vec3 along = rhombus.edge_a.normalized();
    const double part = rhombus.edge_b.dot(along);
    const Vec3 across = (rhombus.edge_b - part * along).normalized();
    const double cosine = std::copysign(std::sqrt(std::max(0.0, 1.0 - sine * sine)), part);
    Rhombus opened = measure_rhombus(length_a * along, length_b * (cosine * along + sine * across),
                                     rhombus.wire_diameter, along);
    opened.braid_angle = rhombus.braid_angle;
    return opened;
}

void require_pores(const Rhombus& rhombus, const char* law)
{
    const double densest = densest_solidity(rhombus);
    if (!is_jammed(rhombus)) return;
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
