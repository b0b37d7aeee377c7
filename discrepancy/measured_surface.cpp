#include "discrepancy/measured_surface.hpp"

#include "core/csv_fields.hpp"
#include "core/error.hpp"
#include "core/surface_io.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <fstream>
#include <sstream>
#include <string>
#include <string_view>

namespace braidzone {
namespace {

namespace fs = std::filesystem;

std::string lower_case_ending(const fs::path& path)
{
    std::string ending = path.extension().string();
    std::transform(ending.begin(), ending.end(), ending.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return ending;
}

InputError refusal(const fs::path& path, int line, const std::string& finding)
{
    return InputError(fmt::format("{}:{}: {}", path.string(), line, finding));
}

LengthUnit required(const std::optional<LengthUnit>& unit, const fs::path& path)
{
    if (unit) return *unit;
    throw ConfigError(fmt::format(
        "{} does not state the unit of its coordinates; give --length-unit m, cm, mm or um",
        path.string()));
}

/// The unit in a header `x_mm,y_mm,z_mm`; none if the line is no such header.
std::optional<LengthUnit> unit_in_header(std::string_view line)
{
    const std::vector<std::string_view> fields = csv_fields(line);
    for (const char* name : {"m", "cm", "mm", "um"}) {
        const auto column = [&](const char* axis) { return fmt::format("{}_{}", axis, name); };
        if (fields.size() == 3 && fields[0] == column("x") && fields[1] == column("y") &&
            fields[2] == column("z")) {
            return length_unit(name);
        }
    }
    return std::nullopt;
}

Vec3 point_of(const std::vector<std::string_view>& fields, const fs::path& path, int line)
{
    Vec3 point;
    if (fields.size() != 3) {
        throw refusal(path, line,
                      fmt::format("has {} values; a point has three coordinates", fields.size()));
    }
    for (int axis = 0; axis < 3; ++axis) {
        const std::string_view field = fields[static_cast<std::size_t>(axis)];
        const std::optional<double> value = csv_number(field);
        if (!value)
            throw refusal(path, line,
                          fmt::format("\"{}\" is not a coordinate; a finite number is expected",
                                      std::string(field)));
        point[axis] = *value;
    }
    return point;
}

std::vector<Vec3> read_csv(const fs::path& path, std::istream& file,
                           const std::optional<LengthUnit>& stated)
{
    std::string line;
    std::getline(file, line);
    const std::optional<LengthUnit> unit = unit_in_header(line);
    if (!unit) {
        throw refusal(path, 1,
                      fmt::format("\"{}\" is not the header of measured points; expected is "
                                  "x_mm,y_mm,z_mm (or m, cm, um)",
                                  line));
    }
    if (stated && stated->name != unit->name) {
        throw ConfigError(
            fmt::format("--length-unit {} stands beside the header of {}, which says "
                        "{}; leave it out",
                        stated->name, path.string(), unit->name));
    }
    std::vector<Vec3> points;
    for (int number = 2; std::getline(file, line); ++number) {
        if (line.empty() || line == "\r") continue;
        points.push_back(unit->metres * point_of(csv_fields(line), path, number));
    }
    return points;
}

std::vector<Vec3> read_xyz(const fs::path& path, std::istream& file, const LengthUnit& unit)
{
    std::vector<Vec3> points;
    std::string line;
    for (int number = 1; std::getline(file, line); ++number) {
        std::istringstream words(line);
        std::vector<std::string> values;
        for (std::string word; words >> word;)
            values.push_back(word);
        if (values.empty() || values.front().starts_with('#')) continue;
        points.push_back(unit.metres * point_of({values.begin(), values.end()}, path, number));
    }
    return points;
}

}  // namespace

std::vector<Vec3> read_measured_surface(const fs::path& path, const std::optional<LengthUnit>& unit)
{
    const std::string ending = lower_case_ending(path);
    if (ending != ".csv" && ending != ".xyz")
        return read_surface(path, required(unit, path)).points;
    std::ifstream file(path);
    if (!file) throw IoError(fmt::format("{} cannot be read", path.string()));
    std::vector<Vec3> points =
        ending == ".csv" ? read_csv(path, file, unit) : read_xyz(path, file, required(unit, path));
    if (file.bad()) throw IoError(fmt::format("{} cannot be read to its end", path.string()));
    return points;
}

}  // namespace braidzone
