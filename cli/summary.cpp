#include "cli/summary.hpp"

#include "cli/case_hash.hpp"
#include "cli/case_notes.hpp"
#include "cli/library_versions.hpp"
#include "cli/resolved_case.hpp"
#include "core/file_hash.hpp"
#include "deploy/deployment_measures.hpp"
#include "deploy/opening_kind.hpp"
#include "deploy/wire_stretch.hpp"
#include "porous/braid_surface.hpp"

#include <fmt/format.h>
#include <sys/resource.h>

#include <algorithm>
#include <fstream>

namespace braidzone {
namespace {

using Json = nlohmann::ordered_json;

Json quantity(double value, const char* unit)
{
    return {{"value", value}, {"unit", unit}};
}

Json quantity(int value, const char* unit)
{
    return {{"value", value}, {"unit", unit}};
}

Json quantity(const std::optional<double>& value, const char* unit)
{
    return value ? quantity(*value, unit) : Json(nullptr);
}

/// Largest resident set of this process so far [B] (getrusage gives KiB on Linux).
double peak_memory()
{
    rusage usage{};
    ::getrusage(RUSAGE_SELF, &usage);
    return 1024.0 * static_cast<double>(usage.ru_maxrss);
}

/// A device at rest, with what is measured on it.
struct DeployedDevice {
    const FlowDiverter& device;
    const Deployment& deployment;
    const std::vector<WallOpening>& openings;
    const ResistanceSheet& sheet;
};

/// One figure of a zone, or null where the zone is absent.
Json of_zone(const std::optional<ZoneMeasures>& zone, double ZoneMeasures::*figure,
             const char* unit)
{
    return zone ? quantity((*zone).*figure, unit) : Json(nullptr);
}

Json of_gaps(const std::optional<GapMeasures>& gaps, double GapMeasures::*figure)
{
    return gaps ? quantity((*gaps).*figure, "m") : Json(nullptr);
}

Json device_quantities(const DeployedDevice& deployed, const WallTree& wall)
{
    const DeploymentMeasures device = measure(deployed.deployment, deployed.device, wall,
                                              wall_gap(deployed.device), deployed.openings);
    const BraidMeasures braid =
        measure(deployed.sheet.surface, neck_parts(deployed.deployment, deployed.openings));
    const WireStretch stretch = wire_stretch(deployed.deployment);
    constexpr auto contact = &ZoneMeasures::contact_area_fraction;
    constexpr auto force = &ZoneMeasures::radial_force_per_length;
    const auto neck_end = [&](double ArcRange::*end) {
        return device.neck_range ? quantity((*device.neck_range).*end, "m") : Json(nullptr);
    };
    return {
        {"implanted_length", quantity(device.implanted_length, "m")},
        {"resting_length", quantity(device.resting_length, "m")},
        {"foreshortening", quantity(device.foreshortening, "1")},
        {"foreshortening_label", quantity(device.foreshortening_label, "1")},
        {"mean_radial_expansion", quantity(device.mean_radial_expansion, "m")},
        {"mean_radial_expansion_neck", quantity(device.mean_radial_expansion_neck, "m")},
        {"mean_density_increase", quantity(braid.mean_density_increase, "1")},
        {"mean_density_increase_neck", quantity(braid.mean_density_increase_neck, "1")},
        {"mean_density_increase_neck_rings", quantity(braid.mean_density_increase_neck_rings, "1")},
        {"mean_contact_pressure", quantity(device.mean_contact_pressure, "Pa")},
        {"mean_contact_pressure_reference", quantity(device.mean_contact_pressure_reference, "Pa")},
        {"max_contact_pressure", quantity(device.max_contact_pressure, "Pa")},
        {"radial_force_per_length", quantity(device.radial_force_per_length, "N/m")},
        {"radial_force_per_length_distal", of_zone(device.distal_landing, force, "N/m")},
        {"radial_force_per_length_neck", of_zone(device.neck, force, "N/m")},
        {"radial_force_per_length_proximal", of_zone(device.proximal_landing, force, "N/m")},
        {"contact_area_fraction", quantity(device.contact_area_fraction, "1")},
        {"contact_area_fraction_distal", of_zone(device.distal_landing, contact, "1")},
        {"contact_area_fraction_neck", of_zone(device.neck, contact, "1")},
        {"contact_area_fraction_proximal", of_zone(device.proximal_landing, contact, "1")},
        {"malapposed_area", quantity(device.malapposed_area, "m^2")},
        {"malapposition_gap_mean", of_gaps(device.malapposition_gap, &GapMeasures::mean)},
        {"malapposition_gap_95", of_gaps(device.malapposition_gap, &GapMeasures::percentile_95)},
        {"malapposition_gap_max", of_gaps(device.malapposition_gap, &GapMeasures::max)},
        {"neck_from", neck_end(&ArcRange::from)},
        {"neck_to", neck_end(&ArcRange::to)},
        {"neck_area", quantity(device.neck_area, "m^2")},
        {"mean_metal_coverage", quantity(braid.mean_metal_coverage, "1")},
        {"mean_metal_coverage_neck", quantity(braid.mean_metal_coverage_neck, "1")},
        {"mean_pore_density_neck", quantity(braid.mean_pore_density_neck, "1/m^2")},
        {"wire_length", quantity(braid.wire_length, "m")},
        {"wire_stretch", quantity(stretch.total, "1")},
        {"wire_stretch_lowest", quantity(stretch.lowest, "1")},
        {"wire_stretch_highest", quantity(stretch.highest, "1")},
        {"metal_volume", quantity(braid.metal_volume, "m^3")},
        {"device_area", quantity(braid.device_area, "m^2")},
        {"resistance_integral_surface", quantity(resistance_integral(deployed.sheet), "m")},
        {"max_force_residual", quantity(deployed.deployment.max_force_residual, "N")},
        {"inverted_rhombi", quantity(device.inverted_rhombi, "1")},
        {"nodes_outside_vessel", quantity(device.nodes_outside_vessel, "1")},
    };
}

Json lattice_of(const Deployment& deployment)
{
    return {{"num_rings", deployment.lattice.num_rings},
            {"nodes_per_ring", deployment.lattice.nodes_per_ring},
            {"steps", deployment.steps},
            {"force_tolerance", quantity(deployment.force_tolerance, "N")}};
}

/// Thickness of the layer that an opening's permeability is stated for [m]: two wires crossing.
double layer_thickness(const FlowDiverter& device)
{
    return 2.0 * device.wire_diameter;
}

/// A device's resistance over an opening as that of a uniform layer, dp = (mu / k U + 1/2 rho C2
/// U^2) t: k = mu t / a and C2 = 2 b / (rho t), with a and b of its law, averaged by area.
Json layer_over(const DeployedDevice& deployed, const std::vector<NeckPart>& parts)
{
    std::optional<double> permeability, inertia;
    double area = 0.0, linear = 0.0, quadratic = 0.0;
    const ResistanceSheet& sheet = deployed.sheet;
    for (std::size_t rhombus = 0; rhombus < sheet.losses.size(); ++rhombus) {
        if (parts[rhombus] != NeckPart::over) continue;
        area += sheet.surface.rhombi[rhombus].area;
        linear += sheet.surface.rhombi[rhombus].area * sheet.losses[rhombus].linear;
        quadratic += sheet.surface.rhombi[rhombus].area * sheet.losses[rhombus].quadratic;
    }
    const double thickness = layer_thickness(deployed.device);
    if (linear > 0.0) permeability = sheet.fluid.viscosity * thickness * area / linear;
    if (area > 0.0) inertia = 2.0 * quadratic / area / (sheet.fluid.density * thickness);
    return {{"layer_thickness", quantity(thickness, "m")},
            {"permeability", quantity(permeability, "m^2")},
            {"inertial_resistance", quantity(inertia, "1/m")}};
}

Json opening_of(const DeployedDevice& deployed, WallOpening opening)
{
    const Deployment& deployment = deployed.deployment;
    const auto place = [&](int ring) {
        return deployment.ring_arc_length[static_cast<std::size_t>(ring)];
    };
    const Vec3 middle = middle_of(opening, deployment);
    const OpeningEnds ends = ends_of(opening, deployment.lattice);
    Json device_ends = Json::array();
    if (ends.distal) device_ends.push_back("distal");
    if (ends.proximal) device_ends.push_back("proximal");
    Json json = {{"kind", name_of(opening.kind)},
                 {"from", quantity(place(opening.proximal_ring), "m")},
                 {"to", quantity(place(opening.distal_ring), "m")},
                 {"point", {{"value", {middle.x(), middle.y(), middle.z()}}, {"unit", "m"}}},
                 {"area", quantity(opening.area, "m^2")},
                 {"num_nodes", opening.nodes.size()},
                 {"vessel_openings", opening.vessel_openings},
                 {"device_ends", device_ends},
                 {"in_sac", opening.in_sac}};
    // The figures of a neck, of whatever lies behind.
    opening.kind = OpeningKind::sac;
    const std::vector<NeckPart> parts = neck_parts(deployment, {opening});
    const BraidMeasures braid = measure(deployed.sheet.surface, parts);
    json["metal_coverage"] = quantity(braid.mean_metal_coverage_neck, "1");
    json["pore_density"] = quantity(braid.mean_pore_density_neck, "1/m^2");
    json.update(layer_over(deployed, parts));
    return json;
}

/// The parts of the device behind which the vessel opens, the neck first.
Json openings_of(const DeployedDevice& deployed)
{
    Json openings = Json::array();
    for (const WallOpening& opening : deployed.openings)
        openings.push_back(opening_of(deployed, opening));
    return openings;
}

/// What belongs to the run rather than to one of its devices.
Json run_quantities(const Chain& chain, const Progress& progress)
{
    std::optional<double> field_integral;
    if (chain.field) field_integral = resistance_integral(*chain.field);
    return {
        {"resistance_integral_surface", quantity(resistance_integral(chain.resistance), "m")},
        {"resistance_integral_field", quantity(field_integral, "m")},
        {"time_deploy", quantity(progress.seconds("deploy"), "s")},
        {"time_porous", quantity(progress.seconds("porous"), "s")},
        {"time_export", quantity(progress.seconds("export"), "s")},
        {"peak_memory", quantity(peak_memory(), "B")},
    };
}

Json inputs_of(const Case& job)
{
    Json inputs = Json::array();
    for (const InputFile& input : input_files(job)) {
        inputs.push_back({{"role", input.role},
                          {"file", input.path.string()},
                          {"sha256", sha256_of_file(input.path)}});
    }
    return inputs;
}

std::vector<std::string> warnings(const Case& job, const Chain& chain)
{
    std::vector<std::string> all = job.device_notes;
    const auto add = [&](const std::vector<std::string>& more) {
        all.insert(all.end(), more.begin(), more.end());
    };
    if (job.second_device) {
        // What holds for both devices is said once.
        for (const std::string& note : job.second_device->notes) {
            if (std::find(all.begin(), all.end(), note) == all.end())
                all.push_back(fmt::format("second {}", note));
        }
    }
    add(chain.vessel.notes);
    add(chain.centerline_notes);
    add(chain_notes(job, chain));
    if (job.neck && chain.openings.front().nodes.empty()) {
        all.push_back(fmt::format(
            "deployment.neck = {:.6g} to {:.6g} mm: the vessel does not open there; figures of the "
            "neck itself are null, those of its zone are of all that stretch",
            1e3 * job.neck->from, 1e3 * job.neck->to));
    }
    return all;
}

}  // namespace

Json summarise(const Case& job, const Chain& chain, const Progress& progress,
               const std::vector<std::string>& files, const std::vector<std::string>& export_notes)
{
    Json stages = Json::object();
    for (const StageTime& time : progress.times()) {
        stages[time.stage] = quantity(time.seconds, "s");
    }
    const DeployedDevice first{job.device, chain.deployment, chain.openings, chain.sheet};
    Json quantities = device_quantities(first, chain.wall);
    quantities.update(run_quantities(chain, progress));
    Json summary = {{"program", program_name},
                    {"quantities", quantities},
                    {"force_origin", force_origin(job.device)},
                    {"openings", openings_of(first)},
                    {"lattice", lattice_of(chain.deployment)}};
    if (chain.second) {
        const DeployedDevice second{job.second_device->device, chain.second->deployment,
                                    chain.second->openings, chain.second->sheet};
        summary["second_device"] = {{"quantities", device_quantities(second, chain.wall)},
                                    {"force_origin", force_origin(second.device)},
                                    {"openings", openings_of(second)},
                                    {"lattice", lattice_of(second.deployment)}};
    }
    summary["case"] = resolved_case(job);
    summary["inputs"] = inputs_of(job);
    summary["case_hash"] = case_hash(job);
    summary["versions"] = library_versions();
    summary["stages"] = stages;
    summary["files"] = files;
    std::vector<std::string> all_warnings = warnings(job, chain);
    all_warnings.insert(all_warnings.end(), export_notes.begin(), export_notes.end());
    summary["warnings"] = all_warnings;
    return summary;
}

std::string short_summary(const Json& summary)
{
    const Json& quantities = summary["quantities"];
    std::string text;
    const auto line = [&](const char* label, const char* name, double scale, const char* unit) {
        const Json& quantity = quantities[name];
        const std::string value =
            quantity.is_null()
                ? "none"
                : fmt::format("{:.4g} {}", scale * quantity["value"].get<double>(), unit);
        text += fmt::format("  {:<28}{}\n", label, value);
    };
    line("implanted length", "implanted_length", 1e3, "mm");
    line("mean radial expansion", "mean_radial_expansion", 1e3, "mm");
    line("in contact with the wall", "contact_area_fraction", 1e2, "% of its area");
    line("mean contact pressure", "mean_contact_pressure", 1.0 / 133.322387415, "mmHg");
    line("change of wire length", "wire_stretch", 1e2, "%");
    line("metal coverage", "mean_metal_coverage", 1e2, "%");
    line("metal coverage at the neck", "mean_metal_coverage_neck", 1e2, "%");
    line("pore density at the neck", "mean_pore_density_neck", 1e-6, "per mm2");
    double seconds = 0.0;
    for (const auto& [stage, time] : summary["stages"].items()) {
        seconds += time["value"].get<double>();
    }
    text += fmt::format("  {:<28}{:.2f} s\n", "wall time", seconds);
    for (const auto& warning : summary["warnings"]) {
        text += fmt::format("  note: {}\n", warning.get<std::string>());
    }
    return text;
}

bool is_summary_of_a_run(const std::filesystem::path& file)
{
    std::ifstream text(file);
    const Json summary = Json::parse(text, nullptr, /*allow_exceptions=*/false);
    return summary.is_object() && summary.contains("program") && summary["program"] == program_name;
}

}  // namespace braidzone
