#pragma once

#include "discrepancy/effect_fit.hpp"

#include <vector>

namespace braidzone {

struct SearchOptions {
    int most_effects = 3;    ///< in the model together
    int width = 3;           ///< sets that are carried on from one size to the next
    int most_additions = 3;  ///< tried for each of them
    /// What an addition must gain in log evidence over the set without it, and what the new set
    /// must be ahead of every part of it, besides ln(n - 1) for the choice among the n - 1 other
    /// candidates: a Bayes factor of 20.
    double least_gain = 3.0;
    /// How wrong an effect's shape may be, over its size.
    double implementation_error = 0.2;
    FitOptions fit;                 ///< of a candidate alone
    int most_joint_iterations = 4;  ///< of a fit of several together
};

/// Sets of two or more effects in which each earns its place: a beam search over sets.
///
/// To each of the best sets so far those candidates are added whose fingerprints, among what the
/// fits of single effects have simulated, promise most on the residuals that the set leaves; the
/// effects are then fitted together with the full simulator. The gain of an addition is judged
/// with `with_implementation_error` of what is already in the model, and added to the evidence of
/// the set it was added to. The search ends where nothing is gained.
/// @param singles  fits of all candidates, each alone, in their order
/// @return the sets of two or more that were accepted; `trials` of their fits are empty
std::vector<EffectFit> find_sets(const DiagnosisProblem& problem, const Eigen::VectorXd& base,
                                 const std::vector<EffectFit>& singles,
                                 const SearchOptions& options = {});

}  // namespace braidzone
