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
#include "discrepancy/planned_measurement.hpp"
#include "discrepancy/surface_problem.hpp"

#include <fmt/format.h>

#include <numeric>

namespace braidzone {

void tell_separability(const std::filesystem::path& case_file, const DiagnoseCommand& command,
                       const CommonOptions& options)
{
    if (!command.measured.empty() || command.scalars) {
        throw ConfigError(
            "--separability tells what a measurement could tell before there is one; leave "
            "--measured and --scalars out");
    }
    const Case job = read_diagnosed_case(case_file, options.overrides);
    const NoiseFloor floor = command.noise ? read_noise_floor(*command.noise) : NoiseFloor{};
    TextOutput output(
        options.output.value_or(
            std::filesystem::absolute(case_file).replace_extension(".separability.json")),
        options.force);
    Progress progress(options.quiet);
    progress.begin("vessel", "reading the vessel");
    const Lumen lumen = lumen_of(job);
    ResidualMemory memory = unfinished_simulations(std::filesystem::absolute(output.path()),
                                                   {case_hash(job), "separability"});
    progress.begin("separability", doing_with("trying each effect on each other one", memory));
    const Model model = model_of(job, lumen.centerline);
    const Simulation base = simulate(model, lumen);
    const Observations planned = planned_observations(base, model.imaging);
    const EffectSetting setting = effect_setting(model, base, planned.points);
    const ErrorModel error = make_error_model(planned, floor);
    const DiagnosisProblem problem = memory.around(
        surface_problem({lumen, setting, base, planned, error, floor}, effect_catalogue()));
    std::vector<int> rows(static_cast<std::size_t>(error.num_patches));
    std::iota(rows.begin(), rows.end(), 0);
    std::vector<ChannelSeparability> all = {{"surface", separability(problem, rows)}};
    rows.resize(static_cast<std::size_t>(num_residuals(planned)));
    std::iota(rows.begin(), rows.end(), 0);
    all.push_back({"surface and end markers", separability(problem, rows)});
    progress.end();

    nlohmann::ordered_json json = {{"program", program_name}};
    for (const ChannelSeparability& channels : all)
        json["separability"].push_back(separability_as_json(channels));
    output.write(json.dump(1) + "\n");
    memory.forget();
    if (options.quiet) return;
    for (const ChannelSeparability& channels : all)
        fmt::print("{}\n", separability_text(channels));
    fmt::print("written to {}\n", output.path().string());
}

}  // namespace braidzone
