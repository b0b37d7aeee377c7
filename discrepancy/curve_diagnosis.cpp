#include "discrepancy/curve_diagnosis.hpp"

#include "discrepancy/effect_roughness.hpp"
#include "discrepancy/whitening.hpp"

#include <cmath>

namespace braidzone {
namespace {

double rms(const Eigen::VectorXd& values)
{
    return std::sqrt(values.squaredNorm() / static_cast<double>(values.size()));
}

}  // namespace

CurveDiagnosis diagnose_curve(const MeasuredCurve& measured, const CurveNoise& noise,
                              const CurveWeights& weights, const DiagnosisProblem& problem,
                              const ExplainOptions& options)
{
    CurveDiagnosis diagnosis{measured, noise, explain(problem, options)};
    const Eigen::VectorXd& base = diagnosis.explanation.base_residuals;
    const Eigen::VectorXd& left = diagnosis.explanation.residuals_after();
    for (std::size_t i = 0; i < measured.ordinates.size(); ++i) {
        const auto row = static_cast<Eigen::Index>(i);
        const double weight = weights.weights[row];
        diagnosis.before.push_back(measured.ordinates[i] - weight * base[row]);
        diagnosis.after.push_back(measured.ordinates[i] - weight * left[row]);
        diagnosis.weights.push_back(weight);
        diagnosis.standard.push_back(weight * std::sqrt(weights.covariance(row, row)));
    }
    const auto folds = curve_folds(measured.ordinates.size());
    diagnosis.held_out = held_out_gap(problem, diagnosis.explanation, folds, 0.0, options);
    const Eigen::MatrixXd rows = held_out_rows(problem, folds, 0.0);
    const auto count = static_cast<double>(measured.ordinates.size());
    diagnosis.gap = {rms(diagnosis.held_out.before), rms(diagnosis.held_out.after),
                     std::sqrt((rows * problem.covariance * rows.transpose()).trace() / count)};
    Eigen::MatrixXd covariance = problem.covariance;
    if (diagnosis.explanation.best) {
        covariance.diagonal() += roughness_variance(
            problem, active_effects(diagnosis.explanation.fits[*diagnosis.explanation.best]));
    }
    const double chi_square = Whitening(covariance)(left).squaredNorm();
    diagnosis.excess = (chi_square - count) / std::sqrt(2.0 * count);
    return diagnosis;
}

}  // namespace braidzone
