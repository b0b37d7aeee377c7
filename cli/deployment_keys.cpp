#include "cli/deployment_keys.hpp"

#include "cli/key_checks.hpp"
#include "core/error.hpp"
#include "deploy/spacing_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace braidzone {
namespace {

template <typename Choice, std::size_t size = 2>
using Names = std::array<std::pair<Choice, std::string_view>, size>;

constexpr Names<LatticeKind> lattices{
    {{LatticeKind::crossings, "crossings"}, {LatticeKind::paper_2020, "paper-2020"}}};
constexpr Names<AxialMotion> axial_motions{
    {{AxialMotion::locked, "locked"}, {AxialMotion::free, "free"}}};
constexpr Names<DeviceEnd> device_ends{
    {{DeviceEnd::distal, "distal"}, {DeviceEnd::proximal, "proximal"}}};
constexpr Names<ReleaseOrder> release_orders{
    {{ReleaseOrder::ring_by_ring, "ring_by_ring"}, {ReleaseOrder::at_once, "at_once"}}};
constexpr Names<Motion, 3> motions{{{Motion::inertial, "inertial"},
                                    {Motion::quasi_static, "quasi_static"},
                                    {Motion::none, "none"}}};

template <typename Choice, std::size_t size>
std::string_view name_in(const Names<Choice, size>& names, Choice choice)
{
    return std::find_if(names.begin(), names.end(),
                        [&](const auto& entry) { return entry.first == choice; })
        ->second;
}

/// One of a few choices, by its name.
template <typename Choice, std::size_t size>
Choice read_choice(const TomlTable& table, const std::string& key, const Names<Choice, size>& names,
                   Choice fallback)
{
    std::vector<std::string> allowed;
    for (const auto& [choice, name] : names)
        allowed.emplace_back(name);
    const std::string chosen = one_of(table, key, std::string(name_in(names, fallback)), allowed);
    return std::find_if(names.begin(), names.end(),
                        [&](const auto& entry) { return entry.second == chosen; })
        ->first;
}

/// 0 to 1: a switch by the name of an end, or by a share.
double read_switch(const TomlTable& table, const SwitchKeys& keys)
{
    const std::string name_key(keys.name_key), share_key(keys.share_key);
    if (table.has(name_key) && table.has(share_key)) {
        throw ConfigError(
            fmt::format("{} = {:.6g} stands beside {}, which names one of its ends; "
                        "keep one of them",
                        table.where(share_key), table.number(share_key), name_key));
    }
    const std::string off(keys.off), on(keys.on);
    if (!table.has(share_key)) return one_of(table, name_key, off, {off, on}) == on ? 1.0 : 0.0;
    const double share = table.number(share_key);
    if (share >= 0.0 && share <= 1.0) return share;
    throw ConfigError(fmt::format("{} = {:.6g} is out of range; allowed are 0 ({}) to 1 ({})",
                                  table.where(share_key), share, off, on));
}

/// Checks what was read from a key, and tells the key's place if it is refused.
template <typename Values>
void validate_at(const TomlTable& table, const std::string& key, const Values& values)
{
    try {
        validate(values);
    } catch (const ConfigError& error) {
        throw ConfigError(fmt::format("{}: {}", table.where(key), error.what()));
    }
}

std::vector<AxialTwist> read_twists(const TomlTable& table)
{
    std::vector<AxialTwist> twists;
    for (const TomlTable& twist : table.tables("twist")) {
        twists.push_back({twist.quantity("angle", Dimension::angle),
                          twist.quantity("centre", Dimension::length),
                          twist.quantity("half_width", Dimension::length)});
    }
    validate_at(table, "twist", twists);
    return twists;
}

std::vector<IncompleteOpening> read_incomplete_openings(const TomlTable& table)
{
    std::vector<IncompleteOpening> openings;
    for (const TomlTable& opening : table.tables("incomplete_opening")) {
        openings.push_back({read_choice(opening, "end", device_ends, DeviceEnd::proximal),
                            opening.quantity("length", Dimension::length), opening.number("shrink"),
                            opening.number_or("lean", 0.0),
                            opening.quantity_or("lean_angle", Dimension::angle, 0.0)});
    }
    validate_at(table, "incomplete_opening", openings);
    return openings;
}

}  // namespace

PlaceOnCenterline read_place(const TomlTable& table, const std::string& key)
{
    if (table.is_array(key)) return table.point(key);
    return table.quantity(key, Dimension::length);
}

ReleaseSchedule read_schedule(const TomlTable& table)
{
    ReleaseSchedule schedule;
    for (const TomlTable& window : table.tables("push_pull")) {
        schedule.windows.push_back({window.quantity("from", Dimension::length),
                                    window.quantity("to", Dimension::length),
                                    window.number("spacing")});
    }
    schedule.sliding = read_switch(table, sliding_keys);
    schedule.twists = read_twists(table);
    schedule.incomplete_openings = read_incomplete_openings(table);
    if (table.has("spacing_table")) {
        schedule.table_file = (table.folder() / table.text("spacing_table")).lexically_normal();
        schedule.table = read_spacing_table(schedule.table_file);
    }
    validate_at(table, schedule.table.empty() ? "push_pull" : "spacing_table", schedule);
    return schedule;
}

namespace {

double read_friction(const TomlTable& table, double fallback)
{
    if (!table.has("friction")) return fallback;
    if (!table.is_text("friction"))
        return require_not_negative(table, "friction", table.number("friction"));
    return one_of(table, "friction", "", {"infinite", "none"}) == "none" ? 0.0 : infinite_friction;
}

void require_that_friction_matters(const TomlTable& table, const DeployOptions& options)
{
    if (options.friction == infinite_friction || options.axial == AxialMotion::free ||
        options.hoop_migration)
        return;
    throw ConfigError(
        fmt::format("{} = {:.6g} has no effect: no node can slide along the wall; allowed is "
                    "\"infinite\", or set deployment.axial = \"free\" or "
                    "deployment.hoop_migration = true",
                    table.where("friction"), options.friction));
}

/// What only a motion can give.
void require_motion_where_needed(const TomlTable& table, const DeployOptions& options)
{
    if (options.motion != Motion::none) return;
    if (options.hub_freedom > 0.0) {
        throw ConfigError(
            fmt::format("{} = \"none\" and hub_freedom = {:.6g} exclude each other: the shape of a "
                        "braid whose hubs move is found by its motion",
                        table.where("motion"), options.hub_freedom));
    }
    if (options.num_frames > 0) {
        throw ConfigError(
            fmt::format("{} = \"none\" leaves no shapes on the way for num_frames = {}",
                        table.where("motion"), options.num_frames));
    }
}

DeployOptions read_deploy_options(const TomlTable& table)
{
    DeployOptions options;
    options.lattice = read_choice(table, "lattice", lattices, options.lattice);
    options.axial = read_choice(table, "axial", axial_motions, options.axial);
    options.release_order =
        read_choice(table, "release_order", release_orders, options.release_order);
    options.motion = read_choice(table, "motion", motions, options.motion);
    options.hub_freedom = read_switch(table, hub_freedom_keys);
    options.hub_shift = require_not_negative(
        table, "hub_shift", table.quantity_or("hub_shift", Dimension::length, options.hub_shift));
    options.hoop_migration = table.boolean_or("hoop_migration", options.hoop_migration);
    options.friction = read_friction(table, options.friction);
    require_that_friction_matters(table, options);
    options.wall_stiffness =
        positive_or(table, "wall_stiffness", Dimension::wall_stiffness, options.wall_stiffness);
    options.centre_rings = table.boolean_or("centre_rings", options.centre_rings);
    // At 1 the scheme is at the limit of stability.
    options.time_step_ratio = require_positive(
        table, "time_step_ratio", table.number_or("time_step_ratio", options.time_step_ratio), 1.0);
    options.damping = positive_or(table, "damping", Dimension::damping, options.damping);
    options.bending_ratio = require_not_negative(
        table, "bending_ratio", table.number_or("bending_ratio", options.bending_ratio));
    options.release_interval =
        integer_in_range(table, "release_interval", options.release_interval, 1, 1000000);
    options.residual_tolerance =
        require_positive(table, "residual_tolerance",
                         table.number_or("residual_tolerance", options.residual_tolerance), 1.0);
    options.max_settling_steps =
        integer_in_range(table, "max_settling_steps", options.max_settling_steps, 1, 1000000000);
    options.num_frames = integer_in_range(table, "num_frames", options.num_frames, 0, 10000);
    require_motion_where_needed(table, options);
    return options;
}

std::optional<ArcRange> read_neck(const TomlTable& table)
{
    if (!table.has("neck")) return std::nullopt;
    const TomlTable neck = table.table("neck");
    const ArcRange range{neck.quantity("from", Dimension::length),
                         neck.quantity("to", Dimension::length)};
    if (range.from < range.to) return range;
    throw ConfigError(fmt::format("{} = {:.6g} mm must be greater than from = {:.6g} mm",
                                  neck.where("to"), 1e3 * range.to, 1e3 * range.from));
}

}  // namespace

DeploymentKeys read_deployment_keys(const TomlTable& table)
{
    return {read_place(table, "landing_distal"), read_schedule(table), read_deploy_options(table),
            read_neck(table)};
}

std::string_view name_of(LatticeKind lattice)
{
    return name_in(lattices, lattice);
}

std::string_view name_of(AxialMotion axial)
{
    return name_in(axial_motions, axial);
}

std::string_view name_of(ReleaseOrder order)
{
    return name_in(release_orders, order);
}

std::string_view name_of(Motion motion)
{
    return name_in(motions, motion);
}

std::string_view name_of(DeviceEnd end)
{
    return name_in(device_ends, end);
}

}  // namespace braidzone
