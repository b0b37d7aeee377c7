#pragma once

#include "core/centerline.hpp"
#include "deploy/flow_diverter.hpp"
#include "support/hidden/yielding_wall.hpp"

#include <functional>
#include <vector>

namespace braidzone::hidden {

/// A braid as a continuous sheet. Per area of the force-free tube, with x along it and a = R0 theta
/// around it,
///
///     e = sum over both families of  K (l - 1)^2 / 2 + B (r'')^2 / 2   +   k (R0 - r)^2 / 2
///
/// l is the stretch of a wire, |sin b X_x +- cos b X_a|, r'' the second derivative of the radius
/// along it. The constants are those of a lattice of springs c with arms l0 on an area A of each
/// node, made independent of any lattice:
///
///     K = c l0^2 / A = c (1 + t^2) / (2 t),   k = c_radial / (area of its node),
///     B = 0.3 c l0^4 / A = 0.3 c (pi R0 / n)^2 (1 + t^2)^2 / (2 t)
///
/// with n wires of a family. In the units of the device's coefficients; `force_scale` times that
/// are real.
struct BraidSheet {
    double radius = 0.0;             ///< R0 [m]
    double length = 0.0;             ///< [m]
    double braid_ratio = 0.0;        ///< t = tan b
    double wire_stiffness = 0.0;     ///< K [N/m]
    double bending_stiffness = 0.0;  ///< B [N m]
    double radial_stiffness = 0.0;   ///< k [Pa/m]
    double force_scale = 1.0;
};

/// The sheet of a device whose forces are those of springs.
BraidSheet sheet_of(const FlowDiverter& device);

/// Where a sheet lies and what acts on it. Its points are on a grid: rows along the device from the
/// distal end, columns around; each moves along a ray across the vessel.
struct SheetPlace {
    int rows = 0;
    int columns = 0;
    std::vector<CrossSection> sections;  ///< of each row; its rays and springs start there
    std::vector<double> angles;          ///< rows x columns, of the rays about the frame [rad]
    std::vector<double> pitch;           ///< braid ratio of each row over that of the sheet [-]
    std::vector<double> loads;           ///< rows x columns, outward [Pa]
    /// Depth beyond what holds a row at a point, see `WallLevel`.
    std::function<double(int row, const Vec3&)> wall;
    WallSprings springs;

    std::size_t at(int row, int column) const
    {
        return static_cast<std::size_t>(row * columns + (column + columns) % columns);
    }
    /// Unit direction of a point's ray.
    Vec3 ray(int row, int column) const;
};

/// A sheet at rest.
struct SheetAtRest {
    std::vector<double> radii;     ///< rows x columns, along the rays [m]
    std::vector<double> pressure;  ///< on the wall, in the units of the coefficients [Pa]
    int iterations = 0;
    double last_step = 0.0;  ///< largest change of a radius in the last iteration [m]
};

/// Minimises the energy of the sheet, of the wall and of the loads by Newton's method with the
/// sparse second derivatives and a line search.
/// @param start  radii to begin with, rows x columns [m]
/// @throws std::runtime_error if it does not come to rest
SheetAtRest at_rest(const BraidSheet& sheet, const SheetPlace& place, std::vector<double> start);

/// Energy of a shape [J] with its gradient by the radii [N].
struct SheetEnergy {
    double value = 0.0;
    std::vector<double> gradient;
};
SheetEnergy sheet_energy(const BraidSheet& sheet, const SheetPlace& place,
                         const std::vector<double>& radii);

}  // namespace braidzone::hidden
