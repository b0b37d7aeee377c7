#pragma once

#include <vector>

namespace braidzone {

/// Push or pull over a stretch of the centerline: rings released there are set at `spacing` times
/// their nominal spacing; below 1 the operator pushes, above 1 pulls.
struct PushPull {
    double from = 0.0;     ///< arc length on the centerline [m]
    double to = 0.0;       ///< [m]; > from
    double spacing = 1.0;  ///< lambda = ring spacing / nominal [-]; > 0
};

/// Ring spacing at release, as a function of the place on the centerline (Zavodszky et al. 2020,
/// section 2.2: "the distance between the spring cross-section units at the moment of release").
struct ReleaseSchedule {
    std::vector<PushPull> windows;  ///< must not overlap; lambda = 1 outside them
};

/// Checks the windows.
/// @throws ConfigError if a window is empty or reversed, lambda is not in 0.05 to 2, or two overlap
void validate(const ReleaseSchedule& schedule);

/// Arc lengths at which the rings are released [m], ring 0 (distal) first, decreasing:
/// s_0 = landing_distal, s_(k+1) = s_k - dL0 <lambda>, where <lambda> makes the nominal length
/// between two rings exact where a gap straddles the edge of a window.
std::vector<double> ring_positions(const ReleaseSchedule& schedule, double landing_distal,
                                   double nominal_spacing, int num_rings);

}  // namespace braidzone
