#pragma once

#include "discrepancy/diagnosis.hpp"

#include <nlohmann/json.hpp>

#include <string>
#include <vector>

namespace braidzone {

/// The answer of a diagnosis in a sentence or two.
std::string diagnosis_answer(const Diagnosis& diagnosis);

/// What the user should know about the data: points that were left out, a noise floor that does not
/// fit, effects that could not be simulated.
std::vector<std::string> diagnosis_warnings(const Diagnosis& diagnosis);

/// Everything of a diagnosis with units: the content of diagnosis.json, but for inputs and files.
nlohmann::ordered_json diagnosis_as_json(const Diagnosis& diagnosis, const NoiseFloor& floor);

/// The same in a few lines for the terminal.
std::string diagnosis_summary(const Diagnosis& diagnosis);

}  // namespace braidzone
