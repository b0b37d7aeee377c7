#include "cli/pressure_file.hpp"

#include "cli/changed_keys.hpp"
#include "cli/key_checks.hpp"
#include "cli/key_ranges.hpp"
#include "cli/porous_keys.hpp"
#include "core/error.hpp"
#include "deploy/device_library.hpp"

#include <fmt/format.h>

namespace braidzone {
namespace {

/// The device's diameter on the bench, or its braid ratio by what it covers at nominal diameter.
void read_density(const TomlTable& table, PressureBench& bench)
{
    bench.diameter =
        positive_or(table, "diameter", Dimension::length, bench.device.nominal_diameter);
    if (table.has("metal_coverage")) {
        if (table.has("diameter")) {
            throw ConfigError(fmt::format(
                "{} is what the device covers at nominal diameter and excludes bench.diameter; "
                "allowed is one of the two",
                table.where("metal_coverage")));
        }
        const double coverage =
            require_positive(table, "metal_coverage", table.number("metal_coverage"), 1.0);
        bench.device.braid_ratio = braid_ratio_at_porosity(bench.device, 1.0 - coverage);
    }
    bench.density_increase = table.number_or("density_increase", bench.density_increase);
    if (!(bench.density_increase > -1.0)) {
        throw ConfigError(fmt::format("{} = {:.6g} is out of range; allowed is more than -1",
                                      table.where("density_increase"), bench.density_increase));
    }
}

void read_bench(const TomlTable& table, PressureBench& bench)
{
    read_density(table, bench);
    bench.channel_diameter =
        positive_or(table, "channel_diameter", Dimension::length, bench.diameter);
    bench.gap_width =
        require_not_negative(table, "gap", table.quantity_or("gap", Dimension::length, 0.0));
    if (!(4.0 * bench.gap_width < bench.channel_diameter)) {
        throw ConfigError(fmt::format(
            "{} = {:.6g} mm is no narrow gap; allowed is less than channel_diameter / 4 = {:.6g} "
            "mm",
            table.where("gap"), 1e3 * bench.gap_width, 0.25e3 * bench.channel_diameter));
    }
    bench.second_layer =
        require_not_negative(table, "second_layer", table.number_or("second_layer", 0.0));
    bench.added_inertia = table.number_or("added_inertia", 0.0);
}

/// Refuses what is only found out by computing.
void require_braid(const std::filesystem::path& file, const PressureBench& bench)
{
    try {
        bench_loss(bench);
    } catch (const InputError& error) {
        throw ConfigError(fmt::format("{}: {}", file.string(), error.what()));
    }
}

}  // namespace

PressureFile read_pressure_file(const std::filesystem::path& file,
                                const std::vector<std::string>& overrides)
{
    const TomlTable root = TomlTable::read_file(file, overrides);
    PressureFile pressure;
    pressure.bench.device = read_device(root.table("device"), pressure.device_notes);
    pressure.bench.fluid = read_fluid(root.table_or_empty("fluid"));
    pressure.bench.law = read_law(root.table_or_empty("porous"));
    read_bench(root.table_or_empty("bench"), pressure.bench);
    root.finish();
    root.require_ranges(pressure_key_ranges());
    require_braid(file, pressure.bench);
    return pressure;
}

std::vector<std::string> changed_pressure_keys(const PressureBench& before,
                                               const PressureBench& after)
{
    ChangedKeys keys;
    keys.add("fluid.viscosity", before.fluid.viscosity, after.fluid.viscosity,
             Dimension::dynamic_viscosity);
    keys.add("bench.gap", before.gap_width, after.gap_width, Dimension::length);
    keys.add("bench.added_inertia", before.added_inertia, after.added_inertia);
    keys.add("bench.density_increase", before.density_increase, after.density_increase);
    keys.add("bench.second_layer", before.second_layer, after.second_layer);
    return keys.overrides();
}

}  // namespace braidzone
