#pragma once

#include "cli/case_file.hpp"
#include "discrepancy/effect_fit.hpp"
#include "discrepancy/model.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace braidzone {

/// What a case says about the deployment and its measurement, as a model of a diagnosis.
Model model_of(const Case& job, const Centerline& centerline);

/// The case with a model in the place of its own deployment and measurement.
Case case_of(const Case& job, const Model& model);

/// Keys whose values differ between two cases, "deployment.push_pull.0.from: absent -> ...".
std::vector<std::string> changed_keys(const Case& before, const Case& after);

/// The case file with an effect: every value explicit, after a comment that says where the changed
/// ones come from.
/// @param data  the measured surface that they were found in
std::string effect_case_text(const Case& job, const Model& model, const EffectFit& fit,
                             const std::filesystem::path& data);

}  // namespace braidzone
