#pragma once

#include <nlohmann/json.hpp>

#include <filesystem>
#include <string>

namespace braidzone {

/// A diagnosis as a page for people: answer, picture, gaps before and after, clusters, the evidence
/// for each effect, notes and inputs. One HTML file that carries its picture within itself and
/// needs nothing else.
/// @param diagnosis  content of diagnosis.json
/// @param picture    PNG
/// @throws IoError if the picture cannot be read
std::string diagnosis_page(const nlohmann::ordered_json& diagnosis,
                           const std::filesystem::path& picture);

/// The same of a curve measured on a bench: answer, picture, gaps, what would tell the effects of a
/// set apart, the evidence, the points.
std::string curve_page(const nlohmann::ordered_json& diagnosis,
                       const std::filesystem::path& picture);

}  // namespace braidzone
