#pragma once

#include "export/foam_cell_zones.hpp"
#include "export/foam_porous_source.hpp"
#include "export/foam_resistance.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace braidzone {

/// The zone of every cell with resistance.
inline constexpr const char* per_cell_zone = "FD";

/// One direction of the resistance of every cell: the tensor c e1 e1^T.
struct FoamDirectedField {
    std::string name;                 ///< of the field, "fdNuD_x", ...
    Vec3 e1 = Vec3::UnitX();          ///< unit, the same in all cells
    std::vector<double> coefficient;  ///< c of each cell of the resistance [1/m^2]; may be negative
};

/// The linear resistance tensor of each cell as a sum over fixed directions,
///
///     D = D_n (r I + (1 - r) n n^T) = sum over k of c_k a_k a_k^T
///
/// with a_k = x, y, z, (x + y)/sqrt(2), (y + z)/sqrt(2), (x + z)/sqrt(2) and
///
///     c_x = D_xx - D_xy - D_xz,  c_y = D_yy - D_xy - D_yz,  c_z = D_zz - D_xz - D_yz,
///     c_xy = 2 D_xy,  c_yz = 2 D_yz,  c_xz = 2 D_xz
///
/// Exact: six directions span the symmetric tensors. Stock DarcyForchheimer takes its viscosity
/// from a field of any name, so a source along a_k with D = 1 and the field nu c_k in that place
/// has the tensor c_k a_k a_k^T in each cell; it is linear in D, so negative c_k do no harm.
/// Directions that are zero everywhere are left out: three remain for r = 1.
std::vector<FoamDirectedField> directed_fields(const CellResistance& resistance);

/// Sources of the fields on the zone "FD".
std::vector<FoamPorousSource> per_cell_sources(const std::vector<FoamDirectedField>& fields);

/// Writes nu c_k into the case's start fields.
/// @param viscosity  nu, kinematic [m^2/s]
/// @return the files, relative to the case
/// @throws IoError if one cannot be written
std::vector<std::filesystem::path> write_directed_fields(
    const std::filesystem::path& foam_case, const std::vector<FoamDirectedField>& fields,
    const CellResistance& resistance, const FoamMesh& mesh, double viscosity);

/// The fields that any call may have written, relative to the case.
std::vector<std::filesystem::path> directed_field_files(const std::filesystem::path& foam_case);

/// Function objects that read the fields at the start and write them with every time, without which
/// a restart would not find them.
std::string directed_field_functions(const std::vector<FoamDirectedField>& fields);

}  // namespace braidzone
