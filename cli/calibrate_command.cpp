#include "cli/commands.hpp"
#include "cli/file_hash.hpp"
#include "cli/output_files.hpp"
#include "cli/press_file.hpp"
#include "cli/progress.hpp"
#include "core/error.hpp"
#include "deploy/calibration.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <fstream>

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

}  // namespace

void calibrate_device(const std::filesystem::path& press_file,
                      const std::filesystem::path& force_curve, const CommonOptions& options)
{
    const PressFile file = read_press_file(press_file, options.overrides);
    const ForceCurve measured = read_force_curve(force_curve);
    const std::filesystem::path wanted = options.output.value_or(
        std::filesystem::absolute(press_file).replace_extension(".calibration.json"));
    OutputFiles files(options.force);
    const std::filesystem::path unfinished = files.add(wanted);

    Progress progress(options.quiet);
    progress.begin("calibrate", "fitting the spring coefficients");
    const Calibration fit = calibrate(file.device, file.options, measured);
    progress.end();

    const Json result = {
        {"device",
         {{"name", file.device.name},
          {"diameter", file.device.nominal_diameter},
          {"length", file.device.nominal_length},
          {"unit", "m"}}},
        {"surface_coefficient", as_json(fit.surface)},
        {"radial_coefficient", as_json(fit.radial)},
        {"reference_node_area", {{"value", file.device.reference_node_area}, {"unit", "m^2"}}},
        {"force_scale", 1},
        {"correlation", fit.correlation},
        {"reduced_chi_square", fit.reduced_chi_square},
        {"standard_error_of_a_point", {{"value", fit.standard_error}, {"unit", "N"}}},
        {"num_repeats", measured.num_repeats},
        {"nodes_per_ring", {fit.nodes_per_ring, fit.coarse_nodes_per_ring}},
        {"statement", fit.statement},
        {"curve", curve_as_json(measured, fit)},
        {"inputs",
         {{"press_file", {{"path", press_file.string()}, {"sha256", sha256_of_file(press_file)}}},
          {"measured",
           {{"path", force_curve.string()}, {"sha256", sha256_of_file(force_curve)}}}}}};
    std::ofstream text(unfinished);
    text << result.dump(1) << '\n';
    if (!text.flush()) throw IoError(fmt::format("{} cannot be written", wanted.string()));
    text.close();
    files.commit();

    if (options.quiet) return;
    fmt::print("{} {:.4g} x {:.4g} mm, {} points of {} repeat{}\n{}{}", file.device.name,
               1e3 * file.device.nominal_diameter, 1e3 * file.device.nominal_length,
               measured.points.size(), measured.num_repeats, measured.num_repeats == 1 ? "" : "s",
               interval_line("surface_coefficient", fit.surface),
               interval_line("radial_coefficient", fit.radial));
    fmt::print(
        "  misfit {:.2g} times the error of a point\n  {}\n  for a case's [device]:\n\n{}\n"
        "  fit: {}\n",
        std::sqrt(fit.reduced_chi_square), fit.statement, device_keys(file.device, fit),
        wanted.string());
}

}  // namespace braidzone
