#pragma once

#include "discrepancy/effect_parameter.hpp"

#include <Eigen/Core>

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace braidzone {

/// An effect that may be missing, as the search for it sees it.
struct Candidate {
    std::string name;   ///< "local_push"
    std::string title;  ///< for people: "the operator pushed"
    std::vector<EffectParameter> parameters;
    /// Where fits begin, each a value for each parameter [SI]; the first parameter is the
    /// amplitude.
    std::vector<std::vector<double>> starts;
    /// False where the simulation need not run again, as for how the device was seen.
    bool needs_simulation = true;
    std::string separated_by = {};  ///< a measurement that would tell it from others
    /// By which standard deviations of its parameters are wider than the curvature of the fit says:
    /// what happens in reality is not quite the effect as it is implemented.
    double interval_factor = 1.0;
    /// Standard deviations by which the effect moves each residual of the field at random, as
    /// sticking and slipping does, given its values; empty if its residuals are smooth. Only for
    /// candidates with one parameter (`effect_roughness.hpp`).
    std::function<Eigen::VectorXd(const std::vector<double>& values)> roughness = {};
};

/// A candidate that is in the model.
struct ActiveEffect {
    std::size_t candidate = 0;        ///< index in `DiagnosisProblem::candidates`
    std::vector<double> values = {};  ///< of its parameters [SI]
};

/// A measurement against its simulation: all that the search for a missing effect needs to know
/// of an observable. One small adapter makes it: of a device's surface (`surface_problem.hpp`), a
/// press test's force curve, a bench's pressure drop.
///
/// Residuals are measured minus simulated, each in its own unit. The first of them,
/// `distances.rows()`, form a field over a coordinate of their own (places on the device,
/// displacements of a head, velocities); the others are single numbers, of one or several channels.
struct DiagnosisProblem {
    std::vector<Candidate> candidates;
    /// Residuals with effects in the model, none for the case as it is; may be called from several
    /// threads. Throws `Error` where the simulation is not possible.
    std::function<Eigen::VectorXd(const std::vector<ActiveEffect>&)> residuals;
    /// Of the residuals where no effect is missing: noise, imperfections, nuisances marginalised.
    Eigen::MatrixXd covariance;
    /// The same if a model that leaves these residuals is the truth, for intervals: of errors that
    /// grow with what is simulated. Empty where they do not.
    std::function<Eigen::MatrixXd(const Eigen::VectorXd& residuals)> covariance_at = {};
    /// The part of the covariance that is nobody's model error, such as the scan's registration: it
    /// is taken out of a gap. Empty for none.
    Eigen::MatrixXd nuisance;
    /// Between the field's residuals, in the unit of its coordinate.
    Eigen::MatrixXd distances;
    /// Distance over which the error of an effect's implementation stays alike.
    double correlation_length = 0.0;
    /// Standard deviations and correlation lengths of the unknown effect, a Gaussian process over
    /// the field, each combination alike probable.
    std::vector<double> unknown_amplitudes, unknown_lengths;
    /// How single numbers may be off for unknown reasons: for each of their channels the covariance
    /// of a deviation of size 1, |single numbers| x |single numbers|, 0 but for those of the
    /// channel, each in its own unit. Channels are alike probable.
    std::vector<Eigen::MatrixXd> unknown_channels;
    std::vector<double> unknown_deviations;  ///< sizes of such deviations, alike probable
    /// Correlation of the error of an effect's implementation among the single numbers, 0 for those
    /// it does not touch. Empty: it touches none.
    Eigen::MatrixXd shape_correlation;
};

}  // namespace braidzone
