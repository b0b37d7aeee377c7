#include "discrepancy/shape_error.hpp"

#include "discrepancy/implementation_error.hpp"
#include "discrepancy/linear_refit.hpp"

namespace braidzone {

double evidence_with_shape_error(const DiagnosisProblem& problem, const Whitening& whitening,
                                 const Eigen::VectorXd& base, const EffectFit& fit, double ratio)
{
    const Whitening doubting(
        with_implementation_error(problem, active_effects(fit), base - fit.residuals, ratio));
    const LinearRefit refit = linear_refit(
        doubting(fit.residuals), doubting.of_columns(fit.derivatives), fit.x, parameters_of(fit));
    return refit.log_evidence + 0.5 * whitening(base).squaredNorm() -
           0.5 * (doubting.log_determinant() - whitening.log_determinant());
}

}  // namespace braidzone
