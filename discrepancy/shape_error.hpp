#pragma once

#include "discrepancy/effect_fit.hpp"

namespace braidzone {

/// Log evidence of an effect whose shape is right to a share of its size only: of its fit, whose
/// parameters are fitted anew (`linear_refit`) with the errors D = `with_implementation_error`,
/// against no effect with the errors C of the problem.
///
///     ln B = ln p(r | effect, D) - ln p(r_0 | C),
///     ln p(r | C) = -1/2 r' C^-1 r - 1/2 ln det C
///
/// A strong effect that is not quite as it is implemented leaves a structured rest; without this it
/// would lose to an unknown effect, or be given a companion that makes up for it.
/// @param whitening  of the problem's covariance
/// @param base   residuals of the case as it is
/// @param ratio  error of the shape over the effect's size
double evidence_with_shape_error(const DiagnosisProblem& problem, const Whitening& whitening,
                                 const Eigen::VectorXd& base, const EffectFit& fit, double ratio);

}  // namespace braidzone
