#include "core/repeat_curve.hpp"

#include "core/csv_fields.hpp"
#include "core/csv_reader.hpp"
#include "core/error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <string_view>

namespace braidzone {

namespace {

constexpr std::size_t fewest_points = 4;

/// SI value of the unit that a column's name ends in; none if it is another column.
std::optional<double> unit_of(std::string_view name, const CurveColumn& column)
{
    if (!name.starts_with(column.quantity)) return std::nullopt;
    for (const auto& [ending, value] : column.units) {
        if (name.ends_with(ending)) return value;
    }
    return std::nullopt;
}

/// SI value of each column's unit; empty if the line is no header of such a curve.
std::vector<double> units_in(std::string_view header, const CurveFormat& format)
{
    std::vector<double> units;
    for (const std::string_view name : csv_fields(header)) {
        const auto unit = unit_of(name, units.empty() ? format.abscissa : format.ordinate);
        if (!unit) return {};
        units.push_back(*unit);
    }
    return units.size() < 2 ? std::vector<double>{} : units;
}

/// The numbers of a line in SI units.
std::vector<double> numbers_in(const CsvReader& file, std::string_view line,
                               const std::vector<double>& units)
{
    const std::vector<std::string_view> fields = csv_fields(line);
    std::vector<double> values;
    for (std::size_t i = 0; i < fields.size() && i < units.size(); ++i) {
        if (const auto value = csv_number(fields[i])) values.push_back(units[i] * *value);
    }
    if (fields.size() != units.size() || values.size() != units.size()) {
        throw file.refusal(fmt::format(
            "\"{}\" is not a point of the curve; expected are {} numbers", line, units.size()));
    }
    return values;
}

void require_follows(const CsvReader& file, const CurveFormat& format, const RepeatCurve& curve,
                     double abscissa)
{
    if (abscissa >= 0.0 && (curve.abscissae.empty() || abscissa > curve.abscissae.back())) return;
    const auto& [ending, unit] = format.abscissa.units.front();
    std::string name = ending.substr(1);
    std::replace(name.begin(), name.end(), '_', '/');
    throw file.refusal(fmt::format("{0} {1:.6g} {2} does not follow; {0}s increase from 0 or above",
                                   format.abscissa.quantity, abscissa / unit, name));
}

}  // namespace

RepeatCurve read_repeat_curve(const std::filesystem::path& path, const CurveFormat& format)
{
    CsvReader file(path);
    const std::vector<double> units = units_in(file.header(), format);
    if (units.empty()) {
        throw file.refusal(fmt::format("\"{}\" is not the header of a {}; expected is {}",
                                       file.header(), format.name, format.expected));
    }
    RepeatCurve curve;
    curve.num_repeats = static_cast<int>(units.size()) - 1;
    double squares = 0.0;
    while (const auto line = file.next()) {
        if (line->empty()) continue;
        const std::vector<double> values = numbers_in(file, *line, units);
        require_follows(file, format, curve, values.front());
        const double mean =
            std::accumulate(values.begin() + 1, values.end(), 0.0) / curve.num_repeats;
        for (std::size_t i = 1; i < values.size(); ++i)
            squares += (values[i] - mean) * (values[i] - mean);
        curve.abscissae.push_back(values.front());
        curve.means.push_back(mean);
    }
    if (curve.means.size() < fewest_points) {
        throw InputError(fmt::format("{}: {} points; at least {} are needed", path.string(),
                                     curve.means.size(), fewest_points));
    }
    if (std::none_of(curve.means.begin(), curve.means.end(), [](double x) { return x > 0.0; })) {
        std::string name = format.ordinate.quantity;
        std::replace(name.begin(), name.end(), '_', ' ');
        throw InputError(fmt::format("{}: no mean {} is above zero", path.string(), name));
    }
    if (curve.num_repeats > 1) {
        const double freedom = static_cast<double>(curve.means.size()) * (curve.num_repeats - 1);
        curve.deviation = std::sqrt(squares / freedom);
    }
    return curve;
}

}  // namespace braidzone
