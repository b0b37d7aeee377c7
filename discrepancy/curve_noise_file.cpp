#include "discrepancy/curve_noise_file.hpp"

#include "core/error.hpp"
#include "core/nearest_name.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <fstream>
#include <vector>

namespace braidzone {
namespace {

struct CurveConstant {
    std::string key;
    double CurveNoise::*value;
    double unit;
};

std::vector<CurveConstant> constants_in(const CurveNoiseUnits& units)
{
    return {{"point_sd", &CurveNoise::point_sd, 1.0},
            {"absolute_sd_" + units.ordinate_unit, &CurveNoise::absolute_sd, units.ordinate_si},
            {"scale_sd", &CurveNoise::scale_sd, 1.0},
            {"zero_sd_" + units.ordinate_unit, &CurveNoise::zero_sd, units.ordinate_si},
            {"background_sd", &CurveNoise::background_sd, 1.0},
            {"background_length", &CurveNoise::background_length, 1.0},
            {"abscissa_sd_" + units.abscissa_unit, &CurveNoise::abscissa_sd, units.abscissa_si}};
}

nlohmann::json json_of_curve(const std::filesystem::path& path, const std::string& curve)
{
    std::ifstream file(path);
    if (!file) throw IoError(fmt::format("noise file {} cannot be read", path.string()));
    auto json = nlohmann::json::parse(file, nullptr, false);
    if (!json.is_object())
        throw InputError(fmt::format("noise file {} is not a JSON object", path.string()));
    if (json.value("curve", nlohmann::json()) != curve) {
        throw InputError(fmt::format("noise file {}: \"curve\" is {}; needed is \"{}\"",
                                     path.string(), json.value("curve", nlohmann::json()).dump(),
                                     curve));
    }
    return json;
}

}  // namespace

std::string curve_noise_text(const CurveNoise& noise, const CurveNoiseUnits& units)
{
    nlohmann::ordered_json json = {{"curve", units.curve}};
    for (const CurveConstant& constant : constants_in(units))
        json[constant.key] = noise.*constant.value / constant.unit;
    json["source"] = noise.source;
    return json.dump(2) + "\n";
}

CurveNoise read_curve_noise(const std::filesystem::path& path, const CurveNoiseUnits& units)
{
    const nlohmann::json json = json_of_curve(path, units.curve);
    CurveNoise noise;
    std::vector<std::string> known = {"curve", "source"};
    for (const CurveConstant& constant : constants_in(units)) {
        known.push_back(constant.key);
        const auto value = json.find(constant.key);
        if (value == json.end()) continue;  // told below, once misspelt keys are
        if (!value->is_number() || !(value->get<double>() >= 0.0)) {
            throw InputError(fmt::format("noise file {}: {} = {}; allowed are numbers from 0",
                                         path.string(), constant.key, value->dump()));
        }
        noise.*constant.value = value->get<double>() * constant.unit;
    }
    for (const auto& [key, value] : json.items()) {
        if (std::find(known.begin(), known.end(), key) != known.end()) continue;
        throw InputError(fmt::format("noise file {}: \"{}\" is not known{}", path.string(), key,
                                     did_you_mean(key, known)));
    }
    for (const std::string& key : known) {
        if (key == "source" || json.contains(key)) continue;
        throw InputError(fmt::format("noise file {}: {} is missing", path.string(), key));
    }
    noise.source = json.value("source", path.string());
    return noise;
}

}  // namespace braidzone
