#pragma once

#include "discrepancy/diagnosis_problem.hpp"
#include "discrepancy/effect_residuals.hpp"
#include "discrepancy/whitening.hpp"

#include <Eigen/Core>

#include <string>
#include <vector>

namespace braidzone {

/// An effect with the parameters that fit best.
struct FittedEffect {
    std::size_t candidate = 0;              ///< index in `DiagnosisProblem::candidates`
    std::string name, title, separated_by;  ///< of the candidate
    std::vector<EffectParameter> parameters;
    std::vector<double> values;  ///< [SI]
    /// From the curvature and the errors at the best fit, times `Candidate::interval_factor` [SI].
    std::vector<double> sd;
};

/// Where a fit ended.
struct FitMode {
    std::vector<double> values;  ///< of all parameters [SI]
    double log_evidence = 0.0;
};

/// One effect, or several together, with the parameters that fit best.
struct EffectFit {
    std::vector<FittedEffect> effects;
    Eigen::VectorXd x;            ///< all parameters in units of their priors
    Eigen::VectorXd residuals;    ///< at the best fit
    Eigen::MatrixXd derivatives;  ///< of the residuals by x there
    double chi_square = 0.0;      ///< of the whitened residuals
    double log_evidence = 0.0;    ///< natural logarithm of the Bayes factor against no effect
    /// The same of all effects at once, whatever was made of `log_evidence` (`find_sets`,
    /// `explain`).
    double log_evidence_together = 0.0;
    std::vector<FitMode> modes;  ///< where the fits from all starts ended
    std::vector<Trial> trials;   ///< what was simulated on the way
    int num_runs = 0;            ///< simulations that it took
    /// Why the effects could not be simulated; empty if they could.
    std::string failure;
};

/// "local_push" or "local_push + registration".
std::string name_of(const EffectFit& fit);

/// The effects with the values of the fit.
std::vector<ActiveEffect> active_effects(const EffectFit& fit);

/// The parameters of all effects, in the order of `EffectFit::x`.
std::vector<EffectParameter> parameters_of(const EffectFit& fit);

struct FitOptions {
    int num_starts = 3;  ///< fitted out of the starts, those whose fingerprints promise most
    int max_iterations = 8;
};

/// Fits the parameters of a candidate to the data with the full simulator: Levenberg-Marquardt on
/// the whitened residuals, with a row for each normal prior and derivatives by finite differences
/// of `EffectParameter::step`, large against the simulation's roughness.
///
/// A candidate with several starts is simulated at each: fingerprints at finite amplitudes, as
/// contact makes that of an infinitesimal one misleading. Those that promise most
/// (`fingerprint.hpp`), at places of their own, are fitted from the amplitude at which they promise
/// it, or from their own if that leaves less; none if no start promises to take 2.5 or more off
/// half the sum of squares. From a start at which the linearised problem promises less than
/// 1 off half the sum of squares no step is taken.
///
/// Its log evidence is Laplace's, with parameters scaled by their priors, whitened residuals z, S
/// their derivatives, and x those with a normal prior:
///
///     ln B = 1/2 (|z_0|^2 - |z|^2 - |x|^2) - 1/2 ln det(I + S' S) + 1/2 ln(2 pi / 12) per uniform
///
/// The last term is that of a parameter that may be anywhere: about zero if the data say nothing.
///
/// A candidate with roughness is fitted as `fit_rough_effect` says.
/// @param base  residuals of the case as it is
EffectFit fit_effect(const DiagnosisProblem& problem, const Whitening& whitening,
                     const Eigen::VectorXd& base, std::size_t candidate,
                     const FitOptions& options = {});

/// The same for effects that are in the model together, from one start.
EffectFit fit_together(const DiagnosisProblem& problem, const Whitening& whitening,
                       const Eigen::VectorXd& base, const std::vector<ActiveEffect>& start,
                       const FitOptions& options = {});

}  // namespace braidzone
