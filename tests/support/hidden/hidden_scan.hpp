#pragma once

#include "discrepancy/measured_scalars.hpp"
#include "support/hidden/hidden_device.hpp"

#include <random>
#include <vector>

namespace braidzone::hidden {

/// What spoils every scan, whether an effect is hidden in it or not.
struct ScanErrors {
    double noise_sd = 0.07e-3;           ///< of a point [m]
    double bias_sd = 0.015e-3;           ///< of the segmentation, correlated [m]
    double correlation_length = 2.2e-3;  ///< of it [m]
    double blur = 0.15e-3;               ///< standard deviation of the scanner's kernel [m]
    double anisotropy = 0.05;            ///< of the blur: longer along one direction by this share
    double voxel = 0.2e-3;               ///< [m]
    double voxel_pull = 0.015e-3;        ///< towards planes of voxels [m]
    double shift_sd = 0.07e-3;           ///< of the registration, along each axis [m]
    double angle_sd = 0.012;             ///< about each axis [rad]
    double outlier_share = 0.025;
    /// Share of the points in one place that are off to one side by some tenths of a millimetre.
    double artefact_share = 0.25;
    double artefact_radius = 0.8e-3;  ///< of that place [m]
    int num_points = 3000;
    int num_holes = 2;
    double streak_width = 0.4e-3;  ///< of a slab in which half the points are missing [m]
    double missing_end = 0.5e-3;   ///< of one end, force-free length [m]
    double unevenness = 0.5;       ///< how much denser the points are on one side than on average
    double end_sd = 0.3e-3;        ///< of the markers' positions [m]
};

/// What a scan adds that is hidden on purpose.
struct HiddenScan {
    double blooming = 0.0;         ///< by another threshold than the scanner's [m]
    Vec3 shift = Vec3::Zero();     ///< of the points [m]
    Vec3 rotation = Vec3::Zero();  ///< of the points about their middle [rad]
};

struct ScannedDevice {
    std::vector<Vec3> points;  ///< [m]
    MeasuredScalars ends;      ///< arc lengths of both ends, with their standard deviations
    Vec3 shift = Vec3::Zero(), rotation = Vec3::Zero();  ///< of the scan in all [m], [rad]
};

/// Errors of a scan that differ from one to the next: noise of 0.05 to 0.10 mm, 1 to 3 holes and
/// the like.
ScanErrors random_scan_errors(std::mt19937& random);

/// Distance by which a segmentation finds the sheet outside its middle, less the scanner's own:
///
///     d = sigma sqrt(2 ln(1 / f)) - sigma0 sqrt(2 ln 2) - sigma^2 / (2 R)
///
/// for a thin sheet blurred by a Gaussian of standard deviation sigma and cut at the share f of its
/// peak; the last term is the pull of a blurred curved sheet to its inside. `threshold_shift` moves
/// f from one half to where a flat sheet's d is that much, as far as there is a surface at all.
double segmented_offset(double blur, double nominal_blur, double threshold_shift, double radius);

/// Where a scan shows a point of the believed vessel's frame.
Vec3 as_scanned(const ScannedDevice& scan, const Vec3& point);

/// Scans a device.
ScannedDevice scanned(const HiddenDevice& device, const HiddenScan& hidden,
                      const ScanErrors& errors, std::mt19937& random);

}  // namespace braidzone::hidden
