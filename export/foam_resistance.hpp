#pragma once

#include "export/foam_mesh.hpp"
#include "porous/resistance_sheet.hpp"

#include <string>
#include <vector>

namespace braidzone {

/// The device's metal in the cells of a mesh, whether it resists there or lies on the wall.
struct CellMetal {
    std::vector<int> cells;               ///< increasing
    std::vector<double> void_fraction;    ///< 1 - metal volume / cell volume [-]
    std::vector<double> surface_density;  ///< device area per volume [1/m]
};

/// Resistance on the cells of a mesh; cells that the device does not touch are left out.
struct CellResistance {
    std::vector<int> cells;           ///< increasing
    std::vector<double> darcy;        ///< D along the normal [1/m^2]
    std::vector<double> forchheimer;  ///< F along the normal [1/m]
    std::vector<Vec3> normal;         ///< unit
    TangentialRatio tangential_ratio;
    CellMetal metal;
    double cells_across = 0.0;  ///< cells across the kernel, mean over the acting area
    std::vector<std::string> warnings;
};

/// Half-widths of the kernel, over the local cell size h: the largest cube root of the volume among
/// the cell nearest to the piece of the sheet and that cell's neighbours (one small cell, as
/// meshers leave them at walls, must not narrow the kernel).
struct FoamDepositOptions {
    double kernel_half_width = 3.0;      ///< along the normal
    double tangential_half_width = 2.0;  ///< along the sheet
};

/// Deposits the sheet's resistance onto a polyhedral mesh.
///
/// Each rhombus is cut into pieces no longer than half the smallest local cell size around it. A
/// piece of area
/// dS with normal n gives to the cell with centre x and volume V, at r from the piece,
///
///     V dD = D_s dS W V / sum(W V),   W = phi(r.n / h; m_n) phi(|r - (r.n) n| / h; m_t)
///
/// where D_s is the sheet's Darcy coefficient integrated along the normal, phi the cosine kernel
/// and the sum runs over the cells that the kernel reaches through faces from the nearest one: a
/// lumen on the other side of a thin wall gets nothing. So the sum of D V over the cells is the
/// integral of D_s over the sheet to round-off, also where the wall cuts the kernel off. F, the
/// area and the metal volume alike, the latter two for the whole device. The result does not depend
/// on the number of threads.
///
/// A stock solver's collocated scheme under-predicts the pressure drop of a thin layer. For a flat
/// sheet with dp = 10 times the dynamic pressure: 2.3 % for six cells across (m_n = 3), 1.1 % for
/// eight.
///
/// @throws GeometryError if a piece has no cell within the kernel: the mesh
/// does
///         not hold the device (another position or unit?)
CellResistance deposit(const ResistanceSheet& sheet, const FoamMesh& mesh,
                       const FoamDepositOptions& options = {});

/// Sum of D times the cell volume [m].
double resistance_integral(const CellResistance& resistance, const FoamMesh& mesh);

}  // namespace braidzone
