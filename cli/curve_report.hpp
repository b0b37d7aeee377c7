#pragma once

#include "cli/curve_labels.hpp"
#include "discrepancy/curve_diagnosis.hpp"

#include <nlohmann/json.hpp>

#include <string>

namespace braidzone {

/// Everything of a curve's diagnosis with units: the content of diagnosis.json, but for inputs and
/// files.
nlohmann::ordered_json curve_as_json(const CurveDiagnosis& diagnosis, const CurveLabels& labels);

/// The same in a few lines for the terminal.
std::string curve_summary(const CurveDiagnosis& diagnosis);

}  // namespace braidzone
