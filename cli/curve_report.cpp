#include "cli/curve_report.hpp"

#include "cli/explanation_report.hpp"

#include <fmt/format.h>

#include <vector>

namespace braidzone {
namespace {

using Json = nlohmann::ordered_json;

/// Above this the noise floor does not fit the data.
constexpr double largest_excess = 3.0;

std::string floor_text(const CurveDiagnosis& diagnosis)
{
    return fmt::format("{:.2g} % (RMS of the points)", 100.0 * diagnosis.gap.floor);
}

/// Which measurement would tell the effects of the answers from others, one line each.
std::vector<std::string> separating_measurements(const Explanation& explanation)
{
    std::vector<std::string> lines;
    if (explanation.verdict.answers.size() < 2) return lines;
    for (const Answer& answer : explanation.verdict.answers) {
        for (const FittedEffect& effect : explanation.fits[answer.fit].effects)
            lines.push_back(fmt::format("{}: {}", effect.name, effect.separated_by));
    }
    return lines;
}

std::vector<std::string> warnings_of(const CurveDiagnosis& diagnosis)
{
    std::vector<std::string> warnings = failure_warnings(diagnosis.explanation);
    if (diagnosis.excess > largest_excess &&
        diagnosis.explanation.verdict.finding != Finding::unknown) {
        warnings.push_back(fmt::format(
            "the points scatter more than the noise floor allows, by {:.1f} standard deviations of "
            "chi square: do not trust the answer",
            diagnosis.excess));
    }
    return warnings;
}

Json noise_as_json(const CurveNoise& noise, const std::string& unit)
{
    return {{"point_sd", {{"value", noise.point_sd}, {"unit", "1"}}},
            {"absolute_sd", {{"value", noise.absolute_sd}, {"unit", unit}}},
            {"scale_sd", {{"value", noise.scale_sd}, {"unit", "1"}}},
            {"zero_sd", {{"value", noise.zero_sd}, {"unit", unit}}},
            {"background_sd", {{"value", noise.background_sd}, {"unit", "1"}}},
            {"background_length", {{"value", noise.background_length}, {"unit", "range"}}},
            {"abscissa_sd", {{"value", noise.abscissa_sd}, {"unit", unit == "N" ? "m" : "m/s"}}},
            {"source", noise.source}};
}

Json points_as_json(const CurveDiagnosis& diagnosis, const CurveLabels& labels)
{
    const bool has_effect = diagnosis.explanation.best.has_value();
    const auto key = [](const std::string& name, const std::string& unit) {
        return unit.empty() ? name : name + "_" + unit;
    };
    Json points = Json::array();
    for (std::size_t i = 0; i < diagnosis.before.size(); ++i) {
        Json point = {
            {key(labels.abscissa, labels.abscissa_unit),
             diagnosis.measured.abscissae[i] / labels.abscissa_si},
            {key("measured", labels.ordinate_unit),
             diagnosis.measured.ordinates[i] / labels.ordinate_si},
            {key("before", labels.ordinate_unit), diagnosis.before[i] / labels.ordinate_si},
            {key("noise_sd", labels.ordinate_unit), diagnosis.standard[i] / labels.ordinate_si},
            {"unexplained_share", diagnosis.explanation.unexplained[static_cast<Eigen::Index>(i)]}};
        if (has_effect)
            point[key("after", labels.ordinate_unit)] = diagnosis.after[i] / labels.ordinate_si;
        points.push_back(point);
    }
    return points;
}

}  // namespace

Json curve_as_json(const CurveDiagnosis& diagnosis, const CurveLabels& labels)
{
    Json json = {{"observable", labels.curve}};
    json.update(
        explanation_as_json(diagnosis.explanation, diagnosis.held_out, floor_text(diagnosis)));
    json["separated_by"] = separating_measurements(diagnosis.explanation);
    json["warnings"] = warnings_of(diagnosis);
    const bool has_effect = diagnosis.explanation.best.has_value();
    json["gaps"] = {{"unit", "over the simulated curve"},
                    {"before", diagnosis.gap.before},
                    {"after", has_effect ? Json(diagnosis.gap.after) : Json()},
                    {"noise_floor", diagnosis.gap.floor}};
    json["noise_floor"] = noise_as_json(diagnosis.noise, labels.ordinate == "force" ? "N" : "Pa");
    json["points"] = points_as_json(diagnosis, labels);
    return json;
}

std::string curve_summary(const CurveDiagnosis& diagnosis)
{
    const Explanation& explanation = diagnosis.explanation;
    std::string text =
        explanation_answer(explanation, diagnosis.held_out, floor_text(diagnosis)) + "\n";
    const std::vector<std::string> separating = separating_measurements(explanation);
    if (!separating.empty()) text += "  what would tell them apart\n";
    for (const std::string& line : separating)
        text += fmt::format("    {}\n", line);
    text += fmt::format("  gap held out, RMS: before {:.2f} %", 100.0 * diagnosis.gap.before);
    if (explanation.best) text += fmt::format(", after {:.2f} %", 100.0 * diagnosis.gap.after);
    text += fmt::format(", noise floor {:.2f} %\n  {}\n", 100.0 * diagnosis.gap.floor,
                        evidence_text(explanation));
    for (const std::string& warning : warnings_of(diagnosis))
        text += fmt::format("  note: {}\n", warning);
    return text;
}

}  // namespace braidzone
