#include "cli/channel_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

namespace braidzone {
namespace {

using Json = nlohmann::ordered_json;

/// A row of the report, all values in its unit.
struct ChannelRow {
    std::string name, title, unit;
    std::optional<double> before, after, measured, sd;
};

/// The unit in which a density is reported.
struct DensityUnit {
    std::string name;
    double size;  ///< SI value of one
};

DensityUnit density_unit(DensityQuantity quantity)
{
    if (quantity == DensityQuantity::pore_density) return {"1/mm^2", 1e6};
    return {"%", 0.01};
}

/// The density map at its places, in its SI unit.
struct DensityValues {
    Eigen::VectorXd measured, sd, before, after;  ///< `after` is empty if there is no effect
};

DensityValues density_values(const Diagnosis& diagnosis)
{
    const ResidualRows rows = residual_rows(diagnosis.observations);
    const auto& places = diagnosis.observations.density.places;
    DensityValues values;
    values.measured.resize(rows.num_density);
    values.sd.resize(rows.num_density);
    for (Eigen::Index i = 0; i < rows.num_density; ++i) {
        values.measured[i] = places[static_cast<std::size_t>(i)].value;
        values.sd[i] = places[static_cast<std::size_t>(i)].sd;
    }
    const auto simulated = [&](const Eigen::VectorXd& residuals) -> Eigen::VectorXd {
        return values.measured - residuals.segment(rows.density, rows.num_density);
    };
    values.before = simulated(diagnosis.explanation.base_residuals);
    if (diagnosis.explanation.best)
        values.after = simulated(diagnosis.explanation.residuals_after());
    return values;
}

double rms(const Eigen::VectorXd& values)
{
    return std::sqrt(values.squaredNorm() / static_cast<double>(values.size()));
}

/// Means over the places of the map, and how far measurement and simulation are apart there.
void add_density_rows(std::vector<ChannelRow>& rows, const Diagnosis& diagnosis)
{
    const DensityField& field = diagnosis.observations.density;
    if (field.places.empty()) return;
    const DensityValues values = density_values(diagnosis);
    const DensityUnit unit = density_unit(field.quantity);
    const auto count = static_cast<double>(field.places.size());
    const auto of_after = [&](const auto& figure) -> std::optional<double> {
        if (values.after.size() == 0) return std::nullopt;
        return figure(values.after) / unit.size;
    };
    std::string title(name_of(field.quantity));
    std::replace(title.begin(), title.end(), '_', ' ');
    const auto mean = [](const Eigen::VectorXd& v) { return v.mean(); };
    const auto gap = [&](const Eigen::VectorXd& v) { return rms(values.measured - v); };
    rows.push_back({"density_map_mean", fmt::format("{} at the {} places", title, count), unit.name,
                    mean(values.before) / unit.size, of_after(mean),
                    values.measured.mean() / unit.size,
                    rms(values.sd) / std::sqrt(count) / unit.size});
    rows.push_back({"density_map_gap", "its gap, root mean square", unit.name,
                    gap(values.before) / unit.size, of_after(gap), std::nullopt,
                    rms(values.sd) / unit.size});
}

void add_force_rows(std::vector<ChannelRow>& rows, const Diagnosis& diagnosis)
{
    const auto& measured = diagnosis.observations.scalars.contact_force;
    const auto& after = diagnosis.predicted_after;
    ChannelRow whole{"contact_force",
                     "force on the wall",
                     "N",
                     diagnosis.predicted_before.contact_force,
                     {},
                     {},
                     {}};
    if (after) whole.after = after->contact_force;
    const bool is_whole = measured && std::isinf(measured->from);
    if (is_whole) {
        whole.measured = measured->force.value;
        whole.sd = measured->force.sd;
    }
    rows.push_back(whole);
    if (!measured || is_whole) return;
    const Eigen::Index row = residual_rows(diagnosis.observations).force;
    ChannelRow stretch{
        "contact_force_of_stretch",
        fmt::format("of {:.4g} to {:.4g} mm", 1e3 * measured->from, 1e3 * measured->to),
        "N",
        measured->force.value - diagnosis.explanation.base_residuals[row],
        {},
        measured->force.value,
        measured->force.sd};
    if (diagnosis.explanation.best)
        stretch.after = measured->force.value - diagnosis.explanation.residuals_after()[row];
    rows.push_back(stretch);
}

/// As measured, or between both ends.
std::optional<MeasuredValue> measured_length(const MeasuredScalars& scalars)
{
    const auto& [distal, proximal, length] = scalars.values;
    if (length || !distal || !proximal) return length;
    return MeasuredValue{distal->value - proximal->value, std::hypot(distal->sd, proximal->sd)};
}

std::vector<ChannelRow> channel_rows(const Diagnosis& diagnosis)
{
    const DevicePrediction& before = diagnosis.predicted_before;
    const auto& after = diagnosis.predicted_after;
    std::vector<ChannelRow> rows;
    ChannelRow length{
        "implanted_length", "implanted length", "mm", 1e3 * before.implanted_length, {}, {}, {}};
    if (after) length.after = 1e3 * after->implanted_length;
    if (const auto measured = measured_length(diagnosis.observations.scalars)) {
        length.measured = 1e3 * measured->value;
        length.sd = 1e3 * measured->sd;
    }
    rows.push_back(length);
    ChannelRow density{"mean_density_increase",
                       "density increase",
                       "%",
                       100.0 * before.mean_density_increase,
                       {},
                       {},
                       {}};
    if (after) density.after = 100.0 * after->mean_density_increase;
    rows.push_back(density);
    if (before.mean_density_increase_neck) {
        ChannelRow neck{"mean_density_increase_neck",
                        "density increase at the neck",
                        "%",
                        100.0 * *before.mean_density_increase_neck,
                        {},
                        {},
                        {}};
        if (after && after->mean_density_increase_neck)
            neck.after = 100.0 * *after->mean_density_increase_neck;
        rows.push_back(neck);
    }
    add_density_rows(rows, diagnosis);
    add_force_rows(rows, diagnosis);
    return rows;
}

Json or_null(const std::optional<double>& value)
{
    return value ? Json(*value) : Json();
}

std::string text_of(const std::optional<double>& value)
{
    return value ? fmt::format("{:.4g}", *value) : "-";
}

}  // namespace

Json channels_as_json(const Diagnosis& diagnosis)
{
    Json json = Json::array();
    for (const ChannelRow& row : channel_rows(diagnosis)) {
        json.push_back({{"name", row.name},
                        {"title", row.title},
                        {"unit", row.unit},
                        {"before", or_null(row.before)},
                        {"after", or_null(row.after)},
                        {"measured", or_null(row.measured)},
                        {"sd", or_null(row.sd)}});
    }
    return json;
}

Json density_map_as_json(const Diagnosis& diagnosis)
{
    const DensityField& field = diagnosis.observations.density;
    if (field.places.empty()) return {};
    const DensityValues values = density_values(diagnosis);
    const DensityUnit unit = density_unit(field.quantity);
    Json json = {{"quantity", name_of(field.quantity)},
                 {"unit", unit.name},
                 {"beyond_ends", field.num_beyond_ends}};
    for (Eigen::Index i = 0; i < values.measured.size(); ++i) {
        const DensityPlace& place = field.places[static_cast<std::size_t>(i)];
        Json entry = {
            {"x_mm", 1e3 * place.point.x()},  {"y_mm", 1e3 * place.point.y()},
            {"z_mm", 1e3 * place.point.z()},  {"measured", values.measured[i] / unit.size},
            {"sd", values.sd[i] / unit.size}, {"before", values.before[i] / unit.size}};
        if (values.after.size() > 0) entry["after"] = values.after[i] / unit.size;
        json["places"].push_back(entry);
    }
    return json;
}

std::string channels_text(const Diagnosis& diagnosis)
{
    std::string text =
        fmt::format("  {:<44}{:<12}{:<12}{}\n", "simulated", "before", "after", "measured");
    for (const ChannelRow& row : channel_rows(diagnosis)) {
        const std::string measured =
            row.measured ? fmt::format("{:.4g} +- {:.2g}", *row.measured, *row.sd) : "-";
        text += fmt::format("  {:<44}{:<12}{:<12}{}\n", fmt::format("{} [{}]", row.title, row.unit),
                            text_of(row.before), text_of(row.after), measured);
    }
    return text;
}

}  // namespace braidzone
