#include "deploy/force_curve.hpp"

#include "core/csv_fields.hpp"
#include "core/csv_reader.hpp"
#include "core/error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

namespace braidzone {

namespace {

constexpr std::size_t fewest_points = 4;

/// SI value of the unit that a column's name ends in; none if it does not begin with `quantity` or
/// ends in another unit.
std::optional<double> unit_of(std::string_view column, std::string_view quantity,
                              std::initializer_list<std::pair<std::string_view, double>> units)
{
    if (!column.starts_with(quantity)) return std::nullopt;
    for (const auto& [ending, value] : units) {
        if (column.ends_with(ending)) return value;
    }
    return std::nullopt;
}

/// SI value of each column's unit; empty if the line is no header of a force curve.
std::vector<double> units_in(std::string_view header)
{
    std::vector<double> units;
    for (std::string_view column : csv_fields(header)) {
        const auto unit =
            units.empty()
                ? unit_of(column, "displacement", {{"_mm", 1e-3}, {"_um", 1e-6}, {"_m", 1.0}})
                : unit_of(column, "force", {{"_mN", 1e-3}, {"_uN", 1e-6}, {"_N", 1.0}});
        if (!unit) return {};
        units.push_back(*unit);
    }
    return units.size() < 2 ? std::vector<double>{} : units;
}

}  // namespace

ForceCurve read_force_curve(const std::filesystem::path& path)
{
    CsvReader file(path);
    const std::vector<double> units = units_in(file.header());
    if (units.empty()) {
        throw file.refusal(
            fmt::format("\"{}\" is not the header of a force curve; expected is "
                        "displacement_mm,force_1_mN,force_2_mN,... (or _um, _m; _uN, _N)",
                        file.header()));
    }
    ForceCurve curve;
    curve.num_repeats = static_cast<int>(units.size()) - 1;
    double squares = 0.0;
    while (const auto line = file.next()) {
        if (line->empty()) continue;
        const std::vector<std::string_view> fields = csv_fields(*line);
        std::vector<double> values;
        for (std::size_t i = 0; i < fields.size() && i < units.size(); ++i) {
            if (const auto value = csv_number(fields[i])) values.push_back(units[i] * *value);
        }
        if (fields.size() != units.size() || values.size() != units.size()) {
            throw file.refusal(
                fmt::format("\"{}\" is not a point of the curve; expected are {} numbers", *line,
                            units.size()));
        }
        ForcePoint point;
        point.displacement = values.front();
        point.force = std::accumulate(values.begin() + 1, values.end(), 0.0) / curve.num_repeats;
        if (point.displacement < 0.0 ||
            (!curve.points.empty() && !(point.displacement > curve.points.back().displacement))) {
            throw file.refusal(
                fmt::format("displacement {:.6g} mm does not follow; displacements "
                            "increase from 0 or above",
                            1e3 * point.displacement));
        }
        for (std::size_t i = 1; i < values.size(); ++i)
            squares += (values[i] - point.force) * (values[i] - point.force);
        curve.points.push_back(point);
    }
    if (curve.points.size() < fewest_points) {
        throw InputError(fmt::format("{}: {} points; at least {} are needed", path.string(),
                                     curve.points.size(), fewest_points));
    }
    const auto bears = [](const ForcePoint& point) { return point.force > 0.0; };
    if (std::none_of(curve.points.begin(), curve.points.end(), bears))
        throw InputError(fmt::format("{}: no mean force is above zero", path.string()));
    if (curve.num_repeats > 1) {
        const double freedom = static_cast<double>(curve.points.size()) * (curve.num_repeats - 1);
        curve.deviation = std::sqrt(squares / freedom);
    }
    return curve;
}

}  // namespace braidzone
