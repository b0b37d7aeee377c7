#include "cli/commands.hpp"
#include "cli/output_files.hpp"
#include "cli/press_file.hpp"
#include "cli/progress.hpp"

#include <fmt/format.h>

namespace braidzone {
namespace {

/// The states as the bench shows them.
std::vector<ForcePoint> readings(const std::vector<PressState>& states, double force_scale,
                                 const PressFile& file)
{
    std::vector<ForcePoint> points;
    for (const PressState& state : states) {
        points.push_back(as_read({state.displacement, force_scale * state.force},
                                 file.options.reading, file.device.nominal_diameter));
    }
    return points;
}

/// One line a stationary state; the columns name their units.
std::string force_table(const std::vector<PressState>& states,
                        const std::vector<ForcePoint>& points, double force_scale)
{
    std::string text = "displacement_mm,force_mN,deflection_mm,energy_uJ\n";
    for (std::size_t i = 0; i < states.size(); ++i) {
        text += fmt::format("{:.6g},{:.6g},{:.6g},{:.6g}\n", 1e3 * points[i].displacement,
                            1e3 * points[i].force, 1e3 * states[i].deflection,
                            1e6 * force_scale * states[i].energy);
    }
    return text;
}

}  // namespace

void press_device(const std::filesystem::path& press_file, const CommonOptions& options)
{
    const PressFile file = read_press_file(press_file, options.overrides);
    TextOutput output(options.output.value_or(
                          std::filesystem::absolute(press_file).replace_extension(".force.csv")),
                      {{"press file", press_file}}, options.force);

    Progress progress(options.quiet);
    progress.begin("press", "pressing the device");
    const PressNetwork pressed = press_network(file.device, file.options);
    const std::vector<PressState> states = press(pressed.network, file.options);
    progress.end();
    const std::vector<ForcePoint> points = readings(states, pressed.force_scale, file);
    output.write(force_table(states, points, pressed.force_scale));

    if (options.quiet) return;
    fmt::print("{} {:.4g} x {:.4g} mm: {}\n", file.device.name, 1e3 * file.device.nominal_diameter,
               1e3 * file.device.nominal_length, force_origin(file.device));
    for (const ForcePoint& point : points)
        fmt::print("  {:6.3f} mm {:12.4g} mN\n", 1e3 * point.displacement, 1e3 * point.force);
    for (const std::string& note : file.device_notes)
        fmt::print("  note: {}\n", note);
    fmt::print("  force curve: {}\n", output.path().string());
}

}  // namespace braidzone
