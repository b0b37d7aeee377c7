#pragma once

#include "core/wall_tree.hpp"
#include "export/foam_mesh.hpp"
#include "porous/resistance_sheet.hpp"

#include <string>
#include <vector>

namespace braidzone {

/// Resistance on the cells of a mesh; cells that the device does not touch are left out.
struct CellResistance {
    std::vector<int> cells;           ///< increasing
    std::vector<double> darcy;        ///< D along the normal [1/m^2]
    std::vector<double> forchheimer;  ///< F along the normal [1/m]
    std::vector<Vec3> normal;         ///< unit
    double tangential_ratio = 1.0;    ///< tangential over normal, D and F alike
    std::vector<std::string> warnings;
};

struct FoamDepositOptions {
    /// Half-width of the cosine kernel along the normal, over the local cell size V^(1/3).
    double kernel_half_width = 3.0;
};

/// Deposits the sheet's resistance onto a polyhedral mesh with the cosine kernel, normalised for
/// each piece of the sheet so that the sum over cells of D times the volume equals the sheet's
/// resistance integral.
/// @throws GeometryError if a piece of the acting sheet has no cell within the kernel: the mesh does
///         not hold the device (another position or unit?)
CellResistance deposit(const ResistanceSheet& sheet, const FoamMesh& mesh,
                       const FoamDepositOptions& options = {});

/// Sum of D times the cell volume [m].
double resistance_integral(const CellResistance& resistance, const FoamMesh& mesh);

}  // namespace braidzone
