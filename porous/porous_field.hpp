#pragma once

#include "core/fluid.hpp"
#include "core/vessel.hpp"
#include "porous/resistance_sheet.hpp"
#include "porous/voxel_grid.hpp"
#include "porous/voxel_wall_distance.hpp"

#include <cstdint>
#include <vector>

namespace braidzone {

enum class CellType : std::uint8_t {
    outside = 0,  ///< centre not in the lumen
    fluid = 1,
    porous = 2,  ///< in the lumen, with resistance
};

/// The device's resistance in voxels: coefficients for those that the device touches, cube by cube
/// of `VoxelCubes`; wall distances near the device and the wall. Memory grows with the areas of
/// both over the spacing squared.
///
/// The momentum sink is S = -(mu D + 1/2 rho F |U|) U with
/// D = D_n n n^T + D_t (I - n n^T), D_t = tangential_ratio.linear D_n, and F alike with the
/// quadratic ratio.
struct PorousField {
    VoxelGrid grid;
    VoxelWallDistance wall_distance;  ///< [m], negative in the lumen

    std::vector<std::int64_t> voxels;        ///< indices of the voxels that the device touches
    std::vector<double> void_fraction;       ///< 1 - metal volume / voxel volume [-]
    std::vector<double> surface_density;     ///< device area per volume [1/m]
    std::vector<double> darcy_normal;        ///< D_n [1/m^2]
    std::vector<double> forchheimer_normal;  ///< F_n [1/m]
    std::vector<Vec3> normal;                ///< unit mean normal, out of the lumen

    TangentialRatio tangential_ratio;
    Fluid fluid;
};

/// Whether a touched voxel resists the flow.
CellType cell_type(const PorousField& field, std::size_t touched);

/// Tangential coefficients of the touched voxels: D_t [1/m^2], F_t [1/m].
std::vector<double> darcy_tangential(const PorousField& field);
std::vector<double> forchheimer_tangential(const PorousField& field);

/// The sheet's own constants in the touched voxels, mean over the device's area there:
///
///     a = mu D_n / surface_density [Pa s/m],   b = rho F_n / (2 surface_density) [Pa s^2/m^2]
///
/// With the normal and the surface density they are what a solver needs to form its coefficients
/// anew on a grid of its own: D_n = a S / (mu V), whatever S / V becomes there.
std::vector<double> pressure_loss_linear(const PorousField& field);
std::vector<double> pressure_loss_quadratic(const PorousField& field);

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
/// @throws ConfigError if the spacing or the kernel is not positive or the grid would exceed 1e11
///         voxels, or 1e9 on the device; GeometryError if a piece of the sheet has no fluid voxel
///         within the kernel
PorousField deposit(const ResistanceSheet& sheet, const Vessel& vessel,
                    const DepositOptions& options = {});

/// Sum of the normal Darcy coefficient times the voxel volume [m].
double resistance_integral(const PorousField& field);

/// Sum of the metal volume over the voxels [m^3].
double metal_volume(const PorousField& field);

}  // namespace braidzone
