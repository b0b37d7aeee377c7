#pragma once

#include "support/hidden/hidden_scene.hpp"

namespace braidzone::hidden {

/// A stretch of the vessel over which an operator pushed or pulled.
struct SpacingStretch {
    double centre = 0.0;      ///< arc length [m]
    double half_width = 0.0;  ///< to where the change has fallen to one half [m]
    double change = 0.0;      ///< relative, of the ring spacing: below 0 a push
    double ripple = 0.0;      ///< of the change, an unsteady hand
    double rebound = 0.0;     ///< opposite change after it, over the change
};

/// Relative change of the ring spacing at an arc length: a smooth plateau whose distal flank is
/// half again as long as its proximal one, with ripples 1.3 mm apart, and proximally of it, where
/// the rings come out later, a small change the other way.
double spacing_change(const SpacingStretch& stretch, double arc_length);

/// Multiplies the scene's ring spacing by 1 + change, at least 0.1.
void add_stretch(HiddenScene& scene, const SpacingStretch& stretch);

}  // namespace braidzone::hidden
