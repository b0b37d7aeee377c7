#pragma once

#include "discrepancy/density_map.hpp"
#include "discrepancy/model.hpp"

#include <Eigen/Core>

#include <vector>

namespace braidzone {

/// The places of a density map that lie over the simulated device.
struct DensityField {
    DensityQuantity quantity = DensityQuantity::pore_density;
    std::vector<DensityPlace> places = {};
    /// Area of a rhombus of the case's own force-free device: what a measured increase refers to,
    /// whatever device an effect supposes [m^2].
    double force_free_area = 0.0;
    std::vector<Vec3> feet = {};  ///< of the places on the base model's surface [m]
    /// Density of the base model at each place, in the quantity's unit but counted from no braid at
    /// all: an increase plus 1. Relative errors are relative to it.
    Eigen::VectorXd scale = Eigen::VectorXd(0);
    int num_beyond_ends = 0;  ///< places left out: beyond the simulated device's ends
};

/// Puts a measured density map on the simulated device.
/// @param imaging  of the base model
/// @throws InputError if a place lies more than 2 mm from the device, beyond an end of it more than
///         the device's length, or none lies over it, with the line of the file
DensityField make_density_field(const DensityMap& map, const Imaging& imaging,
                                const Simulation& base);

/// Density of a simulated device at the places, in the unit of the quantity, |places|: the mean
/// over the rhombi about the place's foot on the device,
///
///     q = sum w A q_i / sum w A,   w = exp(-d^2 / (2 h^2)),   h = window / sqrt(12)
///
/// with A the rhombi's areas and d their distances from the foot. The kernel has the second moment
/// of the square window, without its edges: q changes smoothly as the device moves. h is no less
/// than the size of a rhombus. A place beyond the device's ends has the density of its rim.
Eigen::VectorXd simulated_density(const DensityField& field, const Imaging& imaging,
                                  const Simulation& simulation);

}  // namespace braidzone
