#pragma once

#include <filesystem>
#include <string>

namespace braidzone {

/// How far simulation and measurement differ where no effect is missing: constants of the error
/// model (`error_model.hpp`). The scatter of the points is not among them, each patch tells its
/// own.
struct NoiseFloor {
    /// Correlated imperfections of vessel, device and segmentation.
    double background_sd = 0.031e-3;    ///< [m]
    double background_length = 3.6e-3;  ///< over which their correlation falls to 1/e [m]
    double offset_sd = 0.008e-3;        ///< of the whole segmented surface [m]
    double shift_sd = 0.067e-3;         ///< of the registration, along each axis [m]
    double angle_sd = 0.0117;           ///< of the registration, about each axis: 0.67 deg [rad]
    double white_scale = 0.9;           ///< on the variance of the patches' medians [-]
    double landing_sd = 0.093e-3;       ///< of where both ends land together [m]
    double length_sd = 0.15e-3;         ///< of the length between the ends [m]
    /// Relative, of the density in a window, alike over `background_length` [-].
    double density_sd = 0.03;
    /// Relative, of all measured densities together: threshold and scale of the picture [-].
    double density_scale_sd = 0.05;
    double force_sd = 0.2;  ///< relative, of the device's force on the wall [-]
    /// Where the constants come from.
    std::string source =
        "shipped defaults: learned from 60 simulated scans of devices in idealised sidewall "
        "aneurysms (tests/discrepancy/blind), not from measurements";
};

/// Reads a noise file (JSON) as `noise_floor_text` writes it. Every value must be there but those
/// of density and force, which stand at their defaults if they are missing.
/// @throws IoError if it cannot be read; InputError with the key for a missing, unknown or
///         non-positive value, or text that is no JSON
NoiseFloor read_noise_floor(const std::filesystem::path& path);

/// The noise floor as JSON: each value with its unit, in mm and degrees.
std::string noise_floor_text(const NoiseFloor& floor);

}  // namespace braidzone
