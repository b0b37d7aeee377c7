#include "cli/commands.hpp"
#include "cli/output_files.hpp"
#include "cli/press_file.hpp"
#include "cli/progress.hpp"

#include <fmt/format.h>

namespace braidzone {
namespace {

/// One line a stationary state; the columns name their units.
std::string force_table(const std::vector<PressState>& states, double force_scale)
{
    std::string text = "displacement_mm,force_mN,deflection_mm,energy_uJ\n";
    for (const PressState& state : states) {
        text += fmt::format("{:.6g},{:.6g},{:.6g},{:.6g}\n", 1e3 * state.displacement,
                            1e3 * force_scale * state.force, 1e3 * state.deflection,
                            1e6 * force_scale * state.energy);
    }
    return text;
}

}  // namespace

void press_device(const std::filesystem::path& press_file, const CommonOptions& options)
{
    const PressFile file = read_press_file(press_file, options.overrides);
    TextOutput output(options.output.value_or(
                          std::filesystem::absolute(press_file).replace_extension(".force.csv")),
                      options.force);

    Progress progress(options.quiet);
    progress.begin("press", "pressing the device");
    const PressNetwork pressed = press_network(file.device, file.options);
    const std::vector<PressState> states = press(pressed.network, file.options);
    progress.end();
    output.write(force_table(states, pressed.force_scale));

    if (options.quiet) return;
    fmt::print("{} {:.4g} x {:.4g} mm: {}\n", file.device.name, 1e3 * file.device.nominal_diameter,
               1e3 * file.device.nominal_length, force_origin(file.device));
    for (const PressState& state : states) {
        fmt::print("  {:6.3f} mm {:12.4g} mN\n", 1e3 * state.displacement,
                   1e3 * pressed.force_scale * state.force);
    }
    for (const std::string& note : file.device_notes)
        fmt::print("  note: {}\n", note);
    fmt::print("  force curve: {}\n", output.path().string());
}

}  // namespace braidzone
