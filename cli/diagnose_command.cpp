#include "cli/case_hash.hpp"
#include "cli/commands.hpp"
#include "cli/diagnosed_case.hpp"
#include "cli/diagnosis_page.hpp"
#include "cli/diagnosis_report.hpp"
#include "cli/discrepancy_picture.hpp"
#include "cli/discrepancy_vtp.hpp"
#include "cli/effect_case.hpp"
#include "cli/output_files.hpp"
#include "cli/output_folder.hpp"
#include "cli/progress.hpp"
#include "cli/result_files.hpp"
#include "cli/summary.hpp"
#include "cli/unfinished_work.hpp"
#include "core/error.hpp"
#include "core/file_hash.hpp"
#include "discrepancy/diagnosis.hpp"
#include "discrepancy/measured_surface.hpp"
#include "discrepancy/measurement_check.hpp"
#include "discrepancy/noise_calibration.hpp"
#include "discrepancy/surface_problem.hpp"
#include "export/text_file.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <utility>

namespace braidzone {
namespace {

namespace fs = std::filesystem;

MeasuredScalars scalars_of(const DiagnoseCommand& command, const Centerline& centerline)
{
    if (!command.scalars) return {};
    return read_measured_scalars(TomlTable::read_file(*command.scalars), centerline);
}

nlohmann::ordered_json input_as_json(const fs::path& file)
{
    return {{"path", fs::absolute(file).lexically_normal().string()},
            {"sha256", sha256_of_file(file)}};
}

nlohmann::ordered_json inputs_as_json(const Case& job, const DiagnoseCommand& command)
{
    nlohmann::ordered_json inputs = {{"case", input_as_json(job.file)},
                                     {"vessel", input_as_json(job.vessel.surface)},
                                     {"measured", input_as_json(command.measured.front())}};
    if (command.scalars) inputs["scalars"] = input_as_json(*command.scalars);
    if (command.density_map) inputs["density_map"] = input_as_json(*command.density_map);
    if (command.noise) inputs["noise"] = input_as_json(*command.noise);
    return inputs;
}

/// One case file for each answer.
void write_effect_cases(const fs::path& folder, const Case& job, const Diagnosis& diagnosis,
                        const fs::path& measured)
{
    for (const Answer& answer : diagnosis.explanation.verdict.answers) {
        const EffectFit& fit = diagnosis.explanation.fits[answer.fit];
        const Model model = model_with(effect_catalogue(), diagnosis.setting, active_effects(fit));
        write_text_file(
            folder / fmt::format("case_with_{}.toml", fmt::join(answer.effects, "_and_")),
            effect_case_text(job, model, fit, measured));
    }
}

std::vector<InputFile> inputs_of(const Case& job, const DiagnoseCommand& command)
{
    std::vector<InputFile> inputs = input_files(job);
    const std::vector<InputFile> measured = measured_files(command);
    inputs.insert(inputs.end(), measured.begin(), measured.end());
    return inputs;
}

std::optional<LengthUnit> unit_of(const DiagnoseCommand& command)
{
    if (!command.length_unit) return std::nullopt;
    return length_unit(*command.length_unit);
}

/// All that the simulations of a diagnosis depend on: residuals are of measured points and scalars.
std::vector<std::string> inputs_of_simulations(const Case& job, const DiagnoseCommand& command)
{
    std::vector<std::string> inputs = {case_hash(job), sha256_of_file(command.measured.front()),
                                       command.length_unit.value_or("")};
    for (const auto& file : {command.scalars, command.density_map, command.noise})
        inputs.push_back(file ? sha256_of_file(*file) : "");
    return inputs;
}

}  // namespace

std::vector<InputFile> measured_files(const DiagnoseCommand& command)
{
    std::vector<InputFile> files;
    for (const auto& several : {command.measured, command.force_curves, command.pressure_drops})
        for (const fs::path& file : several)
            files.push_back({"measurement", file});
    if (command.scalars) files.push_back({"scalars", *command.scalars});
    if (command.density_map) files.push_back({"density map", *command.density_map});
    if (command.noise) files.push_back({"noise floor", *command.noise});
    return files;
}

void learn_noise_floor(const fs::path& case_file, const DiagnoseCommand& command,
                       const CommonOptions& options)
{
    const Case job = read_diagnosed_case(case_file, options.overrides);
    if (command.scalars) throw ConfigError("--scalars has no part in --calibrate; leave it out");
    if (command.density_map)
        throw ConfigError("--density-map has no part in --calibrate; leave it out");
    TextOutput output(
        options.output.value_or(fs::absolute(case_file).replace_extension(".noise.json")),
        inputs_of(job, command), options.force);
    Progress progress(options.quiet);
    progress.begin("vessel", "reading the vessel");
    const Lumen lumen = lumen_of(job);
    progress.begin("deploy", "deploying the device");
    const Model model = model_of(job, lumen.centerline);
    const Simulation base = simulate(model, lumen);
    std::vector<CalibrationSet> sets;
    for (const fs::path& file : command.measured) {
        std::vector<Vec3> points = read_measured_surface(file, unit_of(command));
        try {
            require_comparable(points, model.imaging, base, lumen);
        } catch (const InputError& error) {
            throw InputError(fmt::format("{}: {}", file.string(), error.what()));
        }
        sets.push_back(calibration_set(std::move(points), {}, model, base, lumen));
    }
    progress.begin("calibrate", "learning the noise floor");
    const NoiseFloor floor = calibrate_noise_floor(sets);
    progress.end();
    output.write(noise_floor_text(floor));
    if (options.quiet) return;
    fmt::print("{}  written to {}\n", noise_floor_text(floor), output.path().string());
}

void diagnose_case(const fs::path& case_file, const DiagnoseCommand& command,
                   const CommonOptions& options)
{
    if (command.measured.size() != 1) {
        throw ConfigError(fmt::format(
            "diagnose takes one measured surface, {} are given; several are for --calibrate",
            command.measured.size()));
    }
    const Case job = read_diagnosed_case(case_file, options.overrides);
    std::vector<Vec3> points = read_measured_surface(command.measured.front(), unit_of(command));
    const DensityMap density =
        command.density_map ? read_density_map(*command.density_map) : DensityMap{};
    DiagnoseOptions diagnose_options;
    if (command.noise) diagnose_options.floor = read_noise_floor(*command.noise);
    OutputFolder folder(
        options.output.value_or(fs::path(case_file).replace_extension(".diagnosis.out")),
        inputs_of(job, command), options.force, "diagnosis.json");

    Progress progress(options.quiet);
    progress.begin("vessel", "reading the vessel");
    const Lumen lumen = lumen_of(job);
    const MeasuredScalars scalars = scalars_of(command, lumen.centerline);
    ResidualMemory memory =
        unfinished_simulations(folder.final_path(), inputs_of_simulations(job, command));
    diagnose_options.memory = &memory;
    progress.begin("diagnose", doing_with("deploying the device", memory));
    diagnose_options.explain.on_progress = [&](const std::string& doing) {
        progress.begin("diagnose", doing);
    };
    const Diagnosis diagnosis = diagnose(model_of(job, lumen.centerline), lumen, std::move(points),
                                         scalars, effect_catalogue(), diagnose_options, density);
    progress.begin("export", "writing the results");
    write_discrepancy_picture(folder.path() / "discrepancy.png", diagnosis);
    write_discrepancy_vtp(folder.path() / "discrepancy.vtp", diagnosis, lumen.vessel.unit);
    write_effect_cases(folder.path(), job, diagnosis, command.measured.front());
    progress.end();

    nlohmann::ordered_json json = {{"program", program_name}};
    json.update(diagnosis_as_json(diagnosis, diagnose_options.floor));
    json["inputs"] = inputs_as_json(job, command);
    write_text_file(folder.path() / "report.html",
                    diagnosis_page(json, folder.path() / "discrepancy.png"));
    json["files"] = files_in(folder.path());
    for (const StageTime& time : progress.times())
        json["times_s"][time.stage] = time.seconds;
    write_text_file(folder.path() / "diagnosis.json", json.dump(1) + "\n");
    put_in_place(folder);
    memory.forget();

    if (options.quiet) return;
    if (memory.num_found() > 0) {
        fmt::print("{} simulations were those of an interrupted run\n", memory.num_found());
    }
    fmt::print("{}  {:<12}{}\n", diagnosis_summary(diagnosis), "results",
               folder.final_path().string());
}

void diagnose(const fs::path& case_file, const DiagnoseCommand& command,
              const CommonOptions& options)
{
    if (command.separability) return tell_separability(case_file, command, options);
    const int given = (command.measured.empty() ? 0 : 1) + (command.force_curves.empty() ? 0 : 1) +
                      (command.pressure_drops.empty() ? 0 : 1);
    if (given != 1) {
        throw ConfigError(
            fmt::format("diagnose takes one of --measured, --force-curve and --pressure-drop; {} "
                        "are given",
                        given));
    }
    if (!command.force_curves.empty()) return diagnose_force_curve(case_file, command, options);
    if (!command.pressure_drops.empty()) return diagnose_pressure_drop(case_file, command, options);
    if (command.calibrate) return learn_noise_floor(case_file, command, options);
    diagnose_case(case_file, command, options);
}

}  // namespace braidzone
