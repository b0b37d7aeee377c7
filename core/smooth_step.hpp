#pragma once

#include <algorithm>

namespace braidzone {

/// Ramp from 0 at u <= 0 to 1 at u >= 1, continuous with its derivative:  3 u^2 - 2 u^3. Its
/// steepest slope, in the middle, is 1.5.
inline double smooth_step(double u)
{
    const double v = std::clamp(u, 0.0, 1.0);
    return v * v * (3.0 - 2.0 * v);
}

}  // namespace braidzone
