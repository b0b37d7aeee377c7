#pragma once

#include "discrepancy/error_model.hpp"
#include "discrepancy/imaging.hpp"
#include "discrepancy/observations.hpp"

#include <Eigen/Core>

namespace braidzone {

/// Residuals r as the error model understands them, linear in the misplacement m of the scan: found
/// where m is most probable, and brought back from there by what is linear in it,
///
///     r = r(scan moved back by m) + G m,   m = Lambda G' C^-1 r
///
/// G is the slope of the gaps only for small motions. A scan that is turned by two degrees lies
/// 0.35 mm off at an end 10 mm from its middle, and there 0.03 mm further outside a tube of 2 mm
/// radius than the slope says, as much as the whole noise floor: without this, scans that are
/// misplaced no more than others look like something else, or like a misplacement beyond the floor.
///
/// m is updated once for each model, from that of the base model, which is brought to convergence.
class RegisteredResiduals {
public:
    /// What is given must outlive this. @param imaging  of the base model
    RegisteredResiduals(const Observations& observations, const ErrorModel& error,
                        const Simulation& base, const Imaging& imaging);

    /// Of a model: rows and units as `residuals` in observations.hpp.
    Eigen::VectorXd operator()(const Simulation& simulation, const Imaging& imaging) const;

private:
    Eigen::VectorXd about(const Eigen::VectorXd& motion, const Simulation& simulation,
                          const Imaging& imaging) const;

    const Observations& observations_;
    const ErrorModel& error_;
    const DeviceSurface& base_;
    Eigen::MatrixXd most_probable_;  ///< Lambda G' C^-1
    Eigen::VectorXd base_motion_;    ///< m of the base model: shift [m], rotation [rad]
};

}  // namespace braidzone
