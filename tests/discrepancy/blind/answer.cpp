#include "discrepancy/blind/answer.hpp"

#include "core/error.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <fstream>

namespace braidzone::blind {
namespace {

using Json = nlohmann::ordered_json;

double rms(const Eigen::VectorXd& gap)
{
    return std::sqrt(gap.squaredNorm() / static_cast<double>(gap.size()));
}

FittedEffect fitted(const EffectFit& fit, const Eigen::VectorXd& held_out)
{
    const braidzone::FittedEffect& effect = fit.effects.front();
    FittedEffect result{.log_evidence = fit.log_evidence, .rms_after = rms(held_out)};
    for (std::size_t i = 0; i < effect.values.size(); ++i) {
        result.values[effect.parameters[i].name] = effect.values[i];
        result.sd[effect.parameters[i].name] = effect.sd[i];
    }
    return result;
}

}  // namespace

Answer answer_of(const Diagnosis& diagnosis)
{
    const Explanation& explanation = diagnosis.explanation;
    Answer answer{.finding = name_of(explanation.verdict.finding)};
    for (const braidzone::Answer& one : explanation.verdict.answers)
        answer.sets.push_back(one.effects);
    answer.leaves_doubt = diagnosis.leaves_doubt();
    answer.is_confirmed = diagnosis.held_out.confirms();
    answer.log_evidence_unknown = explanation.log_evidence_unknown;
    answer.log_evidence_scalars = explanation.log_evidence_scalars;
    answer.named = explanation.named;
    for (std::size_t i = 0; i < explanation.num_singles; ++i) {
        const EffectFit& fit = explanation.fits[i];
        if (fit.failure.empty())
            answer.fits[name_of(fit)] = fitted(fit, diagnosis.held_out.of_fits[i]);
    }
    answer.rms_before = diagnosis.gap_held_out.before.rms;
    answer.rms_after = diagnosis.gap_held_out.after.rms;
    answer.rms_floor = diagnosis.gap_held_out.floor.rms;
    answer.background = diagnosis.background;
    answer.num_runs = explanation.num_runs;
    return answer;
}

Answer answer_to(const CaseData& data, const std::vector<Effect>& catalogue,
                 const DiagnoseOptions& options)
{
    try {
        return answer_of(diagnose(data.model, data.lumen, data.points, data.scalars, catalogue,
                                  options, data.density));
    } catch (const Error& error) {
        return {.finding = "error", .error = error.what()};
    }
}

std::string answer_text(const Answer& answer)
{
    Json json = {{"finding", answer.finding},
                 {"sets", answer.sets},
                 {"leaves_doubt", answer.leaves_doubt},
                 {"is_confirmed", answer.is_confirmed},
                 {"log_evidence_unknown", answer.log_evidence_unknown},
                 {"log_evidence_scalars", answer.log_evidence_scalars},
                 {"rms_before", answer.rms_before},
                 {"rms_after", answer.rms_after},
                 {"rms_floor", answer.rms_floor},
                 {"background", answer.background},
                 {"num_runs", answer.num_runs},
                 {"error", answer.error},
                 {"named", Json::array()},
                 {"fits", Json::object()}};
    for (const NamedEvidence& one : answer.named) {
        json["named"].push_back({{"effects", one.effects},
                                 {"log_evidence", one.log_evidence},
                                 {"log_evidence_unknown", one.log_evidence_unknown},
                                 {"log_evidence_scalars", one.log_evidence_scalars}});
    }
    for (const auto& [name, fit] : answer.fits) {
        json["fits"][name] = {{"log_evidence", fit.log_evidence},
                              {"values", fit.values},
                              {"sd", fit.sd},
                              {"rms_after", fit.rms_after}};
    }
    return json.dump() + "\n";
}

Answer read_answer(const std::filesystem::path& file)
{
    std::ifstream in(file);
    if (!in) throw IoError(fmt::format("{} cannot be read", file.string()));
    const Json json = Json::parse(in);
    Answer answer{.finding = json.at("finding"),
                  .sets = json.at("sets"),
                  .leaves_doubt = json.at("leaves_doubt"),
                  .is_confirmed = json.at("is_confirmed"),
                  .log_evidence_unknown = json.at("log_evidence_unknown"),
                  .log_evidence_scalars = json.at("log_evidence_scalars"),
                  .fits = {},
                  .rms_before = json.at("rms_before"),
                  .rms_after = json.at("rms_after"),
                  .rms_floor = json.at("rms_floor"),
                  .background = json.at("background"),
                  .num_runs = json.at("num_runs"),
                  .error = json.at("error")};
    for (const Json& one : json.at("named")) {
        answer.named.push_back({.effects = one.at("effects"),
                                .log_evidence = one.at("log_evidence"),
                                .log_evidence_unknown = one.at("log_evidence_unknown"),
                                .log_evidence_scalars = one.at("log_evidence_scalars")});
    }
    // A number that is not finite is written as null.
    const auto numbers = [](const Json& object) {
        std::map<std::string, double> values;
        for (const auto& [name, value] : object.items()) {
            if (value.is_number()) values[name] = value;
        }
        return values;
    };
    for (const auto& [name, fit] : json.at("fits").items()) {
        answer.fits[name] = {fit.at("log_evidence"), numbers(fit.at("values")),
                             numbers(fit.at("sd")), fit.at("rms_after")};
    }
    return answer;
}

}  // namespace braidzone::blind
