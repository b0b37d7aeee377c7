#pragma once

#include "discrepancy/detection_limit.hpp"
#include "discrepancy/effect_search.hpp"
#include "discrepancy/verdict.hpp"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace braidzone {

struct ExplainOptions {
    SearchOptions search;
    VerdictOptions verdict;
    /// Weighs each candidate alone, and each set's at once, as they are, and with an error of their
    /// shape (`evidence_with_shape_error`), both alike probable. A set is otherwise weighed as
    /// `find_sets` found it.
    bool doubts_shapes = false;
    /// Told of what is going on, from any thread, one call at a time.
    std::function<void(const std::string&)> on_progress = {};
};

/// What is missing in a simulation, by a measurement: the answer and everything that led to it.
struct Explanation {
    Eigen::VectorXd base_residuals;  ///< of the case as it is
    double chi_square = 0.0;         ///< of it, whitened
    /// Of the candidates, each alone, in their order; then of sets of several.
    std::vector<EffectFit> fits = {};
    std::size_t num_singles = 0;
    /// Of each candidate alone: the smallest amplitude that would have been seen.
    std::vector<std::optional<DetectionLimit>> limits = {};
    std::vector<NamedEvidence> named = {};  ///< of the fits that did not fail
    double log_evidence_unknown = 0.0;      ///< `UnknownEffect`
    double log_evidence_scalars = 0.0;      ///< `unknown_scalars_evidence`
    Verdict verdict = {};
    std::optional<std::size_t> best = {};  ///< fit of the verdict's first answer
    /// The unknown effect's mean over the field, besides the best answer.
    Eigen::VectorXd unexplained = {};
    int num_runs = 0;  ///< simulations

    /// Residuals with the best answer in the model; of the case as it is if there is none.
    const Eigen::VectorXd& residuals_after() const;
};

/// Tries all candidates on a measurement, alone and several together, against no effect and an
/// unknown one.
/// @throws what `problem.residuals` throws for the case as it is; a candidate that cannot be
///         simulated is reported in its fit
Explanation explain(const DiagnosisProblem& problem, const ExplainOptions& options = {});

}  // namespace braidzone
