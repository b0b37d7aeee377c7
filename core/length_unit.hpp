#pragma once

#include <string>

namespace braidzone {

/// The length unit of a file's coordinates: "m", "cm", "mm" or "um".
struct LengthUnit {
    std::string name = "mm";
    double metres = 1e-3;  ///< length of one unit [m]
};

/// The length unit of that name.
/// @throws ConfigError if the name is none of m, cm, mm, um
LengthUnit length_unit(const std::string& name);

}  // namespace braidzone
