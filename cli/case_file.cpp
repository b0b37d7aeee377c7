#include "cli/case_file.hpp"

#include "cli/foam_keys.hpp"
#include "cli/key_checks.hpp"
#include "cli/key_ranges.hpp"
#include "cli/porous_keys.hpp"
#include "core/error.hpp"
#include "core/nearest_name.hpp"
#include "core/toml_reader.hpp"
#include "deploy/device_library.hpp"
#include "export/vdb_labels.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace braidzone {
namespace {

std::optional<CenterlineEnd> read_end(const TomlTable& table, const std::string& key)
{
    if (!table.has(key)) return std::nullopt;
    if (table.is_array(key)) return table.point(key);
    const long opening = table.integer(key);
    if (opening < 0 || opening > 1000) {
        throw ConfigError(fmt::format("{} = {} is no number of an opening; the largest is 0",
                                      table.where(key), opening));
    }
    return static_cast<int>(opening);
}

/// `true`, `false` or a list of names.
Repairs read_repairs(const TomlTable& table)
{
    if (!table.has("repair")) return {};
    if (table.is_array("repair")) return repairs_at(some_of(table, "repair", repair_names()));
    return table.boolean("repair") ? all_repairs : Repairs{};
}

/// [[vessel.openings]], or the same as an array of inline tables.
std::vector<OpeningOrder> read_opening_orders(const TomlTable& vessel)
{
    std::vector<OpeningOrder> orders;
    for (const TomlTable& table : vessel.tables("openings")) {
        OpeningOrder order;
        if (table.is_array("at")) {
            order.at = table.point("at");
        } else {
            order.at = integer_in_range(table, "at", 0, 0, 1000);
        }
        table.text("do");  // required, without a default
        const std::string action = one_of(table, "do", "", {"keep", "cap", "cut"});
        order.action = action == "cut"   ? OpeningAction::cut
                       : action == "cap" ? OpeningAction::cap
                                         : OpeningAction::keep;
        orders.push_back(order);
    }
    return orders;
}

VesselStraightening read_straightening(const TomlTable& vessel)
{
    VesselStraightening straightening;
    if (!vessel.has("straightening")) return straightening;
    const TomlTable table = vessel.table("straightening");
    straightening.share = table.number("share");
    straightening.centre = table.quantity("centre", Dimension::length);
    straightening.half_width = table.quantity("half_width", Dimension::length);
    straightening.kept_from = table.quantity_or("kept_from", Dimension::length, 0.0);
    straightening.kept_to = table.quantity_or("kept_to", Dimension::length, 0.0);
    if (table.has("kept_from") != table.has("kept_to")) {
        throw ConfigError(
            fmt::format("{} is given without its counterpart; a kept stretch needs kept_from and "
                        "kept_to",
                        table.where(table.has("kept_from") ? "kept_from" : "kept_to")));
    }
    try {
        validate(straightening);
    } catch (const ConfigError& error) {
        throw ConfigError(fmt::format("{}: {}", vessel.where("straightening"), error.what()));
    }
    return straightening;
}

VesselSource read_vessel(const TomlTable& table)
{
    VesselSource vessel;
    vessel.surface = file_path(table, "surface");
    const std::string unit = table.text("length_unit");
    try {
        vessel.unit = length_unit(unit);
    } catch (const ConfigError& error) {
        throw ConfigError(fmt::format("{} = {}", table.where("length_unit"), error.what()));
    }
    vessel.repair = read_repairs(table);
    vessel.openings = read_opening_orders(table);
    vessel.wall_offset = table.quantity_or("wall_offset", Dimension::length, 0.0);
    vessel.straightening = read_straightening(table);
    if (table.has("centerline")) vessel.centerline = file_path(table, "centerline");
    vessel.centerline_line = integer_in_range(table, "centerline_line", -1, -1, 1000000);
    vessel.reverse_centerline = table.boolean_or("reverse_centerline", false);
    vessel.from = read_end(table, "from");
    vessel.to = read_end(table, "to");

    if (vessel.from.has_value() != vessel.to.has_value()) {
        throw ConfigError(
            fmt::format("{} is given without its counterpart; needed are "
                        "vessel.from and vessel.to",
                        table.where(vessel.from ? "from" : "to")));
    }
    for (const std::string key : {"centerline_line", "reverse_centerline"}) {
        if (vessel.from && table.has(key)) {
            throw ConfigError(
                fmt::format("{} and vessel.from both tell which line is meant and "
                            "where it begins; keep one of them",
                            table.where(key)));
        }
    }
    for (const std::string key : {"centerline_line", "reverse_centerline"}) {
        if (!vessel.centerline && table.has(key)) {
            throw ConfigError(
                fmt::format("{} is for a centerline from a file, but "
                            "vessel.centerline is missing",
                            table.where(key)));
        }
    }
    return vessel;
}

/// Shear-thinning blood; none for a Newtonian fluid.
std::optional<CarreauYasuda> read_rheology(const TomlTable& table)
{
    const std::string name =
        one_of(table, "rheology", "newtonian", {"newtonian", "carreau-yasuda"});
    if (name == "newtonian") return std::nullopt;
    CarreauYasuda blood;
    const auto read_viscosity = [&](const char* key, double& value) {
        value = positive_or(table, key, Dimension::dynamic_viscosity, value);
    };
    read_viscosity("zero_shear_viscosity", blood.zero_shear_viscosity);
    read_viscosity("infinite_shear_viscosity", blood.infinite_shear_viscosity);
    blood.relaxation_time =
        positive_or(table, "relaxation_time", Dimension::time, blood.relaxation_time);
    blood.power_index = table.number_or("power_index", blood.power_index);
    blood.yasuda_exponent = table.number_or("yasuda_exponent", blood.yasuda_exponent);
    try {
        validate(blood);
    } catch (const InputError& error) {
        throw ConfigError(
            fmt::format("{} = \"{}\": {}", table.where("rheology"), name, error.what()));
    }
    return blood;
}

SheetOptions read_sheet_options(const TomlTable& table)
{
    SheetOptions options;
    options.tangential_ratio = require_not_negative(
        table, "tangential_ratio", table.number_or("tangential_ratio", options.tangential_ratio));
    const bool normal = one_of(table, "quadratic", "speed", {"speed", "normal"}) == "normal";
    options.quadratic = normal ? QuadraticDrag::normal_only : QuadraticDrag::whole_velocity;
    const bool whole = one_of(table, "region", "free", {"free", "whole"}) == "whole";
    options.region = whole ? ResistanceRegion::whole_device : ResistanceRegion::free_of_wall;
    return options;
}

DepositOptions read_grid(const TomlTable& table)
{
    DepositOptions options;
    options.spacing = positive_or(table, "spacing", Dimension::length, options.spacing);
    options.kernel_half_width =
        integer_in_range(table, "kernel_half_width", options.kernel_half_width, 1, 100);
    return options;
}

OpeningFaces read_opening_faces(const TomlTable& table)
{
    std::vector<std::string> names;
    for (const OpeningFaces faces : all_opening_faces)
        names.emplace_back(name_of(faces));
    const std::string name = one_of(table, "openings", names.front(), names);
    const auto found = std::find(names.begin(), names.end(), name);
    return all_opening_faces[static_cast<std::size_t>(found - names.begin())];
}

LatticeExportOptions read_lattice_options(const TomlTable& table)
{
    LatticeExportOptions options;
    options.flow.peak_velocity =
        positive_or(table, "peak_velocity", Dimension::velocity, options.flow.peak_velocity);
    options.flow.velocity_lu = require_positive(
        table, "velocity_lu", table.number_or("velocity_lu", options.flow.velocity_lu),
        highest_velocity_lu);
    options.openings = read_opening_faces(table);
    if (!table.has("targets")) return options;
    std::vector<std::string> names;
    for (const LatticeTarget target : all_lattice_targets())
        names.push_back(target_name(target));
    options.targets.clear();
    for (const std::size_t place : some_of(table, "targets", names))
        options.targets.push_back(all_lattice_targets()[place]);
    return options;
}

/// @param spacing  of the voxel fields, which the signed distance has by default [m]
SurfacesOptions read_surfaces_options(const TomlTable& table, double spacing)
{
    SurfacesOptions options;
    if (table.has("parts")) {
        options.parts.clear();
        for (const std::size_t place : some_of(table, "parts", surface_part_names()))
            options.parts.push_back(static_cast<SurfacePart>(place));
    }
    const std::vector<std::string> patterns = braid_pattern_names();
    const auto default_pattern = static_cast<std::size_t>(options.wires.pattern.over - 1);
    const std::string pattern = one_of(table, "braid_pattern", patterns[default_pattern], patterns);
    options.wires.pattern.over =
        1 +
        static_cast<int>(std::find(patterns.begin(), patterns.end(), pattern) - patterns.begin());
    options.wires.facets = integer_in_range(table, "wire_facets", options.wires.facets, 3, 64);
    options.wires.pieces_per_arm =
        integer_in_range(table, "wire_pieces", options.wires.pieces_per_arm, 2, 64);
    if (table.has("shell_thickness"))
        options.shell_thickness = positive_or(table, "shell_thickness", Dimension::length, 0.0);
    options.distance_spacing = positive_or(table, "distance_spacing", Dimension::length, spacing);
    return options;
}

/// @param spacing  of the voxel fields [m]
Exports read_exports(const std::vector<TomlTable>& tables, double spacing)
{
    if (tables.empty()) return {.openfoam = FoamCaseOptions{}};
    Exports exports;
    std::vector<std::string> seen;
    for (const TomlTable& table : tables) {
        table.text("format");  // required here, without a default
        const std::string format =
            one_of(table, "format", "", {"vtk", "openvdb", "openfoam", "lattice", "surfaces"});
        if (std::find(seen.begin(), seen.end(), format) != seen.end()) {
            throw ConfigError(
                fmt::format("{} = \"{}\" is given twice", table.where("format"), format));
        }
        seen.push_back(format);
        if (format == "openfoam") exports.openfoam = read_foam_options(table);
        if (format == "lattice") exports.lattice = read_lattice_options(table);
        if (format == "surfaces") exports.surfaces = read_surfaces_options(table, spacing);
    }
    return exports;
}

Imaging read_measurement(const TomlTable& table)
{
    Imaging imaging;
    imaging.chain.voxel_size = table.quantity_or("voxel_size", Dimension::length, 0.0);
    imaging.chain.blur = table.quantity_or("blur", Dimension::length, 0.0);
    imaging.chain.threshold = table.number_or("threshold", imaging.chain.threshold);
    validate(imaging.chain);
    imaging.blooming = table.quantity_or("blooming", Dimension::length, 0.0);
    if (table.has("shift")) imaging.shift = table.point("shift");
    if (table.has("pivot")) imaging.pivot = table.point("pivot");
    if (!table.has("rotation")) return imaging;
    const std::vector<double> angles = table.quantities("rotation", Dimension::angle);
    if (angles.size() != 3) {
        throw ConfigError(fmt::format("{} has {} angles; three are needed, about x, y and z",
                                      table.where("rotation"), angles.size()));
    }
    imaging.rotation = Vec3(angles[0], angles[1], angles[2]);
    return imaging;
}

std::optional<SecondDevice> read_second_device(const TomlTable& root)
{
    if (!root.has("second_device")) return std::nullopt;
    const TomlTable table = root.table("second_device");
    SecondDevice second;
    second.device = read_device(table, second.notes);
    second.landing_distal = read_place(table, "landing_distal");
    second.schedule = read_schedule(table);
    return second;
}

}  // namespace

Case read_case(const std::filesystem::path& file, const std::vector<std::string>& overrides)
{
    const TomlTable root = TomlTable::read_file(file, overrides);
    Case job;
    job.file = std::filesystem::absolute(file).lexically_normal();
    job.vessel = read_vessel(root.table("vessel"));
    job.device = read_device(root.table("device"), job.device_notes);
    const DeploymentKeys deployment = read_deployment_keys(root.table("deployment"));
    job.landing_distal = deployment.landing_distal;
    job.schedule = deployment.schedule;
    job.deployment = deployment.options;
    job.neck = deployment.neck;
    job.second_device = read_second_device(root);
    const TomlTable fluid = root.table_or_empty("fluid");
    job.fluid = read_fluid(fluid);
    job.rheology = read_rheology(fluid);
    const TomlTable porous = root.table_or_empty("porous");
    job.law = read_law(porous);
    job.sheet = read_sheet_options(porous);
    job.deposit = read_grid(root.table_or_empty("grid"));
    job.exports = read_exports(root.tables("export"), job.deposit.spacing);
    job.measurement = read_measurement(root.table_or_empty("measurement"));
    root.finish();
    root.require_ranges(case_key_ranges());
    require_vdb_spacing("grid.spacing", job.deposit.spacing, job.vessel.unit);
    if (job.exports.surfaces) {
        require_possible_wires(job.device, *job.exports.surfaces);
        if (job.second_device)
            require_possible_wires(job.second_device->device, *job.exports.surfaces);
    }
    return job;
}

}  // namespace braidzone
