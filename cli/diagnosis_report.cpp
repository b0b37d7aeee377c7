#include "cli/diagnosis_report.hpp"

#include "cli/effect_case.hpp"
#include "discrepancy/background_estimate.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace braidzone {
namespace {

using Json = nlohmann::ordered_json;

constexpr double significant = 0.05;

Json mm(double metres)
{
    return {{"value", 1e3 * metres}, {"unit", "mm"}};
}

double degrees(double radians)
{
    return radians * 180.0 / std::numbers::pi;
}

const Effect& effect_named(const std::vector<Effect>& catalogue, const std::string& name)
{
    return *std::find_if(catalogue.begin(), catalogue.end(),
                         [&](const Effect& effect) { return effect.name == name; });
}

/// Where a cluster lies, in words.
std::string label(const ClusterPlace& place, const Cluster& cluster)
{
    if (place.neck > 0.5) return "neck";
    if (place.ends > 0.5) return "end of the device";
    return cluster.contact_share > 0.5 ? "on the wall" : "free of the wall";
}

std::string cluster_text(const Cluster& cluster, const ClusterPlace& place)
{
    return fmt::format(
        "{:.2f} to {:.2f} mm along the centerline, {:.0f} degrees, {}: gap {:.3f} mm on average, "
        "{:.3f} mm at most, {:.2g} mm2, p = {:.2g}",
        1e3 * cluster.from, 1e3 * cluster.to, degrees(cluster.angle), label(place, cluster),
        1e3 * cluster.mean_gap, 1e3 * cluster.largest_gap, 1e6 * cluster.area,
        cluster.p_family_wise);
}

Json cluster_as_json(const Cluster& cluster, const ClusterPlace& place)
{
    return {{"p_family_wise", cluster.p_family_wise},
            {"label", label(place, cluster)},
            {"from", mm(cluster.from)},
            {"to", mm(cluster.to)},
            {"arc_length", mm(cluster.arc_length)},
            {"angle", {{"value", degrees(cluster.angle)}, {"unit", "deg"}}},
            {"area", {{"value", 1e6 * cluster.area}, {"unit", "mm^2"}}},
            {"mean_gap", mm(cluster.mean_gap)},
            {"largest_gap", mm(cluster.largest_gap)},
            {"share_on_wall", cluster.contact_share},
            {"share_in_neck", place.neck},
            {"share_at_ends", place.ends},
            {"num_patches", cluster.patches.size()}};
}

Json fit_as_json(const EffectFit& fit, const std::vector<NamedEvidence>& named)
{
    Json json = {{"effect", fit.effect}, {"num_runs", fit.num_runs}};
    if (!fit.failure.empty()) {
        json["failure"] = fit.failure;
        return json;
    }
    const auto evidence = std::find_if(named.begin(), named.end(), [&](const NamedEvidence& one) {
        return one.effect == fit.effect;
    });
    json["log_bayes_factor"] = fit.log_evidence;
    json["log_bayes_factor_unknown_besides"] = evidence->log_evidence_unknown;
    json["log_bayes_factor_scalars_besides"] = evidence->log_evidence_scalars;
    json["chi_square"] = fit.chi_square;
    for (const FitMode& mode : fit.modes) {
        Json end = {{"log_bayes_factor", mode.log_evidence}};
        for (std::size_t i = 0; i < mode.values.size(); ++i)
            end[fit.parameters[i].name] = mode.values[i] / reported_unit(fit.parameters[i]);
        json["ends_of_fits"].push_back(end);
    }
    for (std::size_t i = 0; i < fit.values.size(); ++i) {
        const EffectParameter& parameter = fit.parameters[i];
        const double unit = reported_unit(parameter);
        json["parameters"][parameter.name] = {
            {"value", fit.values[i] / unit}, {"sd", fit.sd[i] / unit}, {"unit", parameter.unit}};
    }
    return json;
}

Json figures_as_json(const GapFigures& figures)
{
    return {{"rms", mm(figures.rms)},
            {"percentile_95", mm(figures.percentile_95)},
            {"largest_smoothed", mm(figures.largest_smoothed)}};
}

Json gaps_as_json(const GapComparison& gaps, bool has_effect)
{
    Json json = {{"num_patches", gaps.num_patches}, {"before", figures_as_json(gaps.before)}};
    json["after"] = has_effect ? figures_as_json(gaps.after) : Json();
    json["noise_floor"] = figures_as_json(gaps.floor);
    return json;
}

std::string gap_line(const char* name, const GapComparison& gaps, bool has_effect)
{
    const auto text = [](const GapFigures& g) {
        return fmt::format("{:.3f} / {:.3f} / {:.3f}", 1e3 * g.rms, 1e3 * g.percentile_95,
                           1e3 * g.largest_smoothed);
    };
    return fmt::format("  {:<12}{:<24}{:<24}{}\n", name, text(gaps.before),
                       has_effect ? text(gaps.after) : "-", text(gaps.floor));
}

Json patches_as_json(const Diagnosis& diagnosis)
{
    Json patches = Json::array();
    const auto& all = diagnosis.observations.field.patches;
    for (std::size_t i = 0; i < all.size(); ++i) {
        const auto row = static_cast<Eigen::Index>(i);
        Json patch = {{"arc_length_mm", 1e3 * all[i].arc_length},
                      {"angle_deg", degrees(all[i].angle)},
                      {"num_points", all[i].points.size()},
                      {"median_mm", 1e3 * all[i].median},
                      {"point_sd_mm", 1e3 * all[i].point_sd},
                      {"gap_before_mm", 1e3 * diagnosis.map.gap[row]},
                      {"t_before", diagnosis.map.t[row]},
                      {"unexplained_mm", 1e3 * diagnosis.unexplained[row]}};
        if (diagnosis.map_after) patch["gap_after_mm"] = 1e3 * diagnosis.map_after->gap[row];
        patches.push_back(patch);
    }
    return patches;
}

Json scalars_as_json(const Diagnosis& diagnosis)
{
    Json all = Json::object();
    Eigen::Index row = diagnosis.error.num_patches;
    for (std::size_t i = 0; i < scalar_names.size(); ++i) {
        const auto& measured = diagnosis.observations.scalars.values[i];
        if (!measured) continue;
        Json scalar = {{"unit", "mm"},
                       {"measured", 1e3 * measured->value},
                       {"sd", 1e3 * measured->sd},
                       {"before", 1e3 * (measured->value - diagnosis.base_residuals[row])}};
        if (diagnosis.best) {
            scalar["after"] =
                1e3 * (measured->value - diagnosis.fits[*diagnosis.best].residuals[row]);
        }
        all[std::string(scalar_names[i])] = scalar;
        ++row;
    }
    return all;
}

/// Other places at which the same effect fits about as well, if its fits ended in several.
std::string other_modes(const EffectFit& fit)
{
    constexpr double margin = 3.0;  // a Bayes factor of 20
    std::string text;
    for (const FitMode& mode : fit.modes) {
        if (fit.log_evidence - mode.log_evidence > margin) continue;
        for (std::size_t i = 0; i < mode.values.size(); ++i) {
            const double unit = reported_unit(fit.parameters[i]);
            if (!fit.parameters[i].is_uniform ||
                std::abs(mode.values[i] - fit.values[i]) < 3.0 * fit.sd[i])
                continue;
            text += fmt::format(" It fits about as well at {} = {:.4g} {}.", fit.parameters[i].name,
                                mode.values[i] / unit, fit.parameters[i].unit);
        }
    }
    return text;
}

/// The known effect that comes nearest to an unknown one.
std::string nearest_known(const Diagnosis& diagnosis)
{
    const EffectFit* nearest = nullptr;
    for (const EffectFit& fit : diagnosis.fits) {
        if (fit.failure.empty() && (nearest == nullptr || fit.chi_square < nearest->chi_square))
            nearest = &fit;
    }
    if (nearest == nullptr) return "";
    return fmt::format(" The most similar known effect, {}, takes {:.0f} % off the misfit.",
                       nearest->effect, 100.0 * (1.0 - nearest->chi_square / diagnosis.chi_square));
}

}  // namespace

std::string diagnosis_answer(const Diagnosis& diagnosis, const std::vector<Effect>& catalogue)
{
    const Verdict& verdict = diagnosis.verdict;
    std::string text;
    if (verdict.finding == Finding::nothing_missing) {
        return fmt::format(
            "Nothing is missing: the surfaces agree within the noise floor of "
            "{:.3f} mm (RMS of the patches).",
            1e3 * diagnosis.everywhere.floor.rms);
    }
    if (verdict.finding == Finding::unknown) {
        return "Something is missing, but none of the known effects explains it." +
               nearest_known(diagnosis);
    }
    const EffectFit& fit = diagnosis.fits[*diagnosis.best];
    if (verdict.finding == Finding::named) {
        text = fmt::format("{}: {} ({}).", fit.effect, effect_named(catalogue, fit.effect).title,
                           fmt::join(parameter_texts(fit), ", ")) +
               other_modes(fit);
    } else {
        text = fmt::format("One of {}; the data do not tell them apart. What would: {}.",
                           fmt::join(verdict.effects, ", "),
                           effect_named(catalogue, verdict.effects.front()).separated_by);
    }
    if (verdict.has_unexplained_rest) text += " Something remains that it does not explain.";
    return text;
}

std::vector<std::string> diagnosis_warnings(const Diagnosis& diagnosis)
{
    std::vector<std::string> warnings;
    if (diagnosis.background > largest_background_scale) {
        warnings.push_back(
            fmt::format("the noise floor does not fit these data: with the best model they scatter "
                        "{:.2f} times "
                        "as much as its background; learn one from cases without an effect "
                        "(--calibrate), and do "
                        "not trust the answer",
                        diagnosis.background));
    }
    const DiscrepancyField& field = diagnosis.observations.field;
    if (field.num_far + field.num_in_sparse + field.num_on_rim > 0) {
        warnings.push_back(fmt::format(
            "of {} measured points {} lie over the device's rim, {} more than {:.3g} mm from the "
            "device and {} in patches of fewer than {}: they do not count",
            field.num_points, field.num_on_rim, field.num_far, 1e3 * field.options.farthest,
            field.num_in_sparse, field.options.fewest_points));
    }
    for (const EffectFit& fit : diagnosis.fits) {
        if (!fit.failure.empty())
            warnings.push_back(
                fmt::format("{} could not be simulated: {}", fit.effect, fit.failure));
    }
    return warnings;
}

Json diagnosis_as_json(const Diagnosis& diagnosis, const std::vector<Effect>& catalogue,
                       const NoiseFloor& floor)
{
    Json json = {{"answer",
                  {{"finding", name_of(diagnosis.verdict.finding)},
                   {"effects", diagnosis.verdict.effects},
                   {"has_unexplained_rest", diagnosis.verdict.has_unexplained_rest},
                   {"text", diagnosis_answer(diagnosis, catalogue)}}},
                 {"warnings", diagnosis_warnings(diagnosis)}};
    json["clusters"] = Json::array();
    for (std::size_t i = 0; i < diagnosis.map.clusters.size(); ++i)
        json["clusters"].push_back(cluster_as_json(diagnosis.map.clusters[i], diagnosis.places[i]));
    json["log_bayes_factor_unknown"] = diagnosis.log_evidence_unknown;
    json["log_bayes_factor_scalars"] = diagnosis.log_evidence_scalars;
    json["chi_square"] = diagnosis.chi_square;
    json["effects"] = Json::array();
    for (const EffectFit& fit : diagnosis.fits)
        json["effects"].push_back(fit_as_json(fit, diagnosis.named));
    const bool has_effect = diagnosis.best.has_value();
    json["gaps"] = {{"everywhere", gaps_as_json(diagnosis.everywhere, has_effect)},
                    {"affected_zone", gaps_as_json(diagnosis.in_zone, has_effect)}};
    json["scalars"] = scalars_as_json(diagnosis);
    json["background_scale"] = diagnosis.background;
    json["noise_floor"] = Json::parse(noise_floor_text(floor));
    json["points"] = {{"measured", diagnosis.observations.field.num_points},
                      {"on_rim", diagnosis.observations.field.num_on_rim},
                      {"far", diagnosis.observations.field.num_far},
                      {"in_sparse_patches", diagnosis.observations.field.num_in_sparse}};
    json["num_deployments"] = diagnosis.num_runs;
    json["patches"] = patches_as_json(diagnosis);
    return json;
}

std::string diagnosis_summary(const Diagnosis& diagnosis, const std::vector<Effect>& catalogue)
{
    std::string text = diagnosis_answer(diagnosis, catalogue) + "\n";
    bool has_cluster = false;
    for (std::size_t i = 0; i < diagnosis.map.clusters.size(); ++i) {
        if (diagnosis.map.clusters[i].p_family_wise >= significant) continue;
        text += fmt::format("{}    {}\n", has_cluster ? "" : "  where\n",
                            cluster_text(diagnosis.map.clusters[i], diagnosis.places[i]));
        has_cluster = true;
    }
    if (!has_cluster) text += "  no cluster of patches beyond the noise floor\n";
    const bool has_effect = diagnosis.best.has_value();
    text += fmt::format("  {:<12}{:<24}{:<24}{}\n", "gap [mm]", "before", "after", "noise floor");
    text += gap_line("everywhere", diagnosis.everywhere, has_effect);
    if (!diagnosis.zone.empty()) text += gap_line("in the zone", diagnosis.in_zone, has_effect);
    text += "  (RMS / 95th percentile / largest smoothed)\n  ln Bayes factors:";
    for (const NamedEvidence& named : diagnosis.named)
        text += fmt::format(" {} {:.1f},", named.effect, named.log_evidence);
    text += fmt::format(" unknown {:.1f}, ends or length unknown {:.1f}\n",
                        diagnosis.log_evidence_unknown, diagnosis.log_evidence_scalars);
    for (const std::string& warning : diagnosis_warnings(diagnosis))
        text += fmt::format("  note: {}\n", warning);
    return text;
}

}  // namespace braidzone
