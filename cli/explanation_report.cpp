#include "cli/explanation_report.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

namespace braidzone {
namespace {

using Json = nlohmann::ordered_json;

constexpr double margin = 3.0;  // a Bayes factor of 20

/// Other places at which the same effect fits about as well, if its fits ended in several.
std::string other_modes(const EffectFit& fit)
{
    if (fit.effects.size() > 1) return "";
    const FittedEffect& effect = fit.effects.front();
    std::string text;
    for (const FitMode& mode : fit.modes) {
        if (fit.log_evidence - mode.log_evidence > margin) continue;
        for (std::size_t i = 0; i < mode.values.size(); ++i) {
            const EffectParameter& parameter = effect.parameters[i];
            if (!parameter.is_uniform ||
                std::abs(mode.values[i] - effect.values[i]) < 3.0 * effect.sd[i])
                continue;
            text += fmt::format(" It fits about as well at {} = {:.4g} {}.", parameter.name,
                                mode.values[i] / reported_unit(parameter), parameter.unit);
        }
    }
    return text;
}

/// The known effect that comes nearest to an unknown one.
std::string nearest_known(const Explanation& explanation)
{
    const EffectFit* nearest = nullptr;
    for (const EffectFit& fit : explanation.fits) {
        if (fit.failure.empty() && (nearest == nullptr || fit.chi_square < nearest->chi_square))
            nearest = &fit;
    }
    if (nearest == nullptr) return "";
    return fmt::format(" What comes nearest, {}, takes {:.0f} % off the misfit.", name_of(*nearest),
                       100.0 * (1.0 - nearest->chi_square / explanation.chi_square));
}

std::string answer_name(const Answer& answer)
{
    return fmt::format("{}", fmt::join(answer.effects, " and "));
}

std::string named_text(const EffectFit& fit)
{
    std::vector<std::string> texts;
    for (const FittedEffect& effect : fit.effects) {
        texts.push_back(fmt::format("{}: {} ({})", effect.name, effect.title,
                                    fmt::join(parameter_texts(effect), ", ")));
    }
    return fmt::format("{}.", fmt::join(texts, "; and ")) + other_modes(fit);
}

std::string ambiguous_text(const Explanation& explanation, const std::string& further)
{
    std::vector<std::string> names;
    for (const Answer& answer : explanation.verdict.answers)
        names.push_back(answer_name(answer));
    if (explanation.verdict.unknown_lead) names.emplace_back("something unknown");
    const std::string what_would =
        further.empty()
            ? fmt::format("What would: {}.",
                          explanation.fits[*explanation.best].effects.front().separated_by)
            : further;
    return fmt::format("One of these, which the data do not tell apart: {}. {}",
                       fmt::join(names, ", "), what_would);
}

Json fit_as_json(const EffectFit& fit, const Explanation& explanation)
{
    Json json = {{"effect", name_of(fit)}, {"num_runs", fit.num_runs}};
    if (!fit.failure.empty()) {
        json["failure"] = fit.failure;
        return json;
    }
    const auto evidence =
        std::find_if(explanation.named.begin(), explanation.named.end(),
                     [&](const NamedEvidence& one) { return &explanation.fits[one.fit] == &fit; });
    json["log_bayes_factor"] = fit.log_evidence;
    json["log_bayes_factor_unknown_besides"] = evidence->log_evidence_unknown;
    json["log_bayes_factor_scalars_besides"] = evidence->log_evidence_scalars;
    json["chi_square"] = fit.chi_square;
    for (const FittedEffect& effect : fit.effects) {
        Json parameters;
        for (std::size_t i = 0; i < effect.values.size(); ++i) {
            const EffectParameter& parameter = effect.parameters[i];
            const double unit = reported_unit(parameter);
            parameters[parameter.name] = {{"value", effect.values[i] / unit},
                                          {"sd", effect.sd[i] / unit},
                                          {"unit", parameter.unit}};
        }
        json["parameters"][effect.name] = parameters;
    }
    if (fit.effects.size() > 1) return json;
    const FittedEffect& effect = fit.effects.front();
    for (const FitMode& mode : fit.modes) {
        Json end = {{"log_bayes_factor", mode.log_evidence}};
        for (std::size_t i = 0; i < mode.values.size(); ++i)
            end[effect.parameters[i].name] = mode.values[i] / reported_unit(effect.parameters[i]);
        json["ends_of_fits"].push_back(end);
    }
    return json;
}

/// True if an effect alone would have been seen at an amplitude within its bounds.
bool would_be_seen(const Explanation& explanation, std::size_t single)
{
    if (!explanation.limits[single]) return false;
    const EffectParameter& first = explanation.fits[single].effects.front().parameters.front();
    return explanation.limits[single]->amplitude <=
           std::max(first.upper - first.prior_mean, first.prior_mean - first.lower);
}

/// "local_push -0.21 (spacing_change)": what would have been seen in 8 of 10 such measurements.
std::vector<std::string> limit_texts(const Explanation& explanation)
{
    std::vector<std::string> texts;
    for (std::size_t i = 0; i < explanation.num_singles; ++i) {
        if (!would_be_seen(explanation, i)) continue;
        const FittedEffect& effect = explanation.fits[i].effects.front();
        const EffectParameter& first = effect.parameters.front();
        const double amplitude = explanation.limits[i]->amplitude;
        texts.push_back(fmt::format("{} of {:.2g}{} ({})", effect.name,
                                    amplitude / reported_unit(first),
                                    first.unit == "1" ? "" : " " + first.unit, first.name));
    }
    return texts;
}

/// Effects that could be there without leaving a trace in these data.
std::vector<std::string> unseen_effects(const Explanation& explanation)
{
    std::vector<std::string> names;
    for (std::size_t i = 0; i < explanation.num_singles; ++i) {
        if (!would_be_seen(explanation, i)) names.push_back(name_of(explanation.fits[i]));
    }
    return names;
}

/// What is said of them.
std::string unseen_text(const Explanation& explanation)
{
    const std::vector<std::string> names = unseen_effects(explanation);
    if (names.empty()) return "";
    return fmt::format(" These data cannot tell whether there is: {}.", fmt::join(names, ", "));
}

Json answers_as_json(const Verdict& verdict)
{
    Json answers = Json::array();
    for (const Answer& answer : verdict.answers)
        answers.push_back(answer.effects);
    return answers;
}

}  // namespace

std::vector<std::string> parameter_texts(const FittedEffect& effect)
{
    std::vector<std::string> texts;
    for (std::size_t i = 0; i < effect.values.size(); ++i) {
        const EffectParameter& parameter = effect.parameters[i];
        const double unit = reported_unit(parameter);
        texts.push_back(fmt::format("{} = {:.4g} +- {:.2g}{}", parameter.name,
                                    effect.values[i] / unit, effect.sd[i] / unit,
                                    parameter.unit == "1" ? "" : " " + parameter.unit));
    }
    return texts;
}

std::string explanation_answer(const Explanation& explanation, const HeldOutGap& held_out,
                               const std::string& floor, const std::string& further)
{
    const Verdict& verdict = explanation.verdict;
    if (verdict.finding == Finding::nothing_missing) {
        return fmt::format(
                   "Nothing is missing: measurement and simulation agree within the noise floor of "
                   "{}. "
                   "In 8 of 10 such measurements would have been seen: {}.",
                   floor, fmt::join(limit_texts(explanation), ", ")) +
               unseen_text(explanation);
    }
    if (verdict.finding == Finding::unknown) {
        return "Something is missing, but none of the known effects explains it." +
               nearest_known(explanation);
    }
    std::string text = held_out.confirms() ? "" : "Suspected: ";
    text += verdict.finding == Finding::named ? named_text(explanation.fits[*explanation.best])
                                              : ambiguous_text(explanation, further);
    if (verdict.has_unexplained_rest) text += " Something remains that this does not explain.";
    if (!held_out.confirms()) {
        text += fmt::format(
            " Parts of the data that the choice was not made on do not confirm it: {} of {} "
            "choose the same.",
            held_out.num_same, held_out.choices.size());
    }
    return text;
}

Json explanation_as_json(const Explanation& explanation, const HeldOutGap& held_out,
                         const std::string& floor, const std::string& further)
{
    const Verdict& verdict = explanation.verdict;
    Json json = {{"answer",
                  {{"finding", name_of(verdict.finding)},
                   {"effects", answers_as_json(verdict)},
                   {"is_confirmed", explanation.best ? Json(held_out.confirms()) : Json()},
                   {"has_unexplained_rest", verdict.has_unexplained_rest},
                   {"cannot_be_told", unseen_effects(explanation)},
                   {"may_be_unknown", verdict.unknown_lead.has_value()},
                   {"text", explanation_answer(explanation, held_out, floor, further)}}}};
    json["log_bayes_factor_unknown"] = explanation.log_evidence_unknown;
    json["log_bayes_factor_scalars"] = explanation.log_evidence_scalars;
    json["chi_square"] = explanation.chi_square;
    json["num_simulations"] = explanation.num_runs;
    json["effects"] = Json::array();
    for (const EffectFit& fit : explanation.fits)
        json["effects"].push_back(fit_as_json(fit, explanation));
    for (std::size_t i = 0; i < explanation.num_singles; ++i) {
        const EffectParameter& first = explanation.fits[i].effects.front().parameters.front();
        json["effects"][i]["detection_limit"] =
            explanation.limits[i]
                ? Json{{"parameter", first.name},
                       {"value", explanation.limits[i]->amplitude / reported_unit(first)},
                       {"unit", first.unit}}
                : Json();
    }
    json["folds"] = {{"choices", held_out.choices},
                     {"num_same_as_all_data", held_out.num_same},
                     {"log_score_gain", held_out.log_score_gain}};
    return json;
}

std::string evidence_text(const Explanation& explanation)
{
    std::string text = "ln Bayes factors:";
    for (const NamedEvidence& named : explanation.named) {
        text += fmt::format(" {} {:.1f},", fmt::join(named.effects, " + "), named.log_evidence);
    }
    return text + fmt::format(" unknown {:.1f}, single numbers unknown {:.1f}",
                              explanation.log_evidence_unknown, explanation.log_evidence_scalars);
}

std::vector<std::string> failure_warnings(const Explanation& explanation)
{
    std::vector<std::string> warnings;
    for (std::size_t i = 0; i < explanation.num_singles; ++i) {
        const EffectFit& fit = explanation.fits[i];
        if (!fit.failure.empty()) {
            warnings.push_back(
                fmt::format("{} could not be simulated: {}", name_of(fit), fit.failure));
        }
    }
    return warnings;
}

}  // namespace braidzone
