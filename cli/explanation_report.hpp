#pragma once

#include "discrepancy/explanation.hpp"
#include "discrepancy/held_out.hpp"

#include <nlohmann/json.hpp>

#include <string>
#include <vector>

namespace braidzone {

/// "spacing_change = -0.55 +- 0.03" for each parameter, in its unit.
std::vector<std::string> parameter_texts(const FittedEffect& effect);

/// The answer of a diagnosis in a sentence or two.
/// @param floor    "0.037 mm (RMS of the patches)": within what they agree if nothing is missing
/// @param further  a sentence on what would tell the answers apart; empty: what is known of the
///                 best one's effect in general
std::string explanation_answer(const Explanation& explanation, const HeldOutGap& held_out,
                               const std::string& floor, const std::string& further = "");

/// The answer, the evidence for and against every candidate and set, and their parameters.
nlohmann::ordered_json explanation_as_json(const Explanation& explanation,
                                           const HeldOutGap& held_out, const std::string& floor,
                                           const std::string& further = "");

/// The log Bayes factors in one line.
std::string evidence_text(const Explanation& explanation);

/// Candidates that could not be simulated, and why.
std::vector<std::string> failure_warnings(const Explanation& explanation);

}  // namespace braidzone
