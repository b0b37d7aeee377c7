#include "deploy/device_file.hpp"

#include "core/error.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace braidzone {
namespace {

/// What is told about a device and not computed with: texts, or lists of texts.
constexpr std::array<std::string_view, 4> remarks = {"materials", "layers", "surface_porosity",
                                                     "pore_density"};

/// Two nominal sizes are the same if they differ by less than this part: sizes are stated to
/// 0.25 mm of at most 8 mm, so that rounding cannot confuse them.
constexpr double same_size = 1e-6;

bool is_same_size(double first, double second)
{
    return std::abs(first - second) <= same_size * second;
}

Confidence read_confidence(const TomlTable& table)
{
    const std::string word = table.text("confidence");
    if (word == "high") return Confidence::high;
    if (word == "medium") return Confidence::medium;
    if (word == "low") return Confidence::low;
    throw ConfigError(
        fmt::format("{} = \"{}\"; allowed are high, medium, low", table.where("confidence"), word));
}

BetweenSizes read_between(const TomlTable& table)
{
    const std::string word = table.text_or("between", "line");
    if (word == "line") return BetweenSizes::line;
    if (word == "step") return BetweenSizes::step;
    throw ConfigError(
        fmt::format("{} = \"{}\"; allowed are line, step", table.where("between"), word));
}

std::vector<double> read_values(const TomlTable& table, const DeviceParameter& parameter)
{
    if (!table.is_array("value")) {
        return {parameter.dimension ? table.quantity("value", *parameter.dimension)
                                    : table.number("value")};
    }
    return parameter.dimension ? table.quantities("value", *parameter.dimension)
                               : table.numbers("value");
}

SizedValue read_sized_value(const TomlTable& table, const DeviceParameter& parameter)
{
    SizedValue sized;
    sized.source = table.text("source");
    sized.confidence = read_confidence(table);
    sized.values = read_values(table, parameter);
    if (!table.is_array("value")) return sized;

    sized.diameters = table.quantities("at_diameter", Dimension::length);
    if (sized.values.empty() || sized.diameters.size() != sized.values.size()) {
        throw ConfigError(fmt::format("{} has {} diameters for {} values; one each is expected",
                                      table.where("at_diameter"), sized.diameters.size(),
                                      sized.values.size()));
    }
    if (std::adjacent_find(sized.diameters.begin(), sized.diameters.end(),
                           std::greater_equal<>()) != sized.diameters.end()) {
        throw ConfigError(fmt::format("{} is not increasing", table.where("at_diameter")));
    }
    if (table.has("fit")) {
        const TomlTable fit = table.table("fit");
        sized.between = BetweenSizes::fit;
        sized.fit_constant = fit.number("constant");
        sized.fit_per_diameter = fit.quantity("per_diameter", Dimension::length);
    } else {
        sized.between = read_between(table);
    }
    return sized;
}

/// "0.54 (2.5 mm), 0.48 (3 mm)" from the texts or numbers in the file.
std::string show_value(const TomlTable& table, bool is_text)
{
    if (!table.is_array("value")) {
        return is_text ? table.text("value") : fmt::format("{}", table.number("value"));
    }
    std::vector<std::string> shown;
    if (is_text) {
        shown = table.texts("value");
    } else {
        for (const double value : table.numbers("value"))
            shown.push_back(fmt::format("{}", value));
    }
    if (table.has("at_diameter")) {
        const std::vector<std::string> diameters = table.texts("at_diameter");
        for (std::size_t i = 0; i < shown.size(); ++i)
            shown[i] += " (" + diameters[i] + ")";
    }
    return fmt::format("{}", fmt::join(shown, ", "));
}

/// Those of a case file, and of the sizes between which values are stated.
KeyRanges device_file_ranges()
{
    const std::string smallest = "0.5 mm", largest = "60 mm";
    KeyRanges ranges = {{"nominal_diameters.value", smallest, largest},
                        {"nominal_lengths.value", "1 mm", "500 mm"}};
    for (const DeviceParameter& parameter : device_parameters()) {
        const std::string key(parameter.key);
        ranges.push_back(
            {key + ".value", std::string(parameter.lowest), std::string(parameter.highest)});
        ranges.push_back({key + ".at_diameter", smallest, largest});
        ranges.push_back({key + ".fit.constant", "-1e6", "1e6"});
        ranges.push_back({key + ".fit.per_diameter", "-1 m", "1 m"});
    }
    return ranges;
}

SourcedValue sourced(const TomlTable& table, const std::string& key, bool is_text)
{
    return {key, show_value(table, is_text), table.text("source"), read_confidence(table)};
}

}  // namespace

const std::vector<DeviceParameter>& device_parameters()
{
    using enum ParameterUse;
    static const std::vector<DeviceParameter> parameters = {
        {"num_wires", std::nullopt, geometry,
         [](FlowDiverter& d, double si) { d.num_wires = static_cast<int>(std::lround(si)); }, "4",
         "512"},
        {"wire_diameter", Dimension::length, geometry,
         [](FlowDiverter& d, double si) { d.wire_diameter = si; }, "1 um", "1 mm"},
        {"nominal_porosity", std::nullopt, porosity,
         [](FlowDiverter& d, double si) { d.braid_ratio = braid_ratio_at_porosity(d, si); }, "0.01",
         "0.99"},
        {"braid_ratio", std::nullopt, geometry,
         [](FlowDiverter& d, double si) { d.braid_ratio = si; }, "0.01", "10"},
        {"catheter_diameter", Dimension::length, geometry,
         [](FlowDiverter& d, double si) { d.catheter_diameter = si; }, "0.1 mm", "10 mm"},
        {"surface_coefficient", Dimension::stiffness, springs,
         [](FlowDiverter& d, double si) { d.surface_coefficient = si; }, "1e-4 N/m", "1e4 N/m"},
        {"radial_coefficient", Dimension::stiffness, springs,
         [](FlowDiverter& d, double si) { d.radial_coefficient = si; }, "1e-4 N/m", "1e4 N/m"},
        {"reference_node_area", Dimension::area, springs,
         [](FlowDiverter& d, double si) { d.reference_node_area = si; }, "1e-4 mm^2", "100 mm^2"},
        {"force_scale", std::nullopt, springs,
         [](FlowDiverter& d, double si) { d.force_scale = si; }, "1e-4", "1e5"},
        {"youngs_modulus", Dimension::pressure, wires,
         [](FlowDiverter& d, double si) { d.youngs_modulus = si; }, "1 MPa", "1000 GPa"},
        {"poisson_ratio", std::nullopt, optional,
         [](FlowDiverter& d, double si) { d.poisson_ratio = si; }, "0", "0.5"},
        {"distal_flare", Dimension::length, optional,
         [](FlowDiverter& d, double si) { d.distal_flare = si; }, "-10 mm", "10 mm"},
        {"proximal_flare", Dimension::length, optional,
         [](FlowDiverter& d, double si) { d.proximal_flare = si; }, "-10 mm", "10 mm"},
        {"flare_length", Dimension::length, optional,
         [](FlowDiverter& d, double si) { d.flare_length = si; }, "0 mm", "100 mm"},
    };
    return parameters;
}

std::vector<std::string> missing_for(ForceSource forces,
                                     const std::function<bool(std::string_view)>& is_known)
{
    const ParameterUse of_forces =
        forces == ForceSource::springs ? ParameterUse::springs : ParameterUse::wires;
    std::vector<std::string> missing;
    for (const DeviceParameter& parameter : device_parameters()) {
        if (parameter.use != ParameterUse::geometry && parameter.use != of_forces) continue;
        if (is_known(parameter.key)) continue;
        if (parameter.key == "braid_ratio" && is_known("nominal_porosity")) continue;
        missing.emplace_back(parameter.key);
    }
    return missing;
}

bool is_stated_at(const SizedValue& value, double diameter)
{
    if (value.diameters.empty() || value.between == BetweenSizes::step) return true;
    return std::any_of(value.diameters.begin(), value.diameters.end(),
                       [&](double known) { return is_same_size(diameter, known); });
}

double value_at(const SizedValue& value, double diameter)
{
    for (std::size_t i = 0; i < value.diameters.size(); ++i) {
        if (is_same_size(diameter, value.diameters[i])) return value.values[i];
    }
    if (value.values.size() == 1) return value.values.front();
    const auto& sizes = value.diameters;
    const auto above = std::upper_bound(sizes.begin(), sizes.end(), diameter) - sizes.begin();
    const auto last = static_cast<std::ptrdiff_t>(sizes.size()) - 1;
    const auto at = [](const std::vector<double>& list, std::ptrdiff_t i) {
        return list[static_cast<std::size_t>(i)];
    };
    switch (value.between) {
        case BetweenSizes::step:
            return at(value.values, std::max<std::ptrdiff_t>(above - 1, 0));
        case BetweenSizes::fit:
            return value.fit_constant + value.fit_per_diameter / diameter;
        case BetweenSizes::line:
            break;
    }
    const std::ptrdiff_t upper = std::clamp<std::ptrdiff_t>(above, 1, last), lower = upper - 1;
    const double fraction = (diameter - at(sizes, lower)) / (at(sizes, upper) - at(sizes, lower));
    return std::lerp(at(value.values, lower), at(value.values, upper), fraction);
}

DeviceFile read_device_file(const std::filesystem::path& path)
{
    const TomlTable root = TomlTable::read_file(path);
    DeviceFile file;
    DeviceModel& model = file.model;
    model.file = path;
    model.name = root.text("name");
    model.title = root.text("title");

    const auto read_sizes = [&](const std::string& key) {
        if (!root.has(key)) return std::vector<double>{};
        const TomlTable table = root.table(key);
        model.values.push_back(sourced(table, key, true));
        return table.quantities("value", Dimension::length);
    };
    model.nominal_diameters = read_sizes("nominal_diameters");
    model.nominal_lengths = read_sizes("nominal_lengths");

    for (const DeviceParameter& parameter : device_parameters()) {
        const std::string key(parameter.key);
        if (!root.has(key)) continue;
        const TomlTable table = root.table(key);
        file.parameters.emplace(key, read_sized_value(table, parameter));
        model.values.push_back(sourced(table, key, parameter.dimension.has_value()));
    }
    const auto is_known = [&](std::string_view key) { return file.parameters.contains(key); };
    for (const ForceSource source : {ForceSource::springs, ForceSource::wire_theory}) {
        if (missing_for(source, is_known).empty()) model.force_sources.push_back(source);
    }
    model.complete = !model.force_sources.empty();
    // The wires' modulus is the least that forces can come from.
    if (!model.complete) model.missing = missing_for(ForceSource::wire_theory, is_known);
    for (const std::string_view remark : remarks) {
        const std::string key(remark);
        if (root.has(key)) model.values.push_back(sourced(root.table(key), key, true));
    }
    root.finish();
    root.require_ranges(device_file_ranges());
    return file;
}

}  // namespace braidzone
