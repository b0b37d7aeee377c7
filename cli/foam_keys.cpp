#include "cli/foam_keys.hpp"

#include "cli/key_checks.hpp"
#include "core/error.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numeric>

namespace braidzone {
namespace {

void refuse_without_waveform(const TomlTable& table, const char* key)
{
    if (!table.has(key)) return;
    throw ConfigError(
        fmt::format("{} is for pulsatile flow; it needs a waveform", table.where(key)));
}

void read_inflow(const TomlTable& table, FoamFlow& flow)
{
    if (!table.has("waveform")) {
        refuse_without_waveform(table, "cycles");
        refuse_without_waveform(table, "max_courant");
        refuse_without_waveform(table, "mean_flow_rate");
        flow.inlet_velocity =
            positive_or(table, "inlet_velocity", Dimension::velocity, flow.inlet_velocity);
        return;
    }
    if (table.has("inlet_velocity")) {
        throw ConfigError(
            fmt::format("{} is for steady flow, but a waveform is given; keep one of them",
                        table.where("inlet_velocity")));
    }
    flow.waveform = read_flow_waveform(file_path(table, "waveform"));
    if (table.has("mean_flow_rate")) {
        const double mean = require_positive(
            table, "mean_flow_rate", table.quantity("mean_flow_rate", Dimension::flow_rate));
        flow.waveform = scaled_to_mean(*flow.waveform, mean);
    }
    flow.cycles = integer_in_range(table, "cycles", flow.cycles, 1, 100);
    flow.max_courant = require_positive(table, "max_courant",
                                        table.number_or("max_courant", flow.max_courant), 100.0);
}

OutletPressures read_pressures(const TomlTable& table)
{
    OutletPressures outlets{table.quantities("outlet_pressures", Dimension::pressure)};
    if (outlets.pressures.empty()) {
        throw ConfigError(fmt::format("{} is empty; one for each outlet is expected",
                                      table.where("outlet_pressures")));
    }
    return outlets;
}

OutletShares read_shares(const TomlTable& table)
{
    OutletShares outlets{table.numbers("outlet_shares")};
    for (const double share : outlets.shares)
        require_positive(table, "outlet_shares", share, 1.0);
    const double sum = std::accumulate(outlets.shares.begin(), outlets.shares.end(), 0.0);
    if (!(std::abs(sum - 1.0) <= share_tolerance)) {
        throw ConfigError(
            fmt::format("{} sum to {:.8g}; they must sum to 1", table.where("outlet_shares"), sum));
    }
    return outlets;
}

FoamOutlets read_outlets(const TomlTable& table)
{
    std::string given;
    for (const char* key : {"outlets", "outlet_pressures", "outlet_shares"}) {
        if (!table.has(key)) continue;
        if (!given.empty()) {
            throw ConfigError(
                fmt::format("{} is given beside {}; keep one of them", table.where(key), given));
        }
        given = key;
    }
    if (given == "outlet_pressures") return read_pressures(table);
    if (given == "outlet_shares") return read_shares(table);
    if (one_of(table, "outlets", "pressure", {"pressure", "murray"}) == "murray")
        return MurraySplit{};
    return OutletPressures{};
}

FoamForm read_form(const TomlTable& table, FoamForm fallback)
{
    std::vector<std::string> names;
    for (const FoamFormTraits& form : foam_forms())
        names.emplace_back(form.name);
    const std::string name = one_of(table, "form", traits_of(fallback).name, names);
    const auto found = std::find(names.begin(), names.end(), name);
    return foam_forms()[static_cast<std::size_t>(found - names.begin())].form;
}

}  // namespace

FoamCaseOptions read_foam_options(const TomlTable& table)
{
    FoamCaseOptions options;
    read_inflow(table, options.flow);
    options.flow.outlets = read_outlets(table);
    options.coarse_cell = positive_or(table, "coarse_cell", Dimension::length, options.coarse_cell);
    options.surface_refinement =
        integer_in_range(table, "surface_refinement", options.surface_refinement, 0, 6);
    options.device_refinement =
        integer_in_range(table, "device_refinement", options.device_refinement, 0, 6);
    options.form = read_form(table, options.form);
    options.most_zones = integer_in_range(table, "most_zones", options.most_zones, 1, 4096);
    return options;
}

}  // namespace braidzone
