#pragma once

#include "discrepancy/effect_fit.hpp"

#include <Eigen/Core>

#include <string>
#include <vector>

namespace braidzone {

/// Less cannot be told apart: a misfit of 3 standard deviations in one direction of the data.
constexpr double least_separation = 3.0;

/// How well candidates could be told apart by a measurement, before there is any.
struct Separability {
    std::vector<std::string> names;
    /// |candidates| x |candidates|: d'(i, j), how far the data of candidate i are from what
    /// candidate j can explain; NaN where one of them cannot be simulated.
    Eigen::MatrixXd separation;
    Eigen::VectorXd detection;  ///< d' of each candidate against no effect
};

/// The data are those that the case would give with candidate i at a typical size, without noise;
/// candidate j is fitted to them with the full simulator, and what is left is measured in units of
/// the noise:
///
///     d'(i, j) = min over the parameters of j of sqrt(|L^-1 (m_i - m_j)|^2),   L L' = C
///
/// which is how a test for j against i is best chosen (Hunter and Reiner 1965, T-optimality). A
/// candidate's typical size is one standard deviation of its prior in its first parameter; of one
/// with several starts, the start of median d' against no effect.
/// @param problem  the same simulations are asked for many times: one that remembers them
///                (`residual_memory.hpp`)
/// @param rows     residuals that would be measured, increasing
Separability separability(const DiagnosisProblem& problem, const std::vector<int>& rows,
                          const FitOptions& options = {});

}  // namespace braidzone
