#include "discrepancy/noise_floor.hpp"

#include "core/error.hpp"
#include "core/nearest_name.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <fstream>
#include <numbers>
#include <vector>

namespace braidzone {
namespace {

constexpr double millimetre = 1e-3;
constexpr double degree = std::numbers::pi / 180.0;

struct Entry {
    std::string key;
    double NoiseFloor::*value;
    double unit;
    bool is_optional = false;
};

const std::vector<Entry>& entries()
{
    static const std::vector<Entry> all = {
        {"background_sd_mm", &NoiseFloor::background_sd, millimetre},
        {"background_length_mm", &NoiseFloor::background_length, millimetre},
        {"offset_sd_mm", &NoiseFloor::offset_sd, millimetre},
        {"hub_sd_mm", &NoiseFloor::hub_sd, millimetre, true},
        {"registration_shift_sd_mm", &NoiseFloor::shift_sd, millimetre},
        {"registration_angle_sd_deg", &NoiseFloor::angle_sd, degree},
        {"white_scale", &NoiseFloor::white_scale, 1.0},
        {"landing_sd_mm", &NoiseFloor::landing_sd, millimetre},
        {"length_sd_mm", &NoiseFloor::length_sd, millimetre},
        {"density_relative_sd", &NoiseFloor::density_sd, 1.0, true},
        {"density_scale_relative_sd", &NoiseFloor::density_scale_sd, 1.0, true},
        {"contact_force_relative_sd", &NoiseFloor::force_sd, 1.0, true},
    };
    return all;
}

}  // namespace

NoiseFloor read_noise_floor(const std::filesystem::path& path)
{
    std::ifstream file(path);
    if (!file) throw IoError(fmt::format("noise file {} cannot be read", path.string()));
    const auto json = nlohmann::json::parse(file, nullptr, false);
    if (!json.is_object())
        throw InputError(fmt::format("noise file {} is not a JSON object", path.string()));
    std::vector<std::string> known = {"source"};
    for (const Entry& entry : entries())
        known.push_back(entry.key);
    for (const auto& [key, value] : json.items()) {
        if (std::find(known.begin(), known.end(), key) != known.end()) continue;
        throw InputError(fmt::format("noise file {}: \"{}\" is not known{}", path.string(), key,
                                     did_you_mean(key, known)));
    }
    NoiseFloor floor;
    floor.source = json.contains("source") && json["source"].is_string()
                       ? json["source"].get<std::string>()
                       : path.string();
    for (const Entry& entry : entries()) {
        if (entry.is_optional && !json.contains(entry.key)) continue;
        if (!json.contains(entry.key) || !json[entry.key].is_number()) {
            throw InputError(fmt::format("noise file {}: {} is missing or not a number",
                                         path.string(), entry.key));
        }
        const double value = json[entry.key].get<double>();
        if (!(value > 0.0)) {
            throw InputError(fmt::format("noise file {}: {} = {:.6g} must be positive",
                                         path.string(), entry.key, value));
        }
        floor.*entry.value = value * entry.unit;
    }
    return floor;
}

std::string noise_floor_text(const NoiseFloor& floor)
{
    nlohmann::ordered_json json;
    for (const Entry& entry : entries())
        json[entry.key] = floor.*entry.value / entry.unit;
    json["source"] = floor.source;
    return json.dump(2) + "\n";
}

}  // namespace braidzone
