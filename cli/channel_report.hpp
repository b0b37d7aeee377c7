#pragma once

#include "discrepancy/diagnosis.hpp"

#include <nlohmann/json.hpp>

#include <string>

namespace braidzone {

/// Length, density and force before and after the effect is in the model, with what was measured of
/// them: an array of {name, title, unit, before, after, measured, sd}, null for what there is not.
/// What was not measured is a prediction.
nlohmann::ordered_json channels_as_json(const Diagnosis& diagnosis);

/// Each place of the measured density map; null if there is none.
nlohmann::ordered_json density_map_as_json(const Diagnosis& diagnosis);

/// `channels_as_json` as a table for the terminal.
std::string channels_text(const Diagnosis& diagnosis);

}  // namespace braidzone
