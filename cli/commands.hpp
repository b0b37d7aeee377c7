#pragma once

#include "cli/case_hash.hpp"
#include "cli/pipeline.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace braidzone {

/// Options that the verbs share.
struct CommonOptions {
    std::optional<std::filesystem::path> output;
    std::vector<std::string> overrides;  ///< "section.key=value"
    bool quiet = false;
    bool force = false;
    std::optional<int> num_frames;  ///< in place of deployment.num_frames
    bool compare_laws = false;      ///< tabulate and plot every resistance law
};

/// run, deploy, porous, export: computes a case as far as `last` and writes the results.
/// `output`: the folder; default `<case name>.out` beside the case. `num_frames`: shapes of the
/// deployment to write as a time series. `compare_laws`: prints every resistance law for the device
/// at hand, and writes laws.csv and laws.png.
void run_case(const std::filesystem::path& case_file, Stage last, const CommonOptions& options);

/// export --onto: applies the device of a case to an existing OpenFOAM mesh.
void apply_case_to_foam(const std::filesystem::path& case_file,
                        const std::filesystem::path& foam_case, const CommonOptions& options);

/// check: reads and validates a case, deploys its device in memory, and prints what it found.
void check_case(const std::filesystem::path& case_file, const CommonOptions& options);

struct DiagnoseCommand {
    std::vector<std::filesystem::path> measured;       ///< the device's surface; more to learn from
    std::optional<std::string> length_unit;            ///< of its coordinates
    std::optional<std::filesystem::path> scalars;      ///< length, end positions, force (TOML)
    std::optional<std::filesystem::path> density_map;  ///< density of the wires (CSV)
    std::optional<std::filesystem::path> noise;        ///< noise floor (JSON)
    bool calibrate = false;                            ///< learn the noise floor instead
    bool separability = false;                         ///< tell what could be told apart instead
    /// In place of a surface: a press test's force curve, a bench's pressure drop (CSV); more to
    /// learn from.
    std::vector<std::filesystem::path> force_curves, pressure_drops;
};

/// The files that a diagnosis reads besides its case.
std::vector<InputFile> measured_files(const DiagnoseCommand& command);

/// diagnose: finds where a measured device differs from the simulated one, names the missing effect
/// and writes a case file with it.
/// `output`: the folder; default `<case name>.diagnosis.out` beside the case.
void diagnose_case(const std::filesystem::path& case_file, const DiagnoseCommand& command,
                   const CommonOptions& options);

/// diagnose --force-curve, --pressure-drop: the same of a curve measured on a bench; the case is a
/// press file or the file of a bench (`pressure_file.hpp`). With `calibrate` they learn the noise
/// floor from curves in which no effect is missing, as `learn_noise_floor` does.
void diagnose_force_curve(const std::filesystem::path& press_file, const DiagnoseCommand& command,
                          const CommonOptions& options);
void diagnose_pressure_drop(const std::filesystem::path& bench_file, const DiagnoseCommand& command,
                            const CommonOptions& options);

/// diagnose, by what was measured.
/// @throws ConfigError unless it is one of the three
void diagnose(const std::filesystem::path& case_file, const DiagnoseCommand& command,
              const CommonOptions& options);

/// diagnose --separability: tells which effects a measurement of this case could tell apart, before
/// there is one. `output`: the file; default `<case name>.separability.json` beside the case.
void tell_separability(const std::filesystem::path& case_file, const DiagnoseCommand& command,
                       const CommonOptions& options);

/// diagnose --calibrate: learns the noise floor from measurements in which no effect is missing.
/// `output`: the file; default `<case name>.noise.json` beside the case.
void learn_noise_floor(const std::filesystem::path& case_file, const DiagnoseCommand& command,
                       const CommonOptions& options);

struct CenterlineCommand {
    std::filesystem::path surface;
    std::string length_unit = "mm";
    /// "0", an opening's number, or a point "1 mm, 2 mm, 3 mm"; both empty: the two openings.
    std::string from, to;
    std::string repair = "none";  ///< "all", or names of repairs, comma-separated
};

/// centerline: computes and writes the centerline of a surface.
/// `output`: the file; default `<surface name>_centerline.vtp` beside the surface.
void write_centerline_of(const CenterlineCommand& command, const CommonOptions& options);

/// phantom: makes an idealised vessel; writes vessel.stl and centerline.vtp in millimetres.
/// `output`: the folder; default: that of the parameter file.
void write_phantom(const std::filesystem::path& parameters, const CommonOptions& options);

/// press: simulates the V-notch press test of a device; writes force against displacement.
/// `output`: the file; default `<press file name>.force.csv` beside it.
void press_device(const std::filesystem::path& press_file, const CommonOptions& options);

/// calibrate: fits the spring coefficients of a device to a measured press test; writes them with
/// their intervals. `output`: the file; default `<press file name>.calibration.json` beside it.
void calibrate_device(const std::filesystem::path& press_file,
                      const std::filesystem::path& force_curve, const CommonOptions& options);

/// devices: lists the device library, or shows one device with the sources of its values.
void show_devices(const std::string& name);

}  // namespace braidzone
