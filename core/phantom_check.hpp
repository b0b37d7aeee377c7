#pragma once

#include "core/phantom.hpp"

namespace braidzone {

/// Checks each parameter of a phantom: ranges, and sizes against each other. Whether the parts meet
/// and leave each other's openings free is found when they are placed (`make_shape`).
/// @throws ConfigError naming the parameter, its value and what is allowed
void require_valid(const Phantom& phantom);

}  // namespace braidzone
