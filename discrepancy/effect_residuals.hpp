#pragma once

#include "discrepancy/diagnosis_problem.hpp"

#include <Eigen/Core>

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace braidzone {

/// A simulation that was made: values of all parameters [SI], and its residuals.
struct Trial {
    std::vector<double> values;
    Eigen::VectorXd residuals;
};

/// Residuals of effects that are in the model together, as a function of all their parameters in
/// units of the priors:
///
///     x = (value - prior mean) / prior standard deviation
///
/// Values beyond a parameter's bounds count as the bound. Remembers what has been simulated.
class EffectResiduals {
public:
    /// @param candidates  which of the problem's; > 0 of them. The problem must outlive this.
    EffectResiduals(const DiagnosisProblem& problem, std::vector<std::size_t> candidates);

    const std::vector<std::size_t>& candidates() const { return candidates_; }
    const std::vector<EffectParameter>& parameters() const { return parameters_; }
    Eigen::Index size() const { return static_cast<Eigen::Index>(parameters_.size()); }

    std::vector<double> values(const Eigen::VectorXd& x) const;
    Eigen::VectorXd scaled(const std::vector<double>& values) const;
    /// The effects with their own share of the values.
    std::vector<ActiveEffect> effects(const std::vector<double>& values) const;

    /// Residuals at several places, in parallel. An empty vector where the simulation fails.
    std::vector<Eigen::VectorXd> at(const std::vector<Eigen::VectorXd>& places);

    /// Residuals and their derivatives by x, from one side, towards the inside of the bounds, over
    /// steps of `EffectParameter::step`: large against the simulation's roughness. None where it
    /// fails.
    std::optional<std::pair<Eigen::VectorXd, Eigen::MatrixXd>> with_derivatives(
        const Eigen::VectorXd& x);

    int num_runs() const { return num_runs_; }
    std::vector<Trial> trials() const;                       ///< that did not fail
    const std::string& failure() const { return failure_; }  ///< of the last that did

private:
    bool needs_simulation() const;

    const DiagnosisProblem& problem_;
    std::vector<std::size_t> candidates_;
    std::vector<EffectParameter> parameters_;
    std::map<std::vector<double>, Eigen::VectorXd> known_;
    int num_runs_ = 0;
    std::string failure_;
};

}  // namespace braidzone
