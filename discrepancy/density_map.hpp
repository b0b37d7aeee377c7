#pragma once

#include "core/vector.hpp"

#include <filesystem>
#include <string_view>
#include <vector>

namespace braidzone {

/// In which terms a braid's density was measured.
enum class DensityQuantity {
    pore_density,              ///< pores, or crossings of the wires, per area [1/m^2]
    metal_coverage,            ///< share of the area that wires cover [-]
    surface_density_increase,  ///< pore density over that of the force-free device, less 1 [-]
};

/// "pore_density", "metal_coverage" or "surface_density_increase".
std::string_view name_of(DensityQuantity quantity);

/// The braid's density in a window about a place of the scan.
struct DensityPlace {
    Vec3 point = Vec3::Zero();  ///< the window's middle, in the frame of the scan [m]
    double value = 0.0;         ///< in the unit of the map's quantity
    double sd = 0.0;            ///< of its own, in the same unit; > 0
    double window = 1.5e-3;     ///< side of the square of device that it is the mean of [m]
    int line = 0;               ///< of the file
};

/// What a picture of the wires tells of the braid's density.
struct DensityMap {
    DensityQuantity quantity = DensityQuantity::pore_density;
    std::vector<DensityPlace> places;
};

/// Reads a map of the measured density (CSV): a header and one window a line,
///
///     x_mm,y_mm,z_mm,pore_density_per_mm2,sd_per_mm2
///     1.21,-0.35,14.70,27.5,3.0
///
/// Places are those of the picture that the density was taken from, in the frame of the measured
/// surface (or m, cm, um); they need not lie on the device to better than a millimetre. The density
/// is one of
///
///     pore_density_per_mm2, sd_per_mm2                    > 0
///     metal_coverage, sd                                  0 to 1
///     metal_coverage_percent, sd_percent                  0 to 100
///     surface_density_increase, sd                        > -1
///     surface_density_increase_percent, sd_percent        > -100
///
/// Where wires of 30 um are seen with voxels of 0.1 mm, pores can be counted but the coverage
/// cannot be measured: blooming makes the wires several times as wide. A sixth column `window_mm`
/// is the side of the square that was looked at, 0.5 to 5 mm; 1.5 mm without it.
///
/// @throws IoError if the file cannot be read; InputError with file and line for another header, a
///         value that is no finite number or outside its range, a standard deviation that is not
///         positive, or no place at all
DensityMap read_density_map(const std::filesystem::path& path);

}  // namespace braidzone
