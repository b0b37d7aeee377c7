#include "discrepancy/density_map.hpp"

#include "core/csv_fields.hpp"
#include "core/csv_reader.hpp"
#include "core/length_unit.hpp"

#include <fmt/format.h>

#include <array>
#include <limits>
#include <optional>
#include <string>

namespace braidzone {
namespace {

constexpr double smallest_window = 0.5e-3, largest_window = 5e-3;  // [m]

/// A density as it stands in a file.
struct DensityColumn {
    std::string_view value, sd;  ///< the columns' names
    DensityQuantity quantity;
    double unit;          ///< SI value of one unit of the file
    double lower, upper;  ///< bounds, in the file's unit; not allowed themselves
};

constexpr double no_bound = std::numeric_limits<double>::infinity();

constexpr std::array<DensityColumn, 5> density_columns = {{
    {"pore_density_per_mm2", "sd_per_mm2", DensityQuantity::pore_density, 1e6, 0.0, no_bound},
    {"metal_coverage", "sd", DensityQuantity::metal_coverage, 1.0, 0.0, 1.0},
    {"metal_coverage_percent", "sd_percent", DensityQuantity::metal_coverage, 0.01, 0.0, 100.0},
    {"surface_density_increase", "sd", DensityQuantity::surface_density_increase, 1.0, -1.0,
     no_bound},
    {"surface_density_increase_percent", "sd_percent", DensityQuantity::surface_density_increase,
     0.01, -100.0, no_bound},
}};

/// What a header says of the columns.
struct DensityHeader {
    LengthUnit unit;  ///< of the places
    DensityColumn density;
    std::optional<LengthUnit> window_unit;  ///< none: there is no column of windows
};

std::optional<DensityHeader> parsed_header(const std::string& line)
{
    const std::vector<std::string_view> fields = csv_fields(line);
    if (fields.size() != 5 && fields.size() != 6) return std::nullopt;
    for (const char* name : {"mm", "m", "cm", "um"}) {
        const auto column = [&](const char* what) { return fmt::format("{}_{}", what, name); };
        if (fields[0] != column("x") || fields[1] != column("y") || fields[2] != column("z"))
            continue;
        for (const DensityColumn& density : density_columns) {
            if (fields[3] != density.value || fields[4] != density.sd) continue;
            DensityHeader header{length_unit(name), density, std::nullopt};
            if (fields.size() == 5) return header;
            if (fields[5] != "window_mm") return std::nullopt;
            header.window_unit = length_unit("mm");
            return header;
        }
    }
    return std::nullopt;
}

std::string range_text(const DensityColumn& column)
{
    return column.upper == no_bound
               ? fmt::format("above {:.6g}", column.lower)
               : fmt::format("between {:.6g} and {:.6g}", column.lower, column.upper);
}

DensityPlace place_of(const CsvReader& file, const DensityHeader& header, const std::string& line)
{
    const std::vector<std::string_view> fields = csv_fields(line);
    const std::size_t expected = header.window_unit ? 6 : 5;
    if (fields.size() != expected) {
        throw file.refusal(
            fmt::format("has {} values; the header has {}", fields.size(), expected));
    }
    std::array<double, 6> numbers = {};
    for (std::size_t i = 0; i < expected; ++i) {
        const std::optional<double> number = csv_number(fields[i]);
        if (!number) {
            throw file.refusal(fmt::format("\"{}\" is not a finite number", fields[i]));
        }
        numbers[i] = *number;
    }
    const DensityColumn& density = header.density;
    if (!(numbers[3] > density.lower && numbers[3] < density.upper)) {
        throw file.refusal(fmt::format("{} = {:.6g}; it must be {}", density.value, numbers[3],
                                       range_text(density)));
    }
    if (!(numbers[4] > 0.0)) {
        throw file.refusal(fmt::format("{} = {:.6g}; a standard deviation must be positive",
                                       density.sd, numbers[4]));
    }
    DensityPlace place;
    place.point = header.unit.metres * Vec3(numbers[0], numbers[1], numbers[2]);
    place.value = density.unit * numbers[3];
    place.sd = density.unit * numbers[4];
    place.line = file.line_number();
    if (!header.window_unit) return place;
    place.window = header.window_unit->metres * numbers[5];
    if (!(place.window >= smallest_window && place.window <= largest_window)) {
        throw file.refusal(fmt::format("window_mm = {:.6g}; it must be between {:.6g} and {:.6g}",
                                       numbers[5], 1e3 * smallest_window, 1e3 * largest_window));
    }
    return place;
}

}  // namespace

std::string_view name_of(DensityQuantity quantity)
{
    switch (quantity) {
        case DensityQuantity::pore_density:
            return "pore_density";
        case DensityQuantity::metal_coverage:
            return "metal_coverage";
        case DensityQuantity::surface_density_increase:
            return "surface_density_increase";
    }
    return "";
}

DensityMap read_density_map(const std::filesystem::path& path)
{
    CsvReader file(path);
    const std::optional<DensityHeader> header = parsed_header(file.header());
    if (!header) {
        std::string known;
        for (const DensityColumn& column : density_columns)
            known += fmt::format("{}{},{}", known.empty() ? "" : " or ", column.value, column.sd);
        throw file.refusal(
            1, fmt::format("\"{}\" is not the header of a density map; expected is x_mm,y_mm,z_mm "
                           "(or m, cm, um), then {}, then window_mm or nothing",
                           file.header(), known));
    }
    DensityMap map;
    map.quantity = header->density.quantity;
    while (const std::optional<std::string> line = file.next()) {
        if (line->empty()) continue;
        map.places.push_back(place_of(file, *header, *line));
    }
    if (map.places.empty()) throw file.refusal(1, "no place follows the header");
    return map;
}

}  // namespace braidzone
