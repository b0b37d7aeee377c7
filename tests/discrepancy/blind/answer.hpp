#pragma once

#include "discrepancy/blind/case_folder.hpp"
#include "discrepancy/diagnosis.hpp"

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace braidzone::blind {

/// What a diagnosis said of one effect.
struct FittedEffect {
    double log_evidence = 0.0;
    std::map<std::string, double> values = {}, sd = {};  ///< of its parameters [SI]
    double rms_after = 0.0;                              ///< held-out gap with it in all folds [m]
};

/// What a diagnosis said of a case.
struct Answer {
    std::string finding;  ///< as `name_of(Finding)`, or "error"
    /// Alternatives, best first; each a set of effects.
    std::vector<std::vector<std::string>> sets = {};
    bool leaves_doubt = false;
    bool is_confirmed = false;  ///< by blocks that it was not chosen on
    double log_evidence_unknown = 0.0, log_evidence_scalars = 0.0;
    std::vector<NamedEvidence> named = {};  ///< what the verdict was made from
    std::map<std::string, FittedEffect> fits = {};
    double rms_before = 0.0, rms_after = 0.0, rms_floor = 0.0;  ///< held out [m]
    double background = 1.0;
    int num_runs = 0;
    std::string error = {};  ///< message, if the diagnosis failed
};

/// Takes out of a diagnosis what is scored. The one place that knows how a verdict is made up.
Answer answer_of(const Diagnosis& diagnosis);

/// Diagnoses a case; an error becomes an answer.
Answer answer_to(const CaseData& data, const std::vector<Effect>& catalogue,
                 const DiagnoseOptions& options);

std::string answer_text(const Answer& answer);
Answer read_answer(const std::filesystem::path& file);

}  // namespace braidzone::blind
