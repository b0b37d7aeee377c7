#pragma once

#include "support/hidden/braid_sheet.hpp"
#include "support/hidden/hidden_scene.hpp"

#include <vector>

namespace braidzone::hidden {

struct SheetResolution {
    double spacing = 0.19e-3;  ///< of the rows in force-free braid [m]
    int columns = 38;
    double phase = 0.3;  ///< of the first column, over the step between columns
};

/// A device as it really lies.
struct HiddenDevice {
    int rows = 0, columns = 0;
    double row_step = 0.0;           ///< force-free length from row to row [m]
    std::vector<Vec3> points;        ///< rows x columns, in the frame of the believed vessel [m]
    std::vector<double> radii;       ///< rows x columns, from the rows' hubs [m]
    std::vector<double> pressure;    ///< rows x columns, real, on the wall [Pa]
    std::vector<double> arc_length;  ///< of each row, decreasing [m]
    int iterations = 0;
};

/// Arc lengths of the rows at release: force-free braid is laid down at the rate 1 / lambda(s),
///
///     ds / dx = - lambda(s)
///
/// by the midpoint rule in steps of a tenth of a row.
std::vector<double> released_rows(const HiddenScene& scene, double length, int rows);

/// Puts a device where a scene says: `released_rows`, then `at_rest`; where the rings slide or
/// their hubs move, these and the shape in turn.
///
/// It shares with the deployment under test the device's coefficients, the assumption that rings
/// stay in planes across the vessel and points on rays in them, and that these rays start from the
/// middle of the lumen: not its lattice, energy, motion, contact or any effect.
HiddenDevice placed_device(const HiddenScene& scene, const SheetResolution& resolution = {});

}  // namespace braidzone::hidden
