#pragma once

#include "discrepancy/discrepancy_field.hpp"

#include <vector>

namespace braidzone {

/// Patches nearer to a held-out block than this are not learned from either: about half the length
/// over which the background is alike [m].
constexpr double held_out_buffer = 1e-3;

/// Blocks of patches for cross-validation, each three rows long and a quarter wide: with its buffer
/// about as long as a diverter's radius, smaller than a neck. What is seen in the neck alone could
/// not be learned with blocks that hold all of it. Every patch is in one block.
std::vector<std::vector<int>> surface_folds(const DiscrepancyField& field);

}  // namespace braidzone
