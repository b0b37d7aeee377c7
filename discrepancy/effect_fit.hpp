#pragma once

#include "discrepancy/effect.hpp"
#include "discrepancy/error_model.hpp"

#include <Eigen/Core>

#include <string>
#include <vector>

namespace braidzone {

/// What a hypothesis is compared on: the case, the data, and their errors.
struct FitProblem {
    const Lumen& lumen;
    const EffectSetting& setting;
    const Simulation& base;
    const Observations& observations;
    const Whitening& whitening;
    const Eigen::VectorXd& base_residuals;  ///< of the case as it is [m]
};

/// Where a fit ended.
struct FitMode {
    std::vector<double> values;  ///< [SI]
    double log_evidence = 0.0;
};

/// An effect with the parameters that fit best.
struct EffectFit {
    std::string effect;
    std::vector<EffectParameter> parameters;
    std::vector<double> values;  ///< [SI]
    std::vector<double> sd;      ///< from the curvature at the best fit, not checked for coverage
    Eigen::VectorXd residuals;   ///< [m]
    double chi_square = 0.0;     ///< of the whitened residuals
    double log_evidence = 0.0;   ///< natural logarithm of the Bayes factor against no effect
    std::vector<FitMode> modes;  ///< where the fits from all starts ended
    int num_runs = 0;            ///< deployments that it took
    /// Why the effect could not be simulated; empty if it could.
    std::string failure;
};

struct FitOptions {
    int num_starts = 3;  ///< fitted out of the starts, those that leave the smallest misfit
    int max_iterations = 8;
};

/// Residuals of a model [m].
/// @throws what `simulate` throws
Eigen::VectorXd residuals_of(const Model& model, bool changes_deployment,
                             const FitProblem& problem);

/// Fits the parameters of an effect to the data with the full simulator: Levenberg-Marquardt on
/// the whitened residuals, with a row for each normal prior and derivatives by finite differences
/// of `EffectParameter::step`, large against the deployment's roughness.
///
/// An effect with several starts is simulated at each; those that leave the smallest misfit, at
/// places of their own, are fitted, none if no start takes 2 or more off the sum of squares. A
/// start that leaves a small misfit is a fingerprint at a finite amplitude: contact makes that of
/// an infinitesimal one misleading.
///
/// Its log evidence is Laplace's, with parameters scaled by their priors, whitened residuals z, S
/// their derivatives, and x those with a normal prior:
///
///     ln B = 1/2 (|z_0|^2 - |z|^2 - |x|^2) - 1/2 ln det(I + S' S) + 1/2 ln(2 pi / 12) per uniform
///
/// The last term is that of a parameter that may be anywhere: about zero if the data say nothing.
EffectFit fit_effect(const Effect& effect, const FitProblem& problem,
                     const FitOptions& options = {});

}  // namespace braidzone
