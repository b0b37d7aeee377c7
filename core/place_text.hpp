#pragma once

#include "core/length_unit.hpp"
#include "core/vector.hpp"

#include <string>

namespace braidzone {

/// "(1, 2.5, 0) mm": a point for a message, in a unit in which the user can look it up. What should
/// be 0 does not show as 2e-17.
/// @param point  [m]
/// @param unit   millimetres unless told
std::string place_text(const Vec3& point, const LengthUnit& unit = {});

}  // namespace braidzone
