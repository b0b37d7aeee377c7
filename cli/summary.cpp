#include "cli/summary.hpp"

#include "cli/file_hash.hpp"
#include "cli/library_versions.hpp"
#include "cli/resolved_case.hpp"
#include "deploy/deployment_measures.hpp"
#include "porous/braid_surface.hpp"

#include <fmt/format.h>
#include <sys/resource.h>

#include <fstream>

namespace braidzone {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* program_name = "braidzone";

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

Json quantities(const Case& job, const Chain& chain, const Progress& progress)
{
    const double gap = neck_gap(job.device);
    const DeploymentMeasures device = measure(chain.deployment, job.device, chain.wall, gap);
    const BraidMeasures braid = measure(chain.sheet.surface, gap);
    std::optional<double> field_integral;
    if (chain.field) field_integral = resistance_integral(*chain.field);
    return {
        {"implanted_length", quantity(device.implanted_length, "m")},
        {"resting_length", quantity(device.resting_length, "m")},
        {"foreshortening", quantity(device.foreshortening, "1")},
        {"mean_radial_expansion", quantity(device.mean_radial_expansion, "m")},
        {"mean_radial_expansion_neck", quantity(device.mean_radial_expansion_neck, "m")},
        {"mean_density_increase", quantity(braid.mean_density_increase, "1")},
        {"mean_density_increase_neck", quantity(braid.mean_density_increase_neck, "1")},
        {"mean_contact_pressure", quantity(device.mean_contact_pressure, "Pa")},
        {"max_contact_pressure", quantity(device.max_contact_pressure, "Pa")},
        {"radial_force_per_length", quantity(device.radial_force_per_length, "N/m")},
        {"contact_area_fraction", quantity(device.contact_area_fraction, "1")},
        {"malapposed_area", quantity(device.malapposed_area, "m^2")},
        {"mean_metal_coverage", quantity(braid.mean_metal_coverage, "1")},
        {"mean_metal_coverage_neck", quantity(braid.mean_metal_coverage_neck, "1")},
        {"mean_pore_density_neck", quantity(braid.mean_pore_density_neck, "1/m^2")},
        {"wire_length", quantity(braid.wire_length, "m")},
        {"metal_volume", quantity(braid.metal_volume, "m^3")},
        {"device_area", quantity(braid.device_area, "m^2")},
        {"resistance_integral_surface", quantity(resistance_integral(chain.sheet), "m")},
        {"resistance_integral_field", quantity(field_integral, "m")},
        {"max_force_residual", quantity(chain.deployment.max_force_residual, "N")},
        {"inverted_rhombi", quantity(device.inverted_rhombi, "1")},
        {"nodes_outside_vessel", quantity(device.nodes_outside_vessel, "1")},
        {"time_deploy", quantity(progress.seconds("deploy"), "s")},
        {"time_porous", quantity(progress.seconds("porous"), "s")},
        {"time_export", quantity(progress.seconds("export"), "s")},
        {"peak_memory", quantity(peak_memory(), "B")},
    };
}

Json input_files(const Case& job)
{
    Json inputs = Json::array();
    const auto add = [&](const char* role, const std::filesystem::path& path) {
        inputs.push_back(
            {{"role", role}, {"file", path.string()}, {"sha256", sha256_of_file(path)}});
    };
    add("case", job.file);
    add("vessel", job.vessel.surface);
    if (job.vessel.centerline) add("centerline", *job.vessel.centerline);
    return inputs;
}

std::vector<std::string> warnings(const Case& job, const Chain& chain)
{
    std::vector<std::string> all = job.device_notes;
    all.insert(all.end(), chain.vessel.notes.begin(), chain.vessel.notes.end());
    const auto of_law = range_warnings(job.law, chain.sheet.surface.rhombi);
    all.insert(all.end(), of_law.begin(), of_law.end());
    return all;
}

}  // namespace

Json summarise(const Case& job, const Chain& chain, const Progress& progress,
               const std::vector<std::string>& files)
{
    Json stages = Json::object();
    for (const StageTime& time : progress.times()) {
        stages[time.stage] = quantity(time.seconds, "s");
    }
    const BraidLattice& lattice = chain.deployment.lattice;
    return {{"program", program_name},
            {"quantities", quantities(job, chain, progress)},
            {"lattice",
             {{"num_rings", lattice.num_rings},
              {"nodes_per_ring", lattice.nodes_per_ring},
              {"steps", chain.deployment.steps},
              {"force_tolerance", quantity(chain.deployment.force_tolerance, "N")}}},
            {"case", resolved_case(job)},
            {"inputs", input_files(job)},
            {"versions", library_versions()},
            {"stages", stages},
            {"files", files},
            {"warnings", warnings(job, chain)}};
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
