#pragma once

#include "deploy/axial_twist.hpp"
#include "deploy/incomplete_opening.hpp"

#include <filesystem>
#include <vector>

namespace braidzone {

/// Push or pull over a stretch of the centerline: rings released there are set at `spacing` times
/// the spacing that they would have otherwise; below 1 the operator pushes, above 1 pulls.
struct PushPull {
    double from = 0.0;     ///< arc length on the centerline [m]
    double to = 0.0;       ///< [m]; > from
    double spacing = 1.0;  ///< [-]; > 0
};

/// Ring spacing at a place on the centerline.
struct SpacingPoint {
    double arc_length = 0.0;  ///< on the centerline [m]
    double spacing = 1.0;     ///< lambda = ring spacing / nominal [-]; > 0
};

/// How the operator releases a device: above all the ring spacing, as a function of the place on
/// the centerline (Zavodszky et al. 2020, section 2.2: "the distance between the spring
/// cross-section units at the moment of release").
struct ReleaseSchedule {
    std::vector<PushPull> windows = {};  ///< must not overlap
    /// The whole schedule as a table instead (`spacing_table.hpp`), arc lengths increasing: lambda
    /// is linear between its points and constant beyond its ends. Not together with windows or
    /// sliding.
    std::vector<SpacingPoint> table = {};
    std::filesystem::path table_file = {};  ///< that the table was read from, for the record
    /// Share of the way from the nominal ring spacing, 0, to the one at which a braid of the local
    /// vessel's radius is free of force, 1 (`release_spacing.hpp`).
    double sliding = 0.0;
    std::vector<AxialTwist> twists = {};
    std::vector<IncompleteOpening> incomplete_openings = {};
};

/// Checks windows, table, twists and ends.
/// @throws ConfigError if a window is empty or reversed, two overlap, the table's arc lengths do
///         not increase, a spacing is not in 0.05 to 2 (windows) or 0.05 to 4 (table), sliding is
///         not in 0 to 1, or a table stands beside windows or sliding; what the checks of twists
///         and incomplete openings throw
void validate(const ReleaseSchedule& schedule);

/// Arc lengths at which the rings are released [m], ring 0 (distal) first, decreasing: nominal
/// length of braid is laid down at the rate 1 / lambda(s), lambda being the table's value (1
/// without a table) times that of the window:
///
///     s_0 = landing_distal,   integral from s_(k+1) to s_k of ds / lambda(s) = dL0
///
/// The integral is exact, also where a gap straddles the edge of a window or a point of the table.
std::vector<double> ring_positions(const ReleaseSchedule& schedule, double landing_distal,
                                   double nominal_spacing, int num_rings);

/// The same for a device whose rings have unlike nominal spacings, for a flare.
/// @param nominal_spacings  from each ring to the next [m]
std::vector<double> ring_positions(const ReleaseSchedule& schedule, double landing_distal,
                                   const std::vector<double>& nominal_spacings);

}  // namespace braidzone
