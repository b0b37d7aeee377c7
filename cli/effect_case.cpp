#include "cli/effect_case.hpp"

#include "cli/case_geometry.hpp"
#include "cli/explanation_report.hpp"
#include "cli/resolved_case.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace braidzone {

Model model_of(const Case& job, const Centerline& centerline)
{
    return {.device = job.device,
            .landing_distal = arc_length_at(job.landing_distal, centerline),
            .schedule = job.schedule,
            .options = job.deployment,
            .wall_offset = job.vessel.wall_offset,
            .imaging = job.measurement};
}

Case case_of(const Case& job, const Model& model)
{
    Case altered = job;
    altered.device = model.device;
    altered.landing_distal = model.landing_distal;
    altered.schedule = model.schedule;
    altered.deployment = model.options;
    altered.vessel.wall_offset = model.wall_offset;
    altered.measurement = model.imaging;
    return altered;
}

std::vector<std::string> changed_keys(const Case& before, const Case& after)
{
    const auto old_values = resolved_case(before).flatten();
    const auto new_values = resolved_case(after).flatten();
    std::vector<std::string> changes;
    for (const auto& [pointer, value] : new_values.items()) {
        const bool is_new = !old_values.contains(pointer);
        if (!is_new && old_values[pointer] == value) continue;
        std::string key = pointer.substr(1);
        std::replace(key.begin(), key.end(), '/', '.');
        changes.push_back(fmt::format(
            "{}: {} -> {}", key, is_new ? "absent" : old_values[pointer].dump(), value.dump()));
    }
    return changes;
}

std::string effect_case_text(const Case& job, const Model& model, const EffectFit& fit,
                             const std::filesystem::path& data)
{
    const Case altered = case_of(job, model);
    std::string text =
        fmt::format("# {} with {}, found by braidzone diagnose in\n# {}.\n", job.file.string(),
                    name_of(fit), std::filesystem::absolute(data).string());
    for (const FittedEffect& effect : fit.effects) {
        text += fmt::format("# {}: {}\n", effect.name, fmt::join(parameter_texts(effect), ", "));
    }
    text += fmt::format(
        "# (from the curvature at the best fit; their coverage is not checked).\n"
        "# ln Bayes factor against no effect {:.1f}. Changed values:\n",
        fit.log_evidence);
    for (const std::string& change : changed_keys(job, altered))
        text += fmt::format("#   {}\n", change);
    return text + "\n" + resolved_case_text(altered);
}

}  // namespace braidzone
