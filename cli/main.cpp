#include "cli/commands.hpp"
#include "core/error.hpp"
#include "core/interruption.hpp"

#include <CLI/CLI.hpp>
#include <fcntl.h>
#include <fmt/format.h>
#include <oneapi/tbb/global_control.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <functional>
#include <string>

namespace {

namespace fs = std::filesystem;
using namespace braidzone;

/// What the command line asks for.
struct Arguments {
    CommonOptions common;
    int num_threads = 0;  ///< 0: as many as there are cores
    fs::path case_file;
    fs::path foam_case;
    fs::path force_curve;
    fs::path phantom_file;
    CenterlineCommand centerline;
    DiagnoseCommand diagnose;
    std::string device_name;
    std::function<void()> command;
};

void add_output_options(CLI::App& verb, CommonOptions& common, const std::string& output_help)
{
    verb.add_option("--output", common.output, output_help);
    verb.add_flag("--force", common.force, "replace output that no earlier run wrote");
}

void add_common_options(CLI::App& verb, Arguments& arguments)
{
    verb.add_option("--threads", arguments.num_threads, "most threads to use")
        ->check(CLI::PositiveNumber);
    verb.add_flag("--quiet", arguments.common.quiet, "print neither progress nor a summary");
}

void add_overrides(CLI::App& verb, CommonOptions& common)
{
    verb.add_option("--set", common.overrides, "section.key=value, wins over the file; repeatable")
        ->allow_extra_args(false);
}

/// A verb that works on a case file.
CLI::App& add_case_verb(CLI::App& app, Arguments& arguments, const std::string& name,
                        const std::string& help, std::function<void()> command)
{
    CLI::App& verb = *app.add_subcommand(name, help);
    verb.add_option("CASE", arguments.case_file, "case file (TOML)")->required();
    add_common_options(verb, arguments);
    add_overrides(verb, arguments.common);
    verb.callback([&arguments, command = std::move(command)] { arguments.command = command; });
    return verb;
}

void add_run_verbs(CLI::App& app, Arguments& arguments)
{
    const auto add = [&](const std::string& name, const std::string& help, Stage last) {
        CLI::App& verb = add_case_verb(app, arguments, name, help, [&arguments, last] {
            run_case(arguments.case_file, last, arguments.common);
        });
        add_output_options(verb, arguments.common,
                           "folder for the results (default: CASE.out beside the case)");
        verb.add_option("--frames", arguments.common.num_frames,
                        "write that many shapes of the deployment as a time series (frames.pvd)")
            ->check(CLI::Range(0, 10000));
        return &verb;
    };
    add("run", "deploy the device, compute its flow resistance, write everything", Stage::exports);
    add("deploy", "the deployment alone", Stage::deploy);
    add("porous", "the deployment and its flow resistance", Stage::porous)
        ->add_flag("--compare-laws", arguments.common.compare_laws,
                   "print every resistance law for the device; write laws.csv and laws.png");

    CLI::App& export_verb = add_case_verb(
        app, arguments, "export", "write the exports again, or apply the device to a mesh",
        [&arguments] {
            if (arguments.foam_case.empty()) {
                run_case(arguments.case_file, Stage::exports, arguments.common);
            } else {
                apply_case_to_foam(arguments.case_file, arguments.foam_case, arguments.common);
            }
        });
    add_output_options(export_verb, arguments.common,
                       "folder for the results (default: CASE.out beside the case)");
    export_verb
        .add_option("--onto", arguments.foam_case,
                    "existing OpenFOAM case: apply the device to its mesh instead")
        ->excludes("--output");
    add_case_verb(app, arguments, "check",
                  "read and validate a case and print what was found; write nothing",
                  [&arguments] { check_case(arguments.case_file, arguments.common); });
}

void add_vessel_verbs(CLI::App& app, Arguments& arguments)
{
    CLI::App& centerline = *app.add_subcommand("centerline", "compute a vessel's centerline");
    CenterlineCommand& command = arguments.centerline;
    centerline.add_option("VESSEL", command.surface, "surface: STL, VTP, VTU, VTK, PLY or OBJ")
        ->required();
    centerline.add_option("--length-unit", command.length_unit, "of the surface: m, cm, mm, um")
        ->capture_default_str();
    centerline.add_option("--from", command.from,
                          "proximal end: an opening's number or \"x mm, y mm, z mm\"");
    centerline.add_option("--to", command.to, "distal end, alike");
    centerline.add_flag("--repair{all}", command.repair,
                        "repair a defective surface, or in part: "
                        "--repair=normals,merge,holes,self_intersections,parts");
    add_output_options(centerline, arguments.common,
                       "file (default: VESSEL_centerline.vtp beside the surface)");
    add_common_options(centerline, arguments);
    centerline.callback([&arguments] {
        arguments.command = [&arguments] {
            write_centerline_of(arguments.centerline, arguments.common);
        };
    });

    CLI::App& phantom = *app.add_subcommand("phantom", "make an idealised vessel");
    phantom.add_option("PHANTOM", arguments.phantom_file, "its parameters (TOML)")->required();
    add_output_options(phantom, arguments.common,
                       "folder for vessel.stl and centerline.vtp (default: that of PHANTOM)");
    add_common_options(phantom, arguments);
    add_overrides(phantom, arguments.common);
    phantom.callback([&arguments] {
        arguments.command = [&arguments] {
            write_phantom(arguments.phantom_file, arguments.common);
        };
    });
}

void add_bench_verbs(CLI::App& app, Arguments& arguments)
{
    CLI::App& verb = add_case_verb(
        app, arguments, "press", "simulate the V-notch press test: force against displacement",
        [&arguments] { press_device(arguments.case_file, arguments.common); });
    add_output_options(verb, arguments.common,
                       "file (default: CASE.force.csv beside the press file)");

    CLI::App& calibrate_verb = add_case_verb(
        app, arguments, "calibrate", "fit a device's spring coefficients to a measured press test",
        [&arguments] {
            calibrate_device(arguments.case_file, arguments.force_curve, arguments.common);
        });
    calibrate_verb
        .add_option("--measured", arguments.force_curve,
                    "force curve (CSV): displacement_mm,force_1_mN,force_2_mN,...")
        ->required();
    add_output_options(calibrate_verb, arguments.common,
                       "file (default: CASE.calibration.json beside the press file)");
}

void add_diagnose_verb(CLI::App& app, Arguments& arguments)
{
    CLI::App& verb = add_case_verb(
        app, arguments, "diagnose",
        "find where a measured device differs from the simulated one, and why",
        [&arguments] { diagnose(arguments.case_file, arguments.diagnose, arguments.common); });
    DiagnoseCommand& command = arguments.diagnose;
    verb.add_option("--measured", command.measured,
                    "the device's surface: STL, VTP, VTK, PLY, OBJ, or points as CSV or XYZ; "
                    "repeatable with --calibrate")
        ->allow_extra_args(false);
    verb.add_option("--force-curve", command.force_curves,
                    "in its place, of a press file: displacement_mm,force_1_mN,... (CSV); "
                    "repeatable with --calibrate")
        ->allow_extra_args(false);
    verb.add_option("--pressure-drop", command.pressure_drops,
                    "in its place, of a bench: velocity_m_s,pressure_drop_1_Pa,... (CSV); "
                    "repeatable with --calibrate")
        ->allow_extra_args(false);
    verb.add_option("--length-unit", command.length_unit,
                    "of the measured coordinates: m, cm, mm, um (CSV: stated in its header)");
    verb.add_option("--scalars", command.scalars,
                    "measured length, end positions and contact force (TOML)");
    verb.add_option("--density-map", command.density_map,
                    "measured density of the wires: x_mm,y_mm,z_mm,pore_density_per_mm2,"
                    "sd_per_mm2, or metal_coverage,sd (CSV)");
    verb.add_option("--noise", command.noise, "noise floor (JSON; default: shipped values)");
    verb.add_flag("--calibrate", command.calibrate,
                  "learn the noise floor from several measurements without an effect");
    verb.add_flag("--separability", command.separability,
                  "tell which effects could be told apart, before there is a measurement");
    add_output_options(verb, arguments.common,
                       "folder for the results (default: CASE.diagnosis.out beside the case), or "
                       "file of the noise floor (CASE.noise.json) or of the separability "
                       "(CASE.separability.json)");
}

void add_devices_verb(CLI::App& app, Arguments& arguments)
{
    CLI::App& devices = *app.add_subcommand("devices", "list the device library, or show a device");
    devices.add_option("NAME", arguments.device_name, "device to show");
    devices.callback([&arguments] {
        arguments.command = [&arguments] { show_devices(arguments.device_name); };
    });
}

int run(int argc, char** argv)
{
    CLI::App app("Braidzone prepares the CFD of vessels treated with braided flow diverters.",
                 "braidzone");
    app.set_version_flag("--version", BRAIDZONE_VERSION);
    app.require_subcommand(0, 1);  // so that an unknown verb is named
    Arguments arguments;
    add_run_verbs(app, arguments);
    add_vessel_verbs(app, arguments);
    add_bench_verbs(app, arguments);
    add_diagnose_verb(app, arguments);
    add_devices_verb(app, arguments);
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        return app.exit(error) == 0 ? 0 : 2;
    }

    if (!arguments.command) {
        fmt::print(stderr, "{}\nbraidzone: a subcommand is required\n", app.help());
        return 2;
    }

    std::optional<tbb::global_control> thread_limit;
    if (arguments.num_threads > 0) {
        thread_limit.emplace(tbb::global_control::max_allowed_parallelism,
                             static_cast<std::size_t>(arguments.num_threads));
    }
    arguments.command();
    return 0;
}

/// A stream that the caller closed would be the next file that is opened; what is printed would go
/// into that file. Here it goes to a descriptor that cannot be written to.
void occupy_closed_streams()
{
    for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
        if (::fcntl(stream, F_GETFD) < 0) ::open("/dev/null", O_RDONLY);
}

/// The message of an error, on a stream that may be full itself.
int fail(const std::string& message, int status)
{
    std::fputs(("braidzone: " + message + "\n").c_str(), stderr);
    return status;
}

/// What was printed is out, or the status says that it is not.
int require_printed(int status)
{
    errno = 0;
    const bool was_lost = std::ferror(stdout) != 0;
    if (std::fflush(stdout) == 0 && !was_lost) return status;
    const std::string reason = errno == 0 ? "" : std::string(": ") + std::strerror(errno);
    return fail("standard output cannot be written" + reason, IoError("").exit_status());
}

int run_or_fail(int argc, char** argv)
{
    try {
        return run(argc, argv);
    } catch (const Error& error) {
        return fail(error.what(), error.exit_status());
    } catch (const fs::filesystem_error& error) {
        return fail(error.what(), IoError("").exit_status());
    } catch (const std::exception& error) {
        // What {fmt} throws where it cannot print is told by `require_printed`.
        if (std::ferror(stdout) != 0) return 1;
        return fail(fmt::format("unexpected: {}", error.what()), 1);
    }
}

}  // namespace

int main(int argc, char** argv)
{
    occupy_closed_streams();
    remove_unfinished_output_on_signal();
    return require_printed(run_or_fail(argc, argv));
}
