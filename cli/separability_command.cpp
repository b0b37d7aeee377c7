#include "cli/case_hash.hpp"
#include "cli/commands.hpp"
#include "cli/diagnosed_case.hpp"
#include "cli/effect_case.hpp"
#include "cli/output_files.hpp"
#include "cli/progress.hpp"
#include "cli/separability_report.hpp"
#include "cli/summary.hpp"
#include "cli/unfinished_work.hpp"
#include "core/error.hpp"
#include "discrepancy/diagnosis.hpp"
#include "discrepancy/hub_slopes.hpp"
#include "discrepancy/planned_measurement.hpp"
#include "discrepancy/surface_problem.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace braidzone {
namespace {

/// With the surface and end markers, and a density map or the contact force besides.
std::vector<ChannelSeparability> separability_by_channels(const DiagnosisProblem& problem,
                                                          const Observations& planned)
{
    const Observations surface{.points = {}, .field = planned.field, .scalars = {}};
    const PlannedRows rows = planned_rows(surface, planned);
    std::vector<ChannelSeparability> all = {{"surface", separability(problem, rows.measured)}};
    std::vector<int> with_ends = rows.measured;
    for (const FurtherChannel& channel : rows.channels) {
        std::vector<int> with = with_ends;
        with.insert(with.end(), channel.rows.begin(), channel.rows.end());
        const bool is_ends = channel.name == "end_markers";
        std::string name = channel.name;
        std::replace(name.begin(), name.end(), '_', ' ');
        all.push_back({is_ends ? "surface and " + name : "surface, end markers and " + name,
                       separability(problem, with), channel.measurement});
        if (is_ends) with_ends = std::move(with);
    }
    return all;
}

}  // namespace

void tell_separability(const std::filesystem::path& case_file, const DiagnoseCommand& command,
                       const CommonOptions& options)
{
    if (!command.measured.empty() || command.scalars || command.density_map) {
        throw ConfigError(
            "--separability tells what a measurement could tell before there is one; leave "
            "--measured, --scalars and --density-map out");
    }
    const Case job = read_diagnosed_case(case_file, options.overrides);
    const NoiseFloor floor = command.noise ? read_noise_floor(*command.noise) : NoiseFloor{};
    std::vector<InputFile> inputs = input_files(job);
    if (command.noise) inputs.push_back({"noise floor", *command.noise});
    TextOutput output(
        options.output.value_or(
            std::filesystem::absolute(case_file).replace_extension(".separability.json")),
        inputs, options.force);
    Progress progress(options.quiet);
    progress.begin("vessel", "reading the vessel");
    const Lumen lumen = lumen_of(job);
    ResidualMemory memory = unfinished_simulations(std::filesystem::absolute(output.path()),
                                                   {case_hash(job), "separability"});
    progress.begin("separability", doing_with("trying each effect on each other one", memory));
    const Model model = model_of(job, lumen.centerline);
    const Simulation base = simulate(model, lumen);
    Observations planned = planned_observations(base, model.imaging);
    set_hub_slopes(planned, model, base, lumen);
    const EffectSetting setting = effect_setting(model, base, planned.points);
    const ErrorModel error = make_error_model(planned, floor);
    const DiagnosisProblem problem = memory.around(
        surface_problem({lumen, setting, base, planned, error, floor}, effect_catalogue()));
    const std::vector<ChannelSeparability> all = separability_by_channels(problem, planned);
    progress.end();

    nlohmann::ordered_json json = {{"program", program_name}};
    for (const ChannelSeparability& channels : all)
        json["separability"].push_back(separability_as_json(channels));
    json["gains"] = gains_as_json(all);
    output.write(json.dump(1) + "\n");
    memory.forget();
    if (options.quiet) return;
    for (const ChannelSeparability& channels : all)
        fmt::print("{}\n", separability_text(channels));
    fmt::print("{}\n", gains_text(all));
    fmt::print("written to {}\n", output.path().string());
}

}  // namespace braidzone
