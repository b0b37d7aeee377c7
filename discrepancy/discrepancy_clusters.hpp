#pragma once

#include "discrepancy/error_model.hpp"

#include <Eigen/Core>

#include <cstdint>
#include <vector>

namespace braidzone {

struct ClusterOptions {
    double kernel = 0.8e-3;  ///< standard deviation of the smoothing kernel [m]
    double threshold = 2.5;  ///< |t| of a patch that belongs to a cluster
    int num_draws = 2000;    ///< from the error model, for the family-wise p
    std::uint32_t seed = 1;
};

/// Neighbouring patches that differ from the simulation to one side.
struct Cluster {
    std::vector<int> patches;  ///< increasing
    double mass = 0.0;         ///< sum of |t| over the patches
    /// Share of no-effect maps that hold such a cluster, anywhere: by its mass or by its largest
    /// |t|, whichever is rarer, times two for the choice.
    double p_family_wise = 1.0;
    double area = 0.0;            ///< [m^2]
    double from = 0.0, to = 0.0;  ///< its extent along the centerline [m]
    double arc_length = 0.0;      ///< its middle, weighted by the gap [m]
    double angle = 0.0;           ///< its middle around [rad]
    double mean_gap = 0.0;        ///< signed, of the patches' gaps [m]
    double largest_gap = 0.0;     ///< signed, of the smoothed map [m]
    double contact_share = 0.0;   ///< of its area on wall contact
};

/// The discrepancy after the registration has been taken out, smoothed and standardised.
struct DiscrepancyMap {
    Eigen::VectorXd gap;            ///< of the patches, registered [m]
    Eigen::VectorXd smoothed;       ///< with the kernel [m]
    Eigen::VectorXd t;              ///< smoothed, over its standard deviation without an effect
    std::vector<Cluster> clusters;  ///< smallest p first
};

/// Where simulation and measurement differ by more than the noise floor.
///
/// The scan's motion is projected out of the patches by generalised least squares, the rest
/// smoothed and divided by its standard deviation; a cluster is a set of neighbouring patches above
/// the threshold on one side.
/// Its p is that of its mass and of its largest |t| against the largest of maps drawn from the
/// error model alone, treated alike (Maris and Oostenveld 2007, doi 10.1016/j.jneumeth.2007.03.024,
/// by parametric draws). It says that there is something, not where exactly its border runs.
DiscrepancyMap make_discrepancy_map(const DiscrepancyField& field, const ErrorModel& error,
                                    const Eigen::VectorXd& gaps,
                                    const ClusterOptions& options = {});

/// Rows that smooth values over the patches: normalised Gaussian weights by distance in space.
Eigen::MatrixXd smoothing_matrix(const DiscrepancyField& field, double kernel);

}  // namespace braidzone
