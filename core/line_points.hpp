#pragma once

#include "core/centerline.hpp"

namespace braidzone {

/// The same line from its other end.
Polyline reversed(Polyline line);

/// Length of the straight pieces between the points [m].
double length_of(const Polyline& line);

}  // namespace braidzone
