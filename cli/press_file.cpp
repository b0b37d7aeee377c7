#include "cli/press_file.hpp"

#include "cli/changed_keys.hpp"
#include "cli/key_checks.hpp"
#include "cli/key_ranges.hpp"
#include "core/error.hpp"
#include "core/toml_reader.hpp"
#include "deploy/device_library.hpp"

#include <fmt/format.h>

#include <numbers>

namespace braidzone {
namespace {

PressBench read_bench(const TomlTable& table)
{
    PressBench bench;
    bench.notch_width = positive_or(table, "notch_width", Dimension::length, bench.notch_width);
    bench.notch_angle = positive_or(table, "notch_angle", Dimension::angle, bench.notch_angle);
    if (!(bench.notch_angle < std::numbers::pi)) {
        throw ConfigError(fmt::format("{} = {:.6g} deg is out of range; it must be less than 180",
                                      table.where("notch_angle"),
                                      bench.notch_angle * 180.0 / std::numbers::pi));
    }
    bench.edge_radius = require_not_negative(
        table, "edge_radius",
        table.quantity_or("edge_radius", Dimension::length, bench.edge_radius));
    const bool flat = one_of(table, "head", "cylinder", {"cylinder", "flat"}) == "flat";
    bench.head = flat ? PressHead::flat : PressHead::cylinder;
    bench.head_radius = positive_or(table, "head_radius", Dimension::length, bench.head_radius);
    return bench;
}

PressReading read_reading(const TomlTable& table)
{
    return {table.quantity_or("zero_offset", Dimension::length, 0.0),
            table.number_or("stiffening", 0.0)};
}

PressOptions read_options(const TomlTable& table)
{
    PressOptions options;
    options.bench = read_bench(table);
    options.stroke = positive_or(table, "stroke", Dimension::length, options.stroke);
    options.step = positive_or(table, "step", Dimension::length, options.step);
    options.load_step = positive_or(table, "load_step", Dimension::length, options.load_step);
    options.nodes_per_ring =
        integer_in_range(table, "nodes_per_ring", options.nodes_per_ring, 0, 100);
    options.bending_ratio = require_not_negative(
        table, "bending_ratio", table.number_or("bending_ratio", options.bending_ratio));
    options.surface_factor =
        require_positive(table, "surface_factor", table.number_or("surface_factor", 1.0));
    options.radial_factor =
        require_positive(table, "radial_factor", table.number_or("radial_factor", 1.0));
    options.friction =
        require_not_negative(table, "friction", table.number_or("friction", options.friction));
    options.reading = read_reading(table);
    options.residual_tolerance =
        require_positive(table, "residual_tolerance",
                         table.number_or("residual_tolerance", options.residual_tolerance), 1.0);
    return options;
}

}  // namespace

PressFile read_press_file(const std::filesystem::path& file,
                          const std::vector<std::string>& overrides)
{
    const TomlTable root = TomlTable::read_file(file, overrides);
    PressFile press;
    press.device = read_device(root.table("device"), press.device_notes);
    press.options = read_options(root.table_or_empty("press"));
    root.finish();
    root.require_ranges(press_key_ranges());
    return press;
}

std::vector<std::string> changed_press_keys(const FlowDiverter& device_before,
                                            const PressOptions& before,
                                            const FlowDiverter& device_after,
                                            const PressOptions& after)
{
    ChangedKeys keys;
    keys.add("device.wire_diameter", device_before.wire_diameter, device_after.wire_diameter,
             Dimension::length);
    keys.add("press.friction", before.friction, after.friction);
    keys.add("press.surface_factor", before.surface_factor, after.surface_factor);
    keys.add("press.radial_factor", before.radial_factor, after.radial_factor);
    keys.add("press.zero_offset", before.reading.zero_offset, after.reading.zero_offset,
             Dimension::length);
    keys.add("press.stiffening", before.reading.stiffening, after.reading.stiffening);
    return keys.overrides();
}

}  // namespace braidzone
