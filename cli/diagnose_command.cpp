#include "cli/case_geometry.hpp"
#include "cli/commands.hpp"
#include "cli/diagnosis_report.hpp"
#include "cli/discrepancy_picture.hpp"
#include "cli/discrepancy_vtp.hpp"
#include "cli/effect_case.hpp"
#include "cli/file_hash.hpp"
#include "cli/output_folder.hpp"
#include "cli/progress.hpp"
#include "cli/result_files.hpp"
#include "cli/summary.hpp"
#include "core/error.hpp"
#include "discrepancy/diagnosis.hpp"
#include "discrepancy/measured_surface.hpp"
#include "export/text_file.hpp"

#include <fmt/format.h>

#include <utility>

namespace braidzone {
namespace {

namespace fs = std::filesystem;

/// What the effects' fits cannot vary, or not within minutes.
void require_covered(const Case& job)
{
    if (job.second_device) {
        throw ConfigError(fmt::format("{}: second_device is not covered by diagnose; leave it out",
                                      job.file.string()));
    }
    if (job.deployment.axial == AxialMotion::free) {
        throw ConfigError(fmt::format(
            "{}: deployment.axial = \"free\" is not covered by diagnose, which deploys the device "
            "hundreds of times; set it to \"locked\"",
            job.file.string()));
    }
}

/// The vessel without the case's own wall offset, which the model holds.
Lumen lumen_of(const Case& job)
{
    VesselSource source = job.vessel;
    source.wall_offset = 0.0;
    Vessel vessel = read_vessel(source);
    WallTree wall(vessel);
    Centerline centerline = resample(find_centerline(source, vessel, wall));
    return {std::move(vessel), std::move(wall), std::move(centerline)};
}

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
                                     {"measured", input_as_json(command.measured)}};
    if (command.scalars) inputs["scalars"] = input_as_json(*command.scalars);
    if (command.noise) inputs["noise"] = input_as_json(*command.noise);
    return inputs;
}

/// One case file for each effect of the answer.
void write_effect_cases(const fs::path& folder, const Case& job, const Diagnosis& diagnosis,
                        const fs::path& measured)
{
    for (const std::string& name : diagnosis.verdict.effects) {
        for (std::size_t i = 0; i < diagnosis.fits.size(); ++i) {
            const EffectFit& fit = diagnosis.fits[i];
            if (fit.effect != name) continue;
            const Model model = effect_catalogue()[i].apply(diagnosis.setting, fit.values);
            write_text_file(folder / fmt::format("case_with_{}.toml", name),
                            effect_case_text(job, model, fit, measured));
        }
    }
}

}  // namespace

void diagnose_case(const fs::path& case_file, const DiagnoseCommand& command,
                   const CommonOptions& options)
{
    Case job = read_case(case_file, options.overrides);
    require_covered(job);
    job.vessel.surface = fs::absolute(job.vessel.surface).lexically_normal();
    if (job.vessel.centerline)
        job.vessel.centerline = fs::absolute(*job.vessel.centerline).lexically_normal();
    std::optional<LengthUnit> unit;
    if (command.length_unit) unit = length_unit(*command.length_unit);
    std::vector<Vec3> points = read_measured_surface(command.measured, unit);
    DiagnoseOptions diagnose_options;
    if (command.noise) diagnose_options.floor = read_noise_floor(*command.noise);
    OutputFolder folder(
        options.output.value_or(fs::path(case_file).replace_extension(".diagnosis.out")),
        options.force, "diagnosis.json");

    Progress progress(options.quiet);
    progress.begin("vessel", "reading the vessel");
    const Lumen lumen = lumen_of(job);
    const MeasuredScalars scalars = scalars_of(command, lumen.centerline);
    progress.begin("diagnose", "deploying the device");
    diagnose_options.on_progress = [&](const std::string& doing) {
        progress.begin("diagnose", doing);
    };
    const std::vector<Effect>& catalogue = effect_catalogue();
    const Diagnosis diagnosis = diagnose(model_of(job, lumen.centerline), lumen, std::move(points),
                                         scalars, catalogue, diagnose_options);
    progress.begin("export", "writing the results");
    write_discrepancy_picture(folder.path() / "discrepancy.png", diagnosis);
    write_discrepancy_vtp(folder.path() / "discrepancy.vtp", diagnosis, lumen.vessel.unit);
    write_effect_cases(folder.path(), job, diagnosis, command.measured);
    progress.end();

    nlohmann::ordered_json json = {{"program", program_name}};
    json.update(diagnosis_as_json(diagnosis, catalogue, diagnose_options.floor));
    json["inputs"] = inputs_as_json(job, command);
    json["files"] = files_in(folder.path());
    for (const StageTime& time : progress.times())
        json["times_s"][time.stage] = time.seconds;
    write_text_file(folder.path() / "diagnosis.json", json.dump(1) + "\n");
    folder.commit();

    if (options.quiet) return;
    fmt::print("{}  {:<12}{}\n", diagnosis_summary(diagnosis, catalogue), "results",
               folder.final_path().string());
}

}  // namespace braidzone
