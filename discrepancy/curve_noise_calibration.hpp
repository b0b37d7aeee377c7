#pragma once

#include "discrepancy/curve_problem.hpp"

#include <vector>

namespace braidzone {

/// A measured curve in which no effect is missing, and its simulation.
struct CurveCalibrationSet {
    MeasuredCurve measured;
    std::vector<double> simulated;  ///< of the case as it is, at its abscissae [N or Pa]
};

/// Learns how far curves and their simulation differ where no effect is missing: the constants of
/// the noise maximise the probability of the curves' relative residuals, r ~ N(0, C) of
/// `CurveWeights`, with a log-normal prior of factor 3 on each constant about the shipped one,
/// which decides where a few curves say nothing. A constant that is shipped as 0 stays 0.
///
/// Devices, benches and days must differ from curve to curve as they will: repeats of one piece on
/// one bench share what is wrong with both, which is then not learned.
/// @throws InputError if there are fewer than 3 curves, or a simulated one is zero everywhere
CurveNoise calibrate_curve_noise(const std::vector<CurveCalibrationSet>& sets,
                                 const CurveNoise& shipped);

}  // namespace braidzone
