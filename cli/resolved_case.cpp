#include "cli/resolved_case.hpp"

#include "core/quantity.hpp"

#include <fmt/format.h>

#include <cmath>

namespace braidzone {
namespace {

using Json = nlohmann::ordered_json;

Json length(double value)
{
    return format_quantity(value, Dimension::length);
}

Json point(const Vec3& value)
{
    return {length(value.x()), length(value.y()), length(value.z())};
}

Json centerline_end(const CenterlineEnd& end)
{
    if (const int* opening = std::get_if<int>(&end)) return *opening;
    return point(std::get<Vec3>(end));
}

Json straightening_section(const VesselStraightening& straightening)
{
    Json section = {{"share", straightening.share},
                    {"centre", length(straightening.centre)},
                    {"half_width", length(straightening.half_width)}};
    if (straightening.kept_to > straightening.kept_from) {
        section["kept_from"] = length(straightening.kept_from);
        section["kept_to"] = length(straightening.kept_to);
    }
    return section;
}

/// `true` and `false` for all and none, as cases without a list have it.
Json repairs(const Repairs& repairs)
{
    if (repairs == all_repairs) return true;
    if (repairs == Repairs{}) return false;
    return names_of(repairs);
}

Json opening_order(const OpeningOrder& order)
{
    const char* action = order.action == OpeningAction::keep  ? "keep"
                         : order.action == OpeningAction::cap ? "cap"
                                                              : "cut";
    return {{"at", centerline_end(order.at)}, {"do", action}};
}

Json vessel_section(const VesselSource& vessel)
{
    Json section = {{"surface", vessel.surface.string()},
                    {"length_unit", vessel.unit.name},
                    {"repair", repairs(vessel.repair)},
                    {"wall_offset", length(vessel.wall_offset)}};
    for (const OpeningOrder& order : vessel.openings)
        section["openings"].push_back(opening_order(order));
    if (vessel.straightening.share > 0.0)
        section["straightening"] = straightening_section(vessel.straightening);
    if (vessel.centerline) {
        section["centerline"] = vessel.centerline->string();
        section["centerline_line"] = vessel.centerline_line;
        section["reverse_centerline"] = vessel.reverse_centerline;
    }
    if (vessel.from) section["from"] = centerline_end(*vessel.from);
    if (vessel.to) section["to"] = centerline_end(*vessel.to);
    return section;
}

Json device_section(const FlowDiverter& device)
{
    const auto stiffness = [](double value) {
        return format_quantity(value, Dimension::stiffness);
    };
    Json section = {{"name", device.name},
                    {"diameter", length(device.nominal_diameter)},
                    {"length", length(device.nominal_length)},
                    {"any_size", true},  // the size was checked when the case was read
                    {"num_wires", device.num_wires},
                    {"wire_diameter", length(device.wire_diameter)},
                    {"braid_ratio", device.braid_ratio},
                    {"catheter_diameter", length(device.catheter_diameter)},
                    {"forces", force_source_name(device.forces)},
                    {"poisson_ratio", device.poisson_ratio},
                    {"distal_flare", length(device.distal_flare)},
                    {"proximal_flare", length(device.proximal_flare)},
                    {"flare_length", length(device.flare_length)}};
    // Values that are not known are 0 in the device and absent here.
    if (device.youngs_modulus > 0.0)
        section["youngs_modulus"] = format_quantity(device.youngs_modulus, Dimension::pressure);
    if (device.surface_coefficient > 0.0) {
        section["surface_coefficient"] = stiffness(device.surface_coefficient);
        section["radial_coefficient"] = stiffness(device.radial_coefficient);
        section["reference_node_area"] =
            format_quantity(device.reference_node_area, Dimension::area);
        section["force_scale"] = device.force_scale;
    }
    return section;
}

Json place(const PlaceOnCenterline& value)
{
    if (const double* arc_length = std::get_if<double>(&value)) return length(*arc_length);
    return point(std::get<Vec3>(value));
}

/// By name at the ends, where cases without the share have it.
void add_switch(Json& section, const SwitchKeys& keys, double share)
{
    if (share == 0.0 || share == 1.0) {
        section[std::string(keys.name_key)] = share == 0.0 ? keys.off : keys.on;
    } else {
        section[std::string(keys.share_key)] = share;
    }
}

void add_schedule(Json& section, const ReleaseSchedule& schedule)
{
    Json windows = Json::array();
    for (const PushPull& window : schedule.windows) {
        windows.push_back({{"from", length(window.from)},
                           {"to", length(window.to)},
                           {"spacing", window.spacing}});
    }
    if (!windows.empty()) section["push_pull"] = windows;
    add_switch(section, sliding_keys, schedule.sliding);
    for (const AxialTwist& twist : schedule.twists) {
        section["twist"].push_back({{"angle", format_quantity(twist.angle, Dimension::angle)},
                                    {"centre", length(twist.centre)},
                                    {"half_width", length(twist.half_width)}});
    }
    for (const IncompleteOpening& opening : schedule.incomplete_openings) {
        section["incomplete_opening"].push_back(
            {{"end", name_of(opening.end)},
             {"length", length(opening.length)},
             {"shrink", opening.shrink},
             {"lean", opening.lean},
             {"lean_angle", format_quantity(opening.lean_angle, Dimension::angle)}});
    }
    if (!schedule.table_file.empty()) section["spacing_table"] = schedule.table_file.string();
}

Json second_device_section(const SecondDevice& second)
{
    Json section = device_section(second.device);
    section["landing_distal"] = place(second.landing_distal);
    add_schedule(section, second.schedule);
    return section;
}

Json measurement_section(const Imaging& imaging)
{
    Json section = {{"voxel_size", length(imaging.chain.voxel_size)},
                    {"blur", length(imaging.chain.blur)},
                    {"threshold", imaging.chain.threshold},
                    {"blooming", length(imaging.blooming)},
                    {"shift", point(imaging.shift)},
                    {"pivot", point(imaging.pivot)}};
    for (int axis = 0; axis < 3; ++axis)
        section["rotation"].push_back(format_quantity(imaging.rotation[axis], Dimension::angle));
    return section;
}

Json deployment_section(const Case& job)
{
    const DeployOptions& options = job.deployment;
    Json section;
    section["landing_distal"] = place(job.landing_distal);
    section["lattice"] = name_of(options.lattice);
    section["axial"] = name_of(options.axial);
    section["release_order"] = name_of(options.release_order);
    section["motion"] = name_of(options.motion);
    add_switch(section, hub_freedom_keys, options.hub_freedom);
    section["hub_shift"] = length(options.hub_shift);
    section["hoop_migration"] = options.hoop_migration;
    if (std::isfinite(options.friction)) {
        section["friction"] = options.friction;
    } else {
        section["friction"] = "infinite";
    }
    if (std::isfinite(options.wall_stiffness)) {
        section["wall_stiffness"] =
            format_quantity(options.wall_stiffness, Dimension::wall_stiffness);
    }
    section["time_step_ratio"] = options.time_step_ratio;
    section["damping"] = format_quantity(options.damping, Dimension::damping);
    section["centre_rings"] = options.centre_rings;
    section["bending_ratio"] = options.bending_ratio;
    section["release_interval"] = options.release_interval;
    section["residual_tolerance"] = options.residual_tolerance;
    section["max_settling_steps"] = options.max_settling_steps;
    section["num_frames"] = options.num_frames;
    if (job.neck)
        section["neck"] = {{"from", length(job.neck->from)}, {"to", length(job.neck->to)}};
    add_schedule(section, job.schedule);
    return section;
}

/// The keys of one law, one overload for each that has any.
void add_law_keys(Json& section, const BraidStokesLaw& law)
{
    section["inertia"] = law.inertia;
}

void add_law_keys(Json& section, const MeasuredLaw& law)
{
    section["loss_table"] = law.table.string();
    section["bench_density"] = format_quantity(law.bench_fluid.density, Dimension::density);
    section["bench_viscosity"] =
        format_quantity(law.bench_fluid.viscosity, Dimension::dynamic_viscosity);
}

void add_law_keys(Json& section, const ConstantLaw& law)
{
    section["pressure_loss_linear"] = format_quantity(law.loss.linear, Dimension::linear_loss);
    section["pressure_loss_quadratic"] =
        format_quantity(law.loss.quadratic, Dimension::quadratic_loss);
}

template <typename Law>
void add_law_keys(Json& section, const Law& law)
{
    if constexpr (requires { law.fit_velocity; })
        section["fit_velocity"] = format_quantity(law.fit_velocity, Dimension::velocity);
}

Json porous_section(const Case& job)
{
    Json section = {{"law", law_name(job.law)}};
    std::visit([&](const auto& law) { add_law_keys(section, law); }, job.law);
    section["tangential_ratio"] = job.sheet.tangential_ratio;
    section["quadratic"] = job.sheet.quadratic == QuadraticDrag::normal_only ? "normal" : "speed";
    section["region"] = job.sheet.region == ResistanceRegion::whole_device ? "whole" : "free";
    return section;
}

void add_outlet_keys(Json& section, const OutletPressures& outlets)
{
    if (outlets.pressures.empty()) {
        section["outlets"] = "pressure";
        return;
    }
    for (const double pressure : outlets.pressures)
        section["outlet_pressures"].push_back(format_quantity(pressure, Dimension::pressure));
}

void add_outlet_keys(Json& section, const OutletShares& outlets)
{
    section["outlet_shares"] = outlets.shares;
}

void add_outlet_keys(Json& section, const MurraySplit&)
{
    section["outlets"] = "murray";
}

Json foam_section(const FoamCaseOptions& options)
{
    const FoamFlow& flow = options.flow;
    Json section = {{"format", "openfoam"}};
    if (flow.waveform) {
        section["waveform"] = flow.waveform->file.string();
        if (flow.waveform->scaled_to) {
            section["mean_flow_rate"] =
                format_quantity(*flow.waveform->scaled_to, Dimension::flow_rate);
        }
        section["cycles"] = flow.cycles;
        section["max_courant"] = flow.max_courant;
    } else {
        section["inlet_velocity"] = format_quantity(flow.inlet_velocity, Dimension::velocity);
    }
    std::visit([&](const auto& outlets) { add_outlet_keys(section, outlets); }, flow.outlets);
    section["coarse_cell"] = length(options.coarse_cell);
    section["surface_refinement"] = options.surface_refinement;
    section["device_refinement"] = options.device_refinement;
    section["form"] = traits_of(options.form).name;
    section["most_zones"] = options.most_zones;
    return section;
}

Json fluid_section(const Case& job)
{
    const auto as_viscosity = [](double value) {
        return format_quantity(value, Dimension::dynamic_viscosity);
    };
    Json section = {{"density", format_quantity(job.fluid.density, Dimension::density)},
                    {"viscosity", as_viscosity(job.fluid.viscosity)},
                    {"rheology", job.rheology ? "carreau-yasuda" : "newtonian"}};
    if (!job.rheology) return section;
    section["zero_shear_viscosity"] = as_viscosity(job.rheology->zero_shear_viscosity);
    section["infinite_shear_viscosity"] = as_viscosity(job.rheology->infinite_shear_viscosity);
    section["relaxation_time"] = format_quantity(job.rheology->relaxation_time, Dimension::time);
    section["power_index"] = job.rheology->power_index;
    section["yasuda_exponent"] = job.rheology->yasuda_exponent;
    return section;
}

Json surfaces_section(const SurfacesOptions& surfaces)
{
    Json parts = Json::array();
    for (const SurfacePart part : surfaces.parts)
        parts.push_back(surface_part_names()[static_cast<std::size_t>(part)]);
    const WireTubeOptions& wires = surfaces.wires;
    Json section = {
        {"format", "surfaces"},
        {"parts", parts},
        {"braid_pattern", braid_pattern_names()[static_cast<std::size_t>(wires.pattern.over - 1)]},
        {"wire_facets", wires.facets},
        {"wire_pieces", wires.pieces_per_arm},
        {"distance_spacing", length(surfaces.distance_spacing)}};
    // Absent: two wire diameters of each device.
    if (surfaces.shell_thickness > 0.0)
        section["shell_thickness"] = length(surfaces.shell_thickness);
    return section;
}

Json export_sections(const Exports& exports)
{
    Json sections = Json::array({{{"format", "vtk"}}, {{"format", "openvdb"}}});
    if (exports.openfoam) sections.push_back(foam_section(*exports.openfoam));
    if (exports.lattice) {
        std::vector<std::string> names;
        for (const LatticeTarget target : exports.lattice->targets)
            names.push_back(target_name(target));
        sections.push_back({{"format", "lattice"},
                            {"targets", names},
                            {"peak_velocity", format_quantity(exports.lattice->flow.peak_velocity,
                                                              Dimension::velocity)},
                            {"velocity_lu", exports.lattice->flow.velocity_lu},
                            {"openings", name_of(exports.lattice->openings)}});
    }
    if (exports.surfaces) sections.push_back(surfaces_section(*exports.surfaces));
    return sections;
}

bool is_array_of_tables(const Json& value)
{
    return value.is_array() && !value.empty() && value.front().is_object();
}

/// Writes a table as TOML: its values first, then its sub-tables. JSON's strings, numbers and
/// booleans are TOML's too.
void append_toml(std::string& text, const Json& table, const std::string& name)
{
    for (const auto& [key, value] : table.items()) {
        if (value.is_object() || is_array_of_tables(value)) continue;
        text += fmt::format("{} = {}\n", key, value.dump());
    }
    for (const auto& [key, value] : table.items()) {
        const std::string full_name = name.empty() ? key : name + "." + key;
        if (value.is_object()) {
            text += fmt::format("\n[{}]\n", full_name);
            append_toml(text, value, full_name);
        } else if (is_array_of_tables(value)) {
            for (const Json& element : value) {
                text += fmt::format("\n[[{}]]\n", full_name);
                append_toml(text, element, full_name);
            }
        }
    }
}

}  // namespace

Json resolved_case(const Case& job)
{
    Json all = {{"vessel", vessel_section(job.vessel)}, {"device", device_section(job.device)}};
    if (job.second_device) all["second_device"] = second_device_section(*job.second_device);
    all["deployment"] = deployment_section(job);
    all["fluid"] = fluid_section(job);
    all["porous"] = porous_section(job);
    all["grid"] = {{"spacing", length(job.deposit.spacing)},
                   {"kernel_half_width", job.deposit.kernel_half_width}};
    all["measurement"] = measurement_section(job.measurement);
    all["export"] = export_sections(job.exports);
    return all;
}

std::string resolved_case_text(const Case& job)
{
    std::string text;
    append_toml(text, resolved_case(job), "");
    return text;
}

}  // namespace braidzone
