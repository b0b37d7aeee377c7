#pragma once

#include <array>

namespace braidzone {

/// A colour: red, green, blue, each 0 to 1 (sRGB).
using Colour = std::array<double, 3>;

/// The viridis colour map (Smith and van der Walt 2015, matplotlib, CC0): even steps of the value
/// look like even steps of lightness, also in grey and to the colour-blind. Linear between ten of
/// its colours.
/// @param fraction  0 (dark violet) to 1 (yellow); values outside are limited
Colour viridis(double fraction);

}  // namespace braidzone
