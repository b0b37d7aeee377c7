#include "discrepancy/blind/answer.hpp"

#include "core/error.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <fstream>
#include <numeric>

namespace braidzone::blind {
namespace {

using Json = nlohmann::ordered_json;

FittedEffect fitted(const EffectFit& fit, const Diagnosis& diagnosis,
                    const Eigen::MatrixXd& smoothing, const std::vector<int>& patches)
{
    FittedEffect result{.log_evidence = fit.log_evidence};
    for (std::size_t i = 0; i < fit.values.size(); ++i) {
        result.values[fit.parameters[i].name] = fit.values[i];
        result.sd[fit.parameters[i].name] = fit.sd[i];
    }
    result.rms_after =
        gap_figures(registered_gap(diagnosis.error, fit.residuals), smoothing, patches).rms;
    return result;
}

}  // namespace

Answer answer_of(const Diagnosis& diagnosis, const DiagnoseOptions& options)
{
    Answer answer{.finding = name_of(diagnosis.verdict.finding)};
    for (const std::string& effect : diagnosis.verdict.effects)
        answer.sets.push_back({effect});
    answer.has_unexplained_rest = diagnosis.verdict.has_unexplained_rest;
    std::vector<int> patches(diagnosis.observations.field.patches.size());
    std::iota(patches.begin(), patches.end(), 0);
    const Eigen::MatrixXd smoothing =
        smoothing_matrix(diagnosis.observations.field, options.clusters.kernel);
    for (const EffectFit& fit : diagnosis.fits) {
        if (fit.failure.empty())
            answer.fits[fit.effect] = fitted(fit, diagnosis, smoothing, patches);
    }
    answer.rms_before = diagnosis.everywhere.before.rms;
    answer.rms_after = diagnosis.everywhere.after.rms;
    answer.rms_floor = diagnosis.everywhere.floor.rms;
    answer.background = diagnosis.background;
    answer.num_runs = diagnosis.num_runs;
    return answer;
}

Answer answer_to(const CaseData& data, const std::vector<Effect>& catalogue,
                 const DiagnoseOptions& options)
{
    try {
        return answer_of(
            diagnose(data.model, data.lumen, data.points, data.scalars, catalogue, options),
            options);
    } catch (const Error& error) {
        return {.finding = "error", .error = error.what()};
    }
}

std::string answer_text(const Answer& answer)
{
    Json json = {{"finding", answer.finding},
                 {"sets", answer.sets},
                 {"has_unexplained_rest", answer.has_unexplained_rest},
                 {"rms_before", answer.rms_before},
                 {"rms_after", answer.rms_after},
                 {"rms_floor", answer.rms_floor},
                 {"background", answer.background},
                 {"num_runs", answer.num_runs},
                 {"error", answer.error},
                 {"fits", Json::object()}};
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
                  .has_unexplained_rest = json.at("has_unexplained_rest"),
                  .fits = {},
                  .rms_before = json.at("rms_before"),
                  .rms_after = json.at("rms_after"),
                  .rms_floor = json.at("rms_floor"),
                  .background = json.at("background"),
                  .num_runs = json.at("num_runs"),
                  .error = json.at("error")};
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
