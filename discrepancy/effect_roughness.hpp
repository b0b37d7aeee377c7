#pragma once

#include "discrepancy/effect_fit.hpp"

#include <Eigen/Core>

#include <vector>

namespace braidzone {

/// What effects that are in the model do to each residual of the field at random (`Candidate::
/// roughness`): a diagonal to be added to the covariance of all residuals.
Eigen::VectorXd roughness_variance(const DiagnosisProblem& problem,
                                   const std::vector<ActiveEffect>& effects);

/// Fits a candidate that moves residuals at random as well, whose covariance grows with its
/// amplitude a: the posterior of its only parameter is computed on a grid between its bounds.
///
///     p(a | r) ~ N(r(a); 0, C + S(a)) p(a),   ln B = ln of the mean over p(a) of
///                                                    N(r(a); 0, C + S(a)) / N(r(0); 0, C)
///
/// averaged over S as stated, twice as probable as 0.6^2 and 1.6^2 times as large: how much sticks
/// and slips differs from one device to the next. The prior is that between the bounds. Value and
/// deviation of the fit are mean and standard deviation of the posterior; its chi square is in
/// units of C + S.
/// @param base  residuals of the case as it is
/// @throws InputError if the candidate has more than one parameter
EffectFit fit_rough_effect(const DiagnosisProblem& problem, const Eigen::VectorXd& base,
                           std::size_t candidate);

}  // namespace braidzone
