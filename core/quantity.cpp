#include "core/quantity.hpp"

#include "core/error.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <numbers>
#include <vector>

namespace braidzone {
namespace {

/// A unit as a fraction of the SI unit. Dividing by 1e6, which a double holds exactly, makes 30 um
/// the double nearest to 3e-5; multiplying by 1e-6, which it does not, would miss it.
struct Unit {
    std::string_view name;
    double multiply_by = 1.0;
    double divide_by = 1.0;
};

struct DimensionUnits {
    std::string_view name;
    std::vector<Unit> units;  ///< SI unit first
};

const DimensionUnits& units_of(Dimension dimension)
{
    // Conventional millimetre of mercury: 133.322387415 Pa (ISO 80000-4:2019, annex).
    static const DimensionUnits length{
        "length", {{"m"}, {"cm", 1, 1e2}, {"mm", 1, 1e3}, {"um", 1, 1e6}, {"in", 254, 1e4}}};
    static const DimensionUnits area{
        "area", {{"m^2"}, {"cm^2", 1, 1e4}, {"mm^2", 1, 1e6}, {"um^2", 1, 1e12}}};
    static const DimensionUnits time{"time", {{"s"}, {"ms", 1, 1e3}}};
    static const DimensionUnits velocity{"velocity", {{"m/s"}, {"cm/s", 1, 1e2}, {"mm/s", 1, 1e3}}};
    static const DimensionUnits density{"density", {{"kg/m^3"}, {"g/cm^3", 1e3, 1}}};
    static const DimensionUnits viscosity{"dynamic viscosity",
                                          {{"Pa s"}, {"mPa s", 1, 1e3}, {"cP", 1, 1e3}}};
    static const DimensionUnits pressure{
        "pressure",
        {{"Pa"}, {"kPa", 1e3, 1}, {"MPa", 1e6, 1}, {"GPa", 1e9, 1}, {"mmHg", 133.322387415, 1}}};
    static const DimensionUnits force{"force", {{"N"}, {"mN", 1, 1e3}, {"uN", 1, 1e6}}};
    static const DimensionUnits stiffness{
        "stiffness", {{"N/m"}, {"mN/m", 1, 1e3}, {"N/mm", 1e3, 1}, {"mN/mm", 1, 1}}};
    static const DimensionUnits wall_stiffness{
        "pressure over displacement",
        {{"Pa/m"}, {"N/m^3"}, {"kPa/mm", 1e6, 1}, {"kPa/um", 1e9, 1}, {"MPa/mm", 1e9, 1}}};
    static const DimensionUnits flow_rate{
        "flow rate", {{"m^3/s"}, {"ml/s", 1, 1e6}, {"ml/min", 1, 60e6}, {"l/min", 1, 60e3}}};
    static const DimensionUnits angle{"angle", {{"rad"}, {"deg", std::numbers::pi, 180}}};
    static const DimensionUnits damping{"damping", {{"kg/s"}, {"N s/m"}}};
    static const DimensionUnits linear_loss{"linear loss", {{"Pa s/m"}}};
    static const DimensionUnits quadratic_loss{"quadratic loss", {{"Pa s^2/m^2"}, {"kg/m^3"}}};
    switch (dimension) {
        case Dimension::length:
            return length;
        case Dimension::area:
            return area;
        case Dimension::time:
            return time;
        case Dimension::velocity:
            return velocity;
        case Dimension::density:
            return density;
        case Dimension::dynamic_viscosity:
            return viscosity;
        case Dimension::pressure:
            return pressure;
        case Dimension::force:
            return force;
        case Dimension::stiffness:
            return stiffness;
        case Dimension::wall_stiffness:
            return wall_stiffness;
        case Dimension::flow_rate:
            return flow_rate;
        case Dimension::angle:
            return angle;
        case Dimension::damping:
            return damping;
        case Dimension::linear_loss:
            return linear_loss;
        case Dimension::quadratic_loss:
            return quadratic_loss;
    }
    return length;  // not reached: the switch is complete
}

std::string_view trimmed(std::string_view text)
{
    constexpr std::string_view white_space = " \t\r\n";
    const auto first = text.find_first_not_of(white_space);
    if (first == std::string_view::npos) return {};
    return text.substr(first, text.find_last_not_of(white_space) - first + 1);
}

}  // namespace

double parse_quantity(std::string_view text, Dimension dimension)
{
    const DimensionUnits& known = units_of(dimension);
    const auto refuse = [&](const std::string& finding) {
        return ConfigError(fmt::format("\"{}\" {}; expected is a number with a unit of {}: {}",
                                       text, finding, known.name, allowed_units(dimension)));
    };

    std::string_view number = trimmed(text);
    // from_chars knows no plus sign, and would take the minus after one.
    if (number.starts_with('+') && !number.starts_with("+-")) number.remove_prefix(1);
    double value = 0.0;
    const auto [end, error] = std::from_chars(number.data(), number.data() + number.size(), value);
    if (error == std::errc::invalid_argument) throw refuse("does not start with a number");
    if (error == std::errc::result_out_of_range || !std::isfinite(value)) {
        throw refuse("is not a finite number");
    }

    const std::string_view unit =
        trimmed(number.substr(static_cast<std::size_t>(end - number.data())));
    if (unit.empty()) throw refuse("has no unit");
    for (const Unit& candidate : known.units) {
        if (candidate.name != unit) continue;
        const double si = value * candidate.multiply_by / candidate.divide_by;
        if (!std::isfinite(si)) throw refuse("is not a finite number");
        return si;
    }
    throw refuse(fmt::format("has the unit \"{}\"", unit));
}

std::string format_quantity(double value, Dimension dimension)
{
    return fmt::format("{} {}", value, si_unit(dimension));
}

std::string_view si_unit(Dimension dimension)
{
    return units_of(dimension).units.front().name;
}

std::string allowed_units(Dimension dimension)
{
    std::string list;
    for (const Unit& unit : units_of(dimension).units) {
        if (!list.empty()) list += ", ";
        list += unit.name;
    }
    return list;
}

std::string_view dimension_name(Dimension dimension)
{
    return units_of(dimension).name;
}

}  // namespace braidzone
