#include "cli/diagnosis_report.hpp"

#include "cli/channel_report.hpp"
#include "cli/explanation_report.hpp"
#include "cli/further_report.hpp"
#include "discrepancy/background_estimate.hpp"

#include <fmt/format.h>

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

Json held_out_as_json(const Diagnosis& diagnosis, bool has_effect)
{
    // Where the gap was hardly above the floor, a share of what was above it says nothing.
    constexpr double clearly_above = 1.1;
    const GapComparison& gap = diagnosis.gap_held_out;
    Json json = gaps_as_json(gap, has_effect);
    if (has_effect && gap.before.rms > clearly_above * gap.floor.rms)
        json["closure"] = closure(gap);
    return json;
}

/// Within what measurement and simulation agree if nothing is missing.
std::string floor_text(const Diagnosis& diagnosis)
{
    return fmt::format("{:.3f} mm (RMS of the patches)", 1e3 * diagnosis.everywhere.floor.rms);
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
                      {"gap_mm", 1e3 * all[i].gap},
                      {"point_sd_mm", 1e3 * all[i].point_sd},
                      {"gap_before_mm", 1e3 * diagnosis.map.gap[row]},
                      {"t_before", diagnosis.map.t[row]},
                      {"unexplained_mm", 1e3 * diagnosis.explanation.unexplained[row]}};
        if (diagnosis.map_after) patch["gap_after_mm"] = 1e3 * diagnosis.map_after->gap[row];
        patches.push_back(patch);
    }
    return patches;
}

Json scalars_as_json(const Diagnosis& diagnosis)
{
    const Explanation& explanation = diagnosis.explanation;
    Json all = Json::object();
    Eigen::Index row = diagnosis.error.num_patches;
    for (std::size_t i = 0; i < scalar_names.size(); ++i) {
        const auto& measured = diagnosis.observations.scalars.values[i];
        if (!measured) continue;
        Json scalar = {{"unit", "mm"},
                       {"measured", 1e3 * measured->value},
                       {"sd", 1e3 * measured->sd},
                       {"before", 1e3 * (measured->value - explanation.base_residuals[row])}};
        if (explanation.best) {
            scalar["after"] = 1e3 * (measured->value - explanation.residuals_after()[row]);
        }
        all[std::string(scalar_names[i])] = scalar;
        ++row;
    }
    return all;
}

}  // namespace

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
    if (!diagnosis.artefacts.empty()) {
        std::vector<std::string> places;
        for (const Patch& patch : diagnosis.artefacts) {
            places.push_back(fmt::format("{:.1f} mm and {:.0f} degrees ({} points)",
                                         1e3 * patch.arc_length, degrees(patch.angle),
                                         patch.points.size()));
        }
        warnings.push_back(fmt::format(
            "left out as artefacts of the scan, more than 5 standard deviations off what their "
            "neighbours say: the points at {}",
            fmt::join(places, ", ")));
    }
    if (diagnosis.observations.density.num_beyond_ends > 0) {
        warnings.push_back(fmt::format(
            "{} places of the density map lie beyond the simulated device's ends: they do not "
            "count",
            diagnosis.observations.density.num_beyond_ends));
    }
    const auto failures = failure_warnings(diagnosis.explanation);
    warnings.insert(warnings.end(), failures.begin(), failures.end());
    return warnings;
}

std::string diagnosis_answer(const Diagnosis& diagnosis)
{
    return explanation_answer(diagnosis.explanation, diagnosis.held_out, floor_text(diagnosis),
                              further_text(diagnosis.further));
}

Json diagnosis_as_json(const Diagnosis& diagnosis, const NoiseFloor& floor)
{
    Json json = explanation_as_json(diagnosis.explanation, diagnosis.held_out,
                                    floor_text(diagnosis), further_text(diagnosis.further));
    json["further_measurement"] = further_as_json(diagnosis.further);
    json["warnings"] = diagnosis_warnings(diagnosis);
    json["clusters"] = Json::array();
    for (std::size_t i = 0; i < diagnosis.map.clusters.size(); ++i)
        json["clusters"].push_back(cluster_as_json(diagnosis.map.clusters[i], diagnosis.places[i]));
    const bool has_effect = diagnosis.explanation.best.has_value();
    json["gaps"] = {{"everywhere", gaps_as_json(diagnosis.everywhere, has_effect)},
                    {"affected_zone", gaps_as_json(diagnosis.in_zone, has_effect)},
                    {"held_out", held_out_as_json(diagnosis, has_effect)}};
    json["scalars"] = scalars_as_json(diagnosis);
    json["channels"] = channels_as_json(diagnosis);
    json["density_map"] = density_map_as_json(diagnosis);
    json["background_scale"] = diagnosis.background;
    json["noise_floor"] = Json::parse(noise_floor_text(floor));
    json["points"] = {{"measured", diagnosis.observations.field.num_points},
                      {"on_rim", diagnosis.observations.field.num_on_rim},
                      {"far", diagnosis.observations.field.num_far},
                      {"in_sparse_patches", diagnosis.observations.field.num_in_sparse},
                      {"patches_of_artefacts", diagnosis.artefacts.size()}};
    json["leaves_doubt"] = diagnosis.leaves_doubt();
    json["patches"] = patches_as_json(diagnosis);
    return json;
}

std::string diagnosis_summary(const Diagnosis& diagnosis)
{
    std::string text = diagnosis_answer(diagnosis) + "\n";
    bool has_cluster = false;
    for (std::size_t i = 0; i < diagnosis.map.clusters.size(); ++i) {
        if (diagnosis.map.clusters[i].p_family_wise >= significant) continue;
        text += fmt::format("{}    {}\n", has_cluster ? "" : "  where\n",
                            cluster_text(diagnosis.map.clusters[i], diagnosis.places[i]));
        has_cluster = true;
    }
    if (!has_cluster) text += "  no cluster of patches beyond the noise floor\n";
    const bool has_effect = diagnosis.explanation.best.has_value();
    text += fmt::format("  {:<12}{:<24}{:<24}{}\n", "gap [mm]", "before", "after", "noise floor");
    text += gap_line("everywhere", diagnosis.everywhere, has_effect);
    if (!diagnosis.zone.empty()) text += gap_line("in the zone", diagnosis.in_zone, has_effect);
    text += gap_line("held out", diagnosis.gap_held_out, has_effect);
    text += "  (RMS / 95th percentile / largest smoothed)\n" + channels_text(diagnosis) +
            further_table(diagnosis.further);
    text += fmt::format("  {}\n", evidence_text(diagnosis.explanation));
    for (const std::string& warning : diagnosis_warnings(diagnosis))
        text += fmt::format("  note: {}\n", warning);
    return text;
}

}  // namespace braidzone
