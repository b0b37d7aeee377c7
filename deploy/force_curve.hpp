#pragma once

#include <filesystem>
#include <vector>

namespace braidzone {

/// A point of a measured force curve.
struct ForcePoint {
    double displacement = 0.0;  ///< of the head [m]
    double force = 0.0;         ///< mean of the repeats [N]
};

/// A press test as it was measured.
struct ForceCurve {
    std::vector<ForcePoint> points;  ///< displacements increasing
    int num_repeats = 1;
    /// Standard deviation of a repeat about the mean of the repeats [N], pooled over all points;
    /// 0 for a single curve.
    double deviation = 0.0;
};

/// Reads a measured force curve: a CSV file whose header names the columns with their units,
/// `displacement_mm` (or `_m`, `_um`) first, then one column a repeat, each beginning with `force`
/// and ending in `_N`, `_mN` or `_uN`, such as `displacement_mm,force_1_mN,force_2_mN,force_3_mN`.
/// Displacements increase from 0 or above; forces may be negative by noise, but not all of them.
/// @throws IoError if the file cannot be read; InputError with the number of the line if it is not
///         such a file, and if it has fewer than four points or no mean force above zero
ForceCurve read_force_curve(const std::filesystem::path& path);

}  // namespace braidzone
