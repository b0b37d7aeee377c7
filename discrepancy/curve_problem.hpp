#pragma once

#include "discrepancy/curve_noise.hpp"
#include "discrepancy/diagnosis_problem.hpp"
#include "discrepancy/explanation.hpp"

#include <functional>
#include <utility>
#include <vector>

namespace braidzone {

/// Something that may be missing in the model of a bench. Each stands in a file of its own.
template <typename Model>
struct CurveEffect {
    Candidate candidate;
    /// The model with the effect.
    std::function<Model(const Model&, const std::vector<double>&)> apply;
    /// Standard deviation by which it moves each ordinate at random, over the simulated value of
    /// the case as it is; empty for none (`Candidate::roughness`).
    std::function<double(const std::vector<double>&)> roughness = {};
};

/// A curve measured on a bench.
struct MeasuredCurve {
    std::vector<double> abscissae;  ///< increasing: displacements [m], velocities [m/s]
    std::vector<double> ordinates;  ///< one an abscissa: forces [N], pressure drops [Pa]
    double standard_error = 0.0;    ///< of an ordinate, from its repeats; 0 if unknown
};

/// A bench with its effects, as far as the search for a missing one is concerned.
template <typename Model>
struct CurveBench {
    Model base;  ///< the case as it is
    std::vector<CurveEffect<Model>> effects;
    /// The ordinates of a model at the measured abscissae. May be called from several threads.
    std::function<std::vector<double>(const Model&)> simulate;
};

/// The model of a bench with effects in it.
template <typename Model>
Model with_effects(const CurveBench<Model>& bench, const std::vector<ActiveEffect>& active)
{
    Model model = bench.base;
    for (const ActiveEffect& effect : active)
        model = bench.effects[effect.candidate].apply(model, effect.values);
    return model;
}

/// The problem without its candidates and its residuals: everything that is alike for all curves.
/// The unknown effect moves the curve by 2 to 32 % over 0.06 to 0.25 of its range.
DiagnosisProblem curve_problem_of(const CurveWeights& weights);

/// Relative residuals (`CurveWeights`).
Eigen::VectorXd relative_residuals(const MeasuredCurve& measured,
                                   const std::vector<double>& simulated,
                                   const CurveWeights& weights);

/// Covariance of relative residuals if a model that leaves some is the truth: its own curve takes
/// the place of that of the case as it is, in the same units.
Eigen::MatrixXd covariance_at_fit(const MeasuredCurve& measured, const CurveNoise& noise,
                                  const CurveWeights& weights, const Eigen::VectorXd& residuals);

/// A measured curve against its simulation, for `explain`.
/// @throws what `bench.simulate` throws for the case as it is
template <typename Model>
DiagnosisProblem make_curve_problem(const MeasuredCurve& measured, const CurveNoise& noise,
                                    const CurveBench<Model>& bench)
{
    const CurveWeights weights = make_curve_weights(measured.abscissae, bench.simulate(bench.base),
                                                    measured.standard_error, noise);
    DiagnosisProblem problem = curve_problem_of(weights);
    for (const CurveEffect<Model>& effect : bench.effects) {
        problem.candidates.push_back(effect.candidate);
        if (!effect.roughness) continue;
        problem.candidates.back().roughness =
            [weights, rough = effect.roughness](const std::vector<double>& values) {
                return Eigen::VectorXd(rough(values) * weights.relative);
            };
    }
    problem.covariance_at = [measured, noise, weights](const Eigen::VectorXd& residuals) {
        return covariance_at_fit(measured, noise, weights, residuals);
    };
    problem.residuals = [measured, weights, bench](const std::vector<ActiveEffect>& active) {
        return relative_residuals(measured, bench.simulate(with_effects(bench, active)), weights);
    };
    return problem;
}

/// How curves are searched: for two effects together at the most, which is what a smooth curve of a
/// few shapes can tell. Where an unknown effect explains a curve about as well as a known one, the
/// answer is a set with both: a dozen points seldom exclude either.
ExplainOptions curve_options();

/// Blocks of neighbouring points for `held_out_gap`: four, or as many as there are points.
std::vector<std::vector<int>> curve_folds(std::size_t num_points);

}  // namespace braidzone
