#pragma once

#include "discrepancy/curve_problem.hpp"
#include "discrepancy/held_out.hpp"

#include <vector>

namespace braidzone {

/// Root mean squares of relative residuals (`CurveWeights`), what is a common factor or offset of
/// the sensor predicted from the other points and taken out.
struct CurveGap {
    double before = 0.0;
    double after = 0.0;
    double floor = 0.0;  ///< where no effect is missing
};

/// A diagnosis of a measured curve: what was found, and everything that led to it.
struct CurveDiagnosis {
    MeasuredCurve measured;
    CurveNoise noise;
    Explanation explanation;
    HeldOutGap held_out = {};           ///< over four blocks of neighbouring points
    std::vector<double> before = {};    ///< simulated, of the case as it is [N or Pa]
    std::vector<double> after = {};     ///< with the best answer; the same without one
    std::vector<double> weights = {};   ///< what residuals are divided by (`CurveWeights`)
    std::vector<double> standard = {};  ///< deviation of each point where nothing is missing
    CurveGap gap = {};                  ///< on held-out blocks
    /// Of the whitened residuals after, in standard deviations of chi square for as many points:
    /// above 3 the noise floor does not fit the data.
    double excess = 0.0;
};

/// The search for what is missing, given the problem.
CurveDiagnosis diagnose_curve(const MeasuredCurve& measured, const CurveNoise& noise,
                              const CurveWeights& weights, const DiagnosisProblem& problem,
                              const ExplainOptions& options);

/// Finds where a measured curve differs from its simulation, and which effect explains it.
/// @throws what `bench.simulate` throws for the case as it is
template <typename Model>
CurveDiagnosis diagnose_curve(const MeasuredCurve& measured, const CurveNoise& noise,
                              const CurveBench<Model>& bench,
                              const ExplainOptions& options = curve_options())
{
    return diagnose_curve(measured, noise,
                          make_curve_weights(measured.abscissae, bench.simulate(bench.base),
                                             measured.standard_error, noise),
                          make_curve_problem(measured, noise, bench), options);
}

}  // namespace braidzone
