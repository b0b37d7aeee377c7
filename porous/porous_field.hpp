#pragma once

#include "core/vessel.hpp"
#include "porous/resistance_sheet.hpp"
#include "porous/voxel_grid.hpp"

#include <cstdint>
#include <vector>

namespace braidzone {

enum class CellType : std::uint8_t {
    outside = 0,  ///< centre not in the lumen
    fluid = 1,
    porous = 2,  ///< in the lumen, with resistance
};

/// The device's resistance in voxels. Coefficients are held for the voxels that the device
/// touches only, in the order of their index; the wall distance and the cell type for all.
///
/// The momentum sink is S = -(mu D + 1/2 rho F |U|) U with
/// D = darcy_normal n n^T + darcy_tangential (I - n n^T), F = forchheimer_normal alike.
struct PorousField {
    VoxelGrid grid;
    std::vector<float> wall_distance;  ///< to the wall [m], negative in the lumen; one a voxel
    std::vector<CellType> cell_type;   ///< one a voxel

    std::vector<std::int64_t> voxels;        ///< indices of the voxels that the device touches
    std::vector<double> void_fraction;       ///< 1 - metal volume / voxel volume [-]
    std::vector<double> surface_density;     ///< device area per volume [1/m]
    std::vector<double> darcy_normal;        ///< [1/m^2]
    std::vector<double> darcy_tangential;    ///< [1/m^2]
    std::vector<double> forchheimer_normal;  ///< [1/m]
    std::vector<Vec3> normal;                ///< unit mean normal, out of the lumen
};

struct DepositOptions {
    double spacing = 0.1e-3;    ///< voxel edge [m]
    int kernel_half_width = 2;  ///< in voxels; >= 1
};

/// Deposits the sheet's resistance and metal onto voxels.
///
/// Each rhombus is cut into pieces no larger than half a voxel; each piece gives its Darcy and
/// Forchheimer integrals, its area and its metal volume to the fluid voxels around it with weights
///
///     w = prod_i phi(r_i / h),  phi(r) = (1 + cos(pi r / m)) / (2 m)  for |r| < m,
///
/// normalised over fluid voxels (centre in the lumen), so that sums over voxels equal integrals
/// over the sheet to round-off. Because phi sums to 1 over the integers for any shift and
/// integrates to 1, the mean over a sheet of the integral along its normal is the sheet's value
/// whatever the orientation, position and voxel size; single lines scatter about it, less for a
/// wider kernel.
///
/// Metal, area and normal are deposited for the whole device, resistance where it acts. The grid
/// covers the device with a margin of the kernel and three voxels; its centres lie on multiples of
/// the spacing, so that the voxels of different devices in one vessel coincide.
///
/// The result does not depend on the number of threads.
///
/// @throws ConfigError if the spacing or the kernel is not positive or the grid would exceed 2e9
///         voxels; GeometryError if a piece of the sheet has no fluid voxel within the kernel
PorousField deposit(const ResistanceSheet& sheet, const Vessel& vessel,
                    const DepositOptions& options = {});

/// Sum of the normal Darcy coefficient times the voxel volume [m].
double resistance_integral(const PorousField& field);

/// Sum of the metal volume over the voxels [m^3].
double metal_volume(const PorousField& field);

}  // namespace braidzone
