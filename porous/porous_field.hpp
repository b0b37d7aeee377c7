#pragma once

#include "core/wall_tree.hpp"
#include "porous/resistance_sheet.hpp"

#include <array>
#include <cstdint>
#include <vector>

namespace braidzone {

/// A regular grid of cubic voxels. Voxel (i, j, k) has its centre at
/// origin + spacing (i, j, k) and index i + nx (j + ny k).
struct VoxelGrid {
    Vec3 origin = Vec3::Zero();  ///< centre of voxel (0, 0, 0) [m]
    double spacing = 0.0;        ///< [m]
    std::array<int, 3> dims{};   ///< nx, ny, nz

    Vec3 centre(int i, int j, int k) const { return origin + spacing * Vec3(i, j, k); }
    std::size_t num_voxels() const
    {
        return static_cast<std::size_t>(dims[0]) * static_cast<std::size_t>(dims[1]) *
               static_cast<std::size_t>(dims[2]);
    }
};

enum class CellType : std::uint8_t { outside = 0, fluid = 1, porous = 2 };

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
/// normalised over fluid voxels (centre in the lumen). phi sums to 1 over the integers for any
/// shift, so sums over voxels equal integrals over the sheet to round-off, and the integral along
/// the normal equals the sheet's value whatever the orientation, position and voxel size.
///
/// The result does not depend on the number of threads.
///
/// @throws ConfigError if the grid would exceed 2e9 voxels; GeometryError if a piece of the sheet
///         has no fluid voxel within the kernel
PorousField deposit(const ResistanceSheet& sheet, const WallTree& wall,
                    const DepositOptions& options = {});

/// Sum of the normal Darcy coefficient times the voxel volume [m].
double resistance_integral(const PorousField& field);

/// Sum of the metal volume over the voxels [m^3].
double metal_volume(const PorousField& field);

}  // namespace braidzone
