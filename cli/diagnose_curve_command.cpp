#include "cli/commands.hpp"
#include "cli/curve_picture.hpp"
#include "cli/curve_report.hpp"
#include "cli/diagnosis_page.hpp"
#include "cli/explanation_report.hpp"
#include "cli/output_files.hpp"
#include "cli/output_folder.hpp"
#include "cli/press_file.hpp"
#include "cli/pressure_file.hpp"
#include "cli/progress.hpp"
#include "cli/result_files.hpp"
#include "cli/summary.hpp"
#include "core/error.hpp"
#include "core/file_hash.hpp"
#include "discrepancy/curve_diagnosis.hpp"
#include "discrepancy/curve_noise_calibration.hpp"
#include "discrepancy/curve_noise_file.hpp"
#include "discrepancy/force_effects.hpp"
#include "discrepancy/pressure_effects.hpp"
#include "export/text_file.hpp"
#include "porous/pressure_curve.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <utility>

namespace braidzone {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr std::size_t fewest_points = 6;

/// The keys that an answer changes, as overrides of the case file.
using ChangesOf = std::function<std::vector<std::string>(const EffectFit&)>;

/// A diagnosed curve and what is written of it.
struct CurveOutput {
    CurveLabels labels;
    fs::path case_file, curve_file;
    std::optional<fs::path> noise_file;
    std::vector<std::string> notes;  ///< on the device
    ChangesOf changes_of;
};

const CurveLabels force_labels = {"force curve", "displacement", "mm", 1e-3, "force", "mN", 1e-3};
const CurveLabels pressure_labels = {"pressure drop", "velocity", "m/s", 1.0,
                                     "pressure drop", "Pa",       1.0};

/// In which units the noise file of a curve is.
CurveNoiseUnits noise_units(const CurveLabels& labels)
{
    std::string abscissa_unit = labels.abscissa_unit;
    std::replace(abscissa_unit.begin(), abscissa_unit.end(), '/', '_');
    return {labels.curve, labels.ordinate_unit, abscissa_unit, labels.ordinate_si,
            labels.abscissa_si};
}

CurveNoise noise_for(const DiagnoseCommand& command, const CurveLabels& labels,
                     const CurveNoise& shipped)
{
    return command.noise ? read_curve_noise(*command.noise, noise_units(labels)) : shipped;
}

void require_few_options(const DiagnoseCommand& command, const std::string& curve)
{
    const auto refuse = [&](bool is_given, const char* option) {
        if (!is_given) return;
        throw ConfigError(
            fmt::format("{} has no part in the diagnosis of a {}; leave it out", option, curve));
    };
    refuse(command.length_unit.has_value(), "--length-unit");
    refuse(command.scalars.has_value(), "--scalars");
    refuse(command.density_map.has_value(), "--density-map");
}

void require_one(const std::vector<fs::path>& curves, const std::string& curve)
{
    if (curves.size() == 1) return;
    throw ConfigError(fmt::format(
        "diagnose takes one {}, {} are given; several are for --calibrate", curve, curves.size()));
}

void require_points(const fs::path& file, std::size_t count)
{
    if (count >= fewest_points) return;
    throw InputError(fmt::format("{}: {} points; a diagnosis needs at least {}", file.string(),
                                 count, fewest_points));
}

/// The file of the case with an answer in it: its own text with the changed keys, after a comment
/// that says where they come from.
std::string answer_text(const CurveOutput& output, const std::vector<std::string>& overrides,
                        const EffectFit& fit)
{
    const std::vector<std::string> changes = output.changes_of(fit);
    std::string text = fmt::format("# {} with {}, found by braidzone diagnose in\n# {}.\n",
                                   output.case_file.string(), name_of(fit),
                                   fs::absolute(output.curve_file).string());
    for (const FittedEffect& effect : fit.effects)
        text += fmt::format("# {}: {}\n", effect.name, fmt::join(parameter_texts(effect), ", "));
    text += fmt::format(
        "# (from the curvature at the best fit; their coverage is not checked)\n"
        "# ln Bayes factor against no effect {:.1f}. Changed values:\n#   {}\n\n",
        fit.log_evidence, fmt::join(changes, "\n#   "));
    std::vector<std::string> all = overrides;
    all.insert(all.end(), changes.begin(), changes.end());
    const TomlTable root = TomlTable::read_file(output.case_file, all);
    const TomlTable porous = root.table_or_empty("porous");
    if (porous.has("loss_table")) {
        // Its path is relative to the case file, which the new one does not stand beside.
        all.push_back(fmt::format(
            "porous.loss_table=\"{}\"",
            fs::absolute(root.folder() / porous.text("loss_table")).lexically_normal().string()));
    }
    return text + TomlTable::read_file(output.case_file, all).document_text() + "\n";
}

Json input_as_json(const fs::path& file)
{
    return {{"path", fs::absolute(file).lexically_normal().string()},
            {"sha256", sha256_of_file(file)}};
}

void write_results(OutputFolder& folder, const CurveDiagnosis& diagnosis, const CurveOutput& output,
                   const std::vector<std::string>& overrides, Progress& progress)
{
    write_curve_picture(folder.path() / "curve.png", diagnosis, output.labels);
    for (const Answer& answer : diagnosis.explanation.verdict.answers) {
        write_text_file(
            folder.path() / fmt::format("case_with_{}.toml", fmt::join(answer.effects, "_and_")),
            answer_text(output, overrides, diagnosis.explanation.fits[answer.fit]));
    }
    progress.end();
    Json json = {{"program", program_name}};
    json.update(curve_as_json(diagnosis, output.labels));
    json["device_notes"] = output.notes;
    json["inputs"] = {{"case", input_as_json(output.case_file)},
                      {"measured", input_as_json(output.curve_file)}};
    if (output.noise_file) json["inputs"]["noise"] = input_as_json(*output.noise_file);
    write_text_file(folder.path() / "report.html", curve_page(json, folder.path() / "curve.png"));
    json["files"] = files_in(folder.path());
    for (const StageTime& time : progress.times())
        json["times_s"][time.stage] = time.seconds;
    write_text_file(folder.path() / "diagnosis.json", json.dump(1) + "\n");
    put_in_place(folder);
}

void print_results(const OutputFolder& folder, const CurveDiagnosis& diagnosis,
                   const CurveOutput& output)
{
    fmt::print("{}", curve_summary(diagnosis));
    for (const std::string& note : output.notes)
        fmt::print("  note: {}\n", note);
    fmt::print("  {:<12}{}\n", "results", folder.final_path().string());
}

std::vector<InputFile> inputs_of(const fs::path& case_file, const DiagnoseCommand& command)
{
    std::vector<InputFile> inputs = measured_files(command);
    inputs.push_back({"case", case_file});
    return inputs;
}

std::vector<InputFile> inputs_of(const fs::path& case_file, const PressureBench& bench,
                                 const DiagnoseCommand& command)
{
    std::vector<InputFile> inputs = inputs_of(case_file, command);
    if (const auto* measured = std::get_if<MeasuredLaw>(&bench.law))
        inputs.push_back({"loss_table", measured->table});
    return inputs;
}

OutputFolder folder_for(const fs::path& case_file, const std::vector<InputFile>& inputs,
                        const CommonOptions& options)
{
    return OutputFolder(
        options.output.value_or(fs::path(case_file).replace_extension(".diagnosis.out")), inputs,
        options.force, "diagnosis.json");
}

/// Searches the bench's effects and writes what was found.
template <typename Model>
void finish(OutputFolder& folder, const MeasuredCurve& measured, const CurveNoise& noise,
            const CurveBench<Model>& bench, const CurveOutput& output, const CommonOptions& options,
            Progress& progress)
{
    ExplainOptions explain_options = curve_options();
    explain_options.on_progress = [&](const std::string& doing) {
        progress.begin("diagnose", doing);
    };
    progress.begin("diagnose", "trying effects");
    const CurveDiagnosis diagnosis = diagnose_curve(measured, noise, bench, explain_options);
    progress.begin("export", "writing the results");
    write_results(folder, diagnosis, output, options.overrides, progress);
    if (!options.quiet) print_results(folder, diagnosis, output);
}

/// Learns the noise of a kind of curve from those in which no effect is missing.
void learn_curve_noise(const std::vector<CurveCalibrationSet>& sets, const CurveNoise& shipped,
                       const CurveLabels& labels, TextOutput& output, const CommonOptions& options)
{
    const std::string text =
        curve_noise_text(calibrate_curve_noise(sets, shipped), noise_units(labels));
    output.write(text);
    if (!options.quiet) fmt::print("{}  written to {}\n", text, output.path().string());
}

void require_no_noise(const DiagnoseCommand& command)
{
    if (!command.noise) return;
    throw ConfigError("--noise has no part in --calibrate, which learns it; leave it out");
}

TextOutput noise_output(const fs::path& case_file, const std::vector<InputFile>& inputs,
                        const CommonOptions& options)
{
    return TextOutput(
        options.output.value_or(fs::absolute(case_file).replace_extension(".noise.json")), inputs,
        options.force);
}

MeasuredCurve measured_forces(const fs::path& file)
{
    const ForceCurve curve = read_force_curve(file);
    require_points(file, curve.points.size());
    MeasuredCurve measured;
    measured.standard_error = curve.deviation / std::sqrt(curve.num_repeats);
    for (const ForcePoint& point : curve.points) {
        measured.abscissae.push_back(point.displacement);
        measured.ordinates.push_back(point.force);
    }
    return measured;
}

MeasuredCurve measured_drops(const fs::path& file)
{
    const RepeatCurve curve = read_pressure_curve(file);
    require_points(file, curve.abscissae.size());
    return {curve.abscissae, curve.means, curve.deviation / std::sqrt(curve.num_repeats)};
}

PressResponse press_response(const PressModel& model, double stroke, bool with_changes,
                             Progress& progress)
{
    progress.begin("press", "pressing the device");
    PressResponseOptions options;
    options.with_changes = with_changes;
    options.on_progress = [&](int done, int all) {
        progress.begin("press", fmt::format("press tests: {} of {} done", done, all));
    };
    return make_press_response(model, stroke, options);
}

void learn_force_noise(const PressModel& model, const fs::path& press_file,
                       const DiagnoseCommand& command, const CommonOptions& options)
{
    require_no_noise(command);
    std::vector<CurveCalibrationSet> sets;
    double stroke = 0.0;
    for (const fs::path& file : command.force_curves) {
        sets.push_back({measured_forces(file), {}});
        stroke = std::max(stroke, sets.back().measured.abscissae.back());
    }
    TextOutput output = noise_output(press_file, inputs_of(press_file, command), options);
    Progress progress(options.quiet);
    const PressResponse response = press_response(model, stroke, false, progress);
    for (CurveCalibrationSet& set : sets)
        set.simulated = press_forces(response, response.base, set.measured.abscissae);
    progress.end();
    learn_curve_noise(sets, force_noise(), force_labels, output, options);
}

void learn_pressure_noise(const PressureBench& bench, const fs::path& bench_file,
                          const DiagnoseCommand& command, const CommonOptions& options)
{
    require_no_noise(command);
    std::vector<CurveCalibrationSet> sets;
    for (const fs::path& file : command.pressure_drops) {
        const MeasuredCurve measured = measured_drops(file);
        sets.push_back({measured, pressure_curve_bench(bench, measured.abscissae).simulate(bench)});
    }
    TextOutput output = noise_output(bench_file, inputs_of(bench_file, bench, command), options);
    learn_curve_noise(sets, pressure_noise(), pressure_labels, output, options);
}

}  // namespace

void diagnose_force_curve(const fs::path& press_file, const DiagnoseCommand& command,
                          const CommonOptions& options)
{
    require_few_options(command, force_labels.curve);
    const PressFile file = read_press_file(press_file, options.overrides);
    const PressModel model{file.device, file.options};
    if (command.calibrate) return learn_force_noise(model, press_file, command, options);
    require_one(command.force_curves, force_labels.curve);
    const MeasuredCurve measured = measured_forces(command.force_curves.front());
    const CurveNoise noise = noise_for(command, force_labels, force_noise());
    OutputFolder folder = folder_for(press_file, inputs_of(press_file, command), options);
    Progress progress(options.quiet);
    const CurveBench<PressModel> bench = force_curve_bench(
        press_response(model, measured.abscissae.back(), true, progress), measured.abscissae);
    const auto changes_of = [&](const EffectFit& fit) {
        const PressModel after = with_effects(bench, active_effects(fit));
        return changed_press_keys(bench.base.device, bench.base.options, after.device,
                                  after.options);
    };
    finish(folder, measured, noise, bench,
           {force_labels, press_file, command.force_curves.front(), command.noise,
            file.device_notes, changes_of},
           options, progress);
}

void diagnose_pressure_drop(const fs::path& bench_file, const DiagnoseCommand& command,
                            const CommonOptions& options)
{
    require_few_options(command, pressure_labels.curve);
    const PressureFile file = read_pressure_file(bench_file, options.overrides);
    if (command.calibrate) return learn_pressure_noise(file.bench, bench_file, command, options);
    require_one(command.pressure_drops, pressure_labels.curve);
    const MeasuredCurve measured = measured_drops(command.pressure_drops.front());
    const CurveNoise noise = noise_for(command, pressure_labels, pressure_noise());
    OutputFolder folder =
        folder_for(bench_file, inputs_of(bench_file, file.bench, command), options);
    Progress progress(options.quiet);
    const CurveBench<PressureBench> bench = pressure_curve_bench(file.bench, measured.abscissae);
    const auto changes_of = [&](const EffectFit& fit) {
        return changed_pressure_keys(bench.base, with_effects(bench, active_effects(fit)));
    };
    finish(folder, measured, noise, bench,
           {pressure_labels, bench_file, command.pressure_drops.front(), command.noise,
            file.device_notes, changes_of},
           options, progress);
}

}  // namespace braidzone
