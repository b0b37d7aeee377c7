#include "cli/commands.hpp"
#include "cli/output_files.hpp"
#include "cli/press_file.hpp"
#include "cli/progress.hpp"
#include "core/file_hash.hpp"
#include "deploy/calibration.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <string>

namespace braidzone {
namespace {

using Json = nlohmann::ordered_json;

Json as_json(const Estimate& estimate)
{
    return {{"value", estimate.value},
            {"unit", "N/m"},
            {"interval_95", {estimate.lower, estimate.upper}},
            {"relative_error_noise", estimate.relative_error},
            {"relative_error_net", estimate.discretisation_error}};
}

Json curve_as_json(const ForceCurve& measured, const Calibration& fit)
{
    Json curve = {{"displacement", Json::array()},
                  {"force_measured", Json::array()},
                  {"force_fitted", Json::array()}};
    for (std::size_t i = 0; i < measured.points.size(); ++i) {
        curve["displacement"].push_back(measured.points[i].displacement);
        curve["force_measured"].push_back(measured.points[i].force);
        curve["force_fitted"].push_back(fit.fitted_force[i]);
    }
    curve["units"] = {{"displacement", "m"}, {"force_measured", "N"}, {"force_fitted", "N"}};
    return curve;
}

Json as_json(const FlowDiverter& device)
{
    return {{"name", device.name},
            {"diameter", device.nominal_diameter},
            {"length", device.nominal_length},
            {"unit", "m"}};
}

Json input_as_json(const std::filesystem::path& file)
{
    return {{"path", file.string()}, {"sha256", sha256_of_file(file)}};
}

Json as_json(const FlowDiverter& device, const ForceCurve& measured, const Calibration& fit)
{
    return {{"device", as_json(device)},
            {"surface_coefficient", as_json(fit.surface)},
            {"radial_coefficient", as_json(fit.radial)},
            {"reference_node_area", {{"value", device.reference_node_area}, {"unit", "m^2"}}},
            {"force_scale", 1},
            {"correlation", fit.correlation},
            {"reduced_chi_square", fit.reduced_chi_square},
            {"standard_error_of_a_point", {{"value", fit.standard_error}, {"unit", "N"}}},
            {"num_repeats", measured.num_repeats},
            {"nodes_per_ring", {fit.nodes_per_ring, fit.coarse_nodes_per_ring}},
            {"statement", fit.statement},
            {"curve", curve_as_json(measured, fit)}};
}

/// The keys that give a case file's [device] the fitted springs.
std::string device_keys(const FlowDiverter& device, const Calibration& fit)
{
    return fmt::format(
        "surface_coefficient = \"{:.4g} N/m\"\n"
        "radial_coefficient = \"{:.4g} N/m\"\n"
        "reference_node_area = \"{:.8g} mm^2\"\n"
        "force_scale = 1\n",
        fit.surface.value, fit.radial.value, 1e6 * device.reference_node_area);
}

std::string interval_line(const char* name, const Estimate& estimate)
{
    return fmt::format(
        "  {:<20} {:8.4g} N/m, 95 % interval {:.4g} to {:.4g} "
        "(noise {:.1f} %, net {:.1f} %)\n",
        name, estimate.value, estimate.lower, estimate.upper, 100.0 * estimate.relative_error,
        100.0 * estimate.discretisation_error);
}

void print_fit(const FlowDiverter& device, const ForceCurve& measured, const Calibration& fit)
{
    fmt::print("{} {:.4g} x {:.4g} mm, {} points of {} repeat{}\n{}{}", device.name,
               1e3 * device.nominal_diameter, 1e3 * device.nominal_length, measured.points.size(),
               measured.num_repeats, measured.num_repeats == 1 ? "" : "s",
               interval_line("surface_coefficient", fit.surface),
               interval_line("radial_coefficient", fit.radial));
    fmt::print("  misfit {:.2g} times the error of a point\n  {}\n  for a case's [device]:\n\n{}\n",
               std::sqrt(fit.reduced_chi_square), fit.statement, device_keys(device, fit));
}

}  // namespace

void calibrate_device(const std::filesystem::path& press_file,
                      const std::filesystem::path& force_curve, const CommonOptions& options)
{
    const PressFile file = read_press_file(press_file, options.overrides);
    const ForceCurve measured = read_force_curve(force_curve);
    TextOutput output(
        options.output.value_or(
            std::filesystem::absolute(press_file).replace_extension(".calibration.json")),
        {{"press file", press_file}, {"measured curve", force_curve}}, options.force);

    Progress progress(options.quiet);
    progress.begin("calibrate", "fitting the spring coefficients");
    const Calibration fit = calibrate(file.device, file.options, measured);
    progress.end();

    Json result = as_json(file.device, measured, fit);
    result["inputs"] = {{"press_file", input_as_json(press_file)},
                        {"measured", input_as_json(force_curve)}};
    output.write(result.dump(1) + "\n");

    if (options.quiet) return;
    print_fit(file.device, measured, fit);
    fmt::print("  fit: {}\n", output.path().string());
}

}  // namespace braidzone
