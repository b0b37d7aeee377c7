#include "deploy/spacing_table.hpp"

#include "core/csv_fields.hpp"
#include "core/csv_reader.hpp"
#include "core/error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

namespace braidzone {

namespace {

constexpr std::string_view header_form = "s_mm,lambda (or s_m, s_cm, s_um)";

/// The two fields of a line; none if there are not two.
std::optional<std::pair<std::string_view, std::string_view>> split_in_two(std::string_view line)
{
    const std::vector<std::string_view> fields = csv_fields(line);
    if (fields.size() != 2) return std::nullopt;
    return std::pair{fields[0], fields[1]};
}

std::string_view trimmed(std::string_view line)
{
    while (line.ends_with(' '))
        line.remove_suffix(1);
    return line;
}

/// Metres in the unit of the header's first column; none if it is no such header.
std::optional<double> metres_in_header(std::string_view line)
{
    const auto fields = split_in_two(line);
    if (!fields || fields->second != "lambda") return std::nullopt;
    for (const auto& [name, metres] : {std::pair{"s_m", 1.0}, std::pair{"s_cm", 1e-2},
                                       std::pair{"s_mm", 1e-3}, std::pair{"s_um", 1e-6}}) {
        if (fields->first == name) return metres;
    }
    return std::nullopt;
}

}  // namespace

std::vector<SpacingPoint> read_spacing_table(const std::filesystem::path& path)
{
    CsvReader file(path);
    const std::optional<double> metres = metres_in_header(file.header());
    if (!metres) {
        throw file.refusal(
            fmt::format("\"{}\" is not the header of a spacing table; expected is {}",
                        trimmed(file.header()), header_form));
    }
    std::vector<SpacingPoint> table;
    int blank_line = 0;
    while (const auto line = file.next()) {
        if (trimmed(*line).empty()) {
            blank_line = file.line_number();
            continue;
        }
        if (blank_line > 0)
            throw file.refusal(blank_line, "is empty; a point of the table is expected");
        const auto fields = split_in_two(*line);
        const auto arc_length = fields ? csv_number(fields->first) : std::nullopt;
        const auto spacing = fields ? csv_number(fields->second) : std::nullopt;
        if (!arc_length || !spacing) {
            throw file.refusal(
                fmt::format("\"{}\" is not a point of the table; expected are two "
                            "numbers with a comma between",
                            trimmed(*line)));
        }
        table.push_back({*metres * *arc_length, *spacing});
        const std::size_t n = table.size();
        if (n == 1) continue;
        const bool increasing = table[1].arc_length > table[0].arc_length;
        const double step = table[n - 1].arc_length - table[n - 2].arc_length;
        if (!(increasing ? step > 0.0 : step < 0.0)) {
            throw file.refusal(fmt::format("arc length {} follows {}; arc lengths must go one way",
                                           *arc_length, table[n - 2].arc_length / *metres));
        }
    }
    if (table.size() < 2) {
        throw file.refusal(
            fmt::format("the table has {} points; at least 2 are expected", table.size()));
    }
    if (table.front().arc_length > table.back().arc_length)
        std::reverse(table.begin(), table.end());
    try {
        validate(ReleaseSchedule{.windows = {}, .table = table});
    } catch (const ConfigError& error) {
        throw InputError(fmt::format("{}: {}", path.string(), error.what()));
    }
    return table;
}

}  // namespace braidzone
