#pragma once

#include "discrepancy/discrepancy_field.hpp"

#include <vector>

namespace braidzone {

/// Patches nearer to a held-out block than this are not learned from either: about half the length
/// over which the background is alike [m].
constexpr double held_out_buffer = 1e-3;

/// Blocks of patches for cross-validation: four along the device, of about as many patches each,
/// times two halves around. Every patch is in one block.
std::vector<std::vector<int>> surface_folds(const DiscrepancyField& field);

}  // namespace braidzone
