#pragma once

#include "discrepancy/explanation.hpp"

#include <string>
#include <vector>

namespace braidzone {

/// The gap on data that took no part in choosing and fitting the effects.
struct HeldOutGap {
    /// Residuals of the field, each predicted from the other folds: with no effect, with what was
    /// chosen there.
    Eigen::VectorXd before = {}, after = {};
    /// With each of the explanation's fits in all folds; empty for one that failed. That of the
    /// effect that is known to be missing, where the truth is known, is what can be reached.
    std::vector<Eigen::VectorXd> of_fits = {};
    std::vector<std::string> choices = {};  ///< of each fold, "none" or `name_of` its fit
    int num_same = 0;                       ///< folds that chose what all the data choose
    /// Log predictive density of the held-out residuals with the choices, less that without an
    /// effect.
    double log_score_gain = 0.0;

    /// The choice holds on data it was not made on: the predictions gain, and at least three
    /// quarters of the folds make the same choice.
    bool confirms() const;
};

/// Cross-validation over blocks of the field, choice and fit both within the fold.
///
/// In each fold the fits of all data are refitted to the residuals that lie further than `buffer`
/// from the block, linear in the parameters (`linear_refit`), and the one with the greatest log
/// evidence is chosen if that is above the bar of a named effect (`for_choice_among`). Single
/// numbers are learned from in all folds. What nuisances (`DiagnosisProblem::nuisance`) do to the
/// block is predicted from the other residuals,
///
///     gap = r_block - N_(block, rest) C_(rest, rest)^-1 r_rest
///
/// @param folds   indices of the field's residuals, each in one fold
/// @param buffer  in the unit of `distances`
HeldOutGap held_out_gap(const DiagnosisProblem& problem, const Explanation& explanation,
                        const std::vector<std::vector<int>>& folds, double buffer,
                        const ExplainOptions& options = {});

/// Rows that make the held-out gap of the field out of all residuals, as above.
Eigen::MatrixXd held_out_rows(const DiagnosisProblem& problem,
                              const std::vector<std::vector<int>>& folds, double buffer);

}  // namespace braidzone
