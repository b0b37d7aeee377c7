#pragma once

#include "discrepancy/imaging.hpp"
#include "discrepancy/model.hpp"

#include <Eigen/Core>

#include <numbers>
#include <vector>

namespace braidzone {

struct PatchOptions {
    double length = 0.8e-3;  ///< along the centerline [m]
    int around = 12;         ///< patches around: 30 degrees each
    int fewest_points = 4;   ///< in a patch that counts
    double farthest = 2e-3;  ///< points further off than this are no device [m]
};

/// Row and column of the patch at a place of the device.
/// @param angle  about the ring's frame, -pi to 2 pi [rad]
struct PatchPlace {
    int row = 0;     ///< along the centerline
    int column = 0;  ///< around
};
PatchPlace patch_place(double arc_length, double angle, const PatchOptions& options);

/// A piece of the simulated device's surface with the measured points over it.
struct Patch {
    int row = 0;                       ///< along the centerline
    int column = 0;                    ///< around
    std::vector<int> points = {};      ///< indices of measured points
    std::vector<double> weights = {};  ///< of their distances; they sum to 1
    double gap = 0.0;                  ///< weighted mean of their signed distances [m]
    /// Robust standard deviation of a point: 1.4826 times the median absolute deviation, drawn
    /// towards the median of all patches, as a few points alone say little [m].
    double point_sd = 0.0;
    Vec3 centre = Vec3::Zero();   ///< mean of the points' feet [m]
    Vec3 normal = Vec3::UnitX();  ///< mean of the surface's normals there
    double arc_length = 0.0;      ///< of the patch's middle [m]
    double angle = 0.0;           ///< of its middle, 0 to 2 pi [rad]
    double area = 0.0;            ///< of the patch on the simulated device [m^2]
    double contact_share = 0.0;   ///< of its points over crossings that touch the wall
    std::vector<int> nodes = {};  ///< crossings nearest to its points, increasing
    double hub_slope = 0.0;       ///< d(simulated surface) / d(shift of hubs): `set_hub_slopes` [-]
};

/// Where the measured surface lies against the simulated one, patch by patch.
struct DiscrepancyField {
    std::vector<Patch> patches;  ///< rows and columns increasing
    PatchOptions options;
    int num_points = 0;
    int num_on_rim = 0;     ///< left out: nearest to the device's rim
    int num_far = 0;        ///< left out: no device, `PatchOptions::farthest`
    int num_in_sparse = 0;  ///< left out: in patches of too few points
};

/// Signed distance (outward positive) of each measured point to the simulated surface, collected in
/// patches over (arc length, angle) of the feet.
///
/// A patch's gap is Tukey's bisquare estimate of their location (Beaton and Tukey 1974, doi
/// 10.1080/00401706.1974.10489171), which outliers do not move and which scatters but 5 % more than
/// a mean: a mean with the weights
///
///     w = (1 - u^2)^2 for |u| < 1, else 0,   u = (d - gap) / (4.685 sd)
///
/// They are found once, on the base model, and stay: a gap then moves as smoothly with a model as
/// its distances do. A median would go from point to point, and with it from one direction of the
/// normal to another.
///
/// @param points   measured, in the frame of the scan [m]
/// @param imaging  of the base model
DiscrepancyField make_discrepancy_field(const std::vector<Vec3>& points, const Imaging& imaging,
                                        const Simulation& base, const PatchOptions& options = {});

/// The patches' gaps if an altered model had been simulated [m]: the same points in the same
/// patches, so that models are compared on the same data.
///
/// A point beyond the altered device's ends says nothing about its surface. Its distance from the
/// base model's device stands in for it, as both lie on the wall there; over the first 0.4 mm the
/// distance from the plane that touches the altered surface at its rim goes over into it, so that
/// gaps change smoothly. Where the device ends is told by `MeasuredScalars`.
/// @param surface  of the altered model
/// @param base     of the base model
Eigen::VectorXd patch_gaps(const std::vector<Vec3>& points, const DiscrepancyField& field,
                           const Imaging& imaging, const DeviceSurface& surface,
                           const DeviceSurface& base);

/// Median of values, the mean of the middle two if their number is even. `values` are reordered.
double median_of(std::vector<double>& values);

}  // namespace braidzone
