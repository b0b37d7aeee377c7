#include "discrepancy/registered_residuals.hpp"

#include <Eigen/Cholesky>

namespace braidzone {
namespace {

/// Each brings m to within its square, over the radius.
constexpr int base_rounds = 3;

}  // namespace

RegisteredResiduals::RegisteredResiduals(const Observations& observations, const ErrorModel& error,
                                         const Simulation& base, const Imaging& imaging)
    : observations_(observations),
      error_(error),
      base_(base.surface),
      most_probable_(error.motion_variance.asDiagonal() *
                     error.covariance().llt().solve(error.motion).transpose()),
      base_motion_(Eigen::VectorXd::Zero(error.motion.cols()))
{
    for (int round = 0; round < base_rounds; ++round)
        base_motion_ = most_probable_ * about(base_motion_, base, imaging);
}

Eigen::VectorXd RegisteredResiduals::operator()(const Simulation& simulation,
                                                const Imaging& imaging) const
{
    const Eigen::VectorXd motion = most_probable_ * about(base_motion_, simulation, imaging);
    return about(motion, simulation, imaging);
}

Eigen::VectorXd RegisteredResiduals::about(const Eigen::VectorXd& motion,
                                           const Simulation& simulation,
                                           const Imaging& imaging) const
{
    const Imaging moved = moved_on(imaging, -motion.head<3>(), -motion.tail<3>(), error_.middle);
    return residuals(observations_, simulation, moved, base_) + error_.motion * motion;
}

}  // namespace braidzone
