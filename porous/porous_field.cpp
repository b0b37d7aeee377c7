#include "porous/porous_field.hpp"

#include "core/error.hpp"
#include "porous/deposit_kernel.hpp"
#include "porous/voxel_wall_distance.hpp"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace braidzone {

namespace {

/// More voxels than that hold neither in the memory of a workstation nor in a solver's.
constexpr double most_voxels = 2e9;
/// Voxels around the kernel, so that the wall beside the device lies within the grid.
constexpr int margin = 3;
/// Longest edge of a piece of the sheet, over the spacing.
constexpr double piece_edge = 0.5;
/// Rhombi whose shares are held at once. Fixed, and they are added up in order, so that the sums do
/// not depend on the threads.
constexpr std::size_t batch_size = 2048;

/// Area of a rhombus that falls to a voxel.
struct Share {
    std::int64_t voxel = 0;
    double area = 0.0;  ///< [m^2]
};

struct RhombusShares {
    std::vector<Share> shares;
    const SheetPiece* lost_piece = nullptr;  ///< one without a fluid voxel, if any
};

/// What a voxel received: integrals over the sheet.
struct VoxelSums {
    std::int64_t voxel = 0;
    double area = 0.0;
    double metal = 0.0;
    double darcy = 0.0;
    double forchheimer = 0.0;
    Vec3 normal = Vec3::Zero();
};

VoxelGrid make_grid(const BraidSurface& surface, const DepositOptions& options)
{
    if (!(options.spacing > 0.0)) {
        throw ConfigError(
            fmt::format("grid.spacing = {:.6g} m: must be positive", options.spacing));
    }
    if (options.kernel_half_width < 1) {
        throw ConfigError(
            fmt::format("half-width of the deposition kernel {} voxels: must be 1 or "
                        "more",
                        options.kernel_half_width));
    }
    Vec3 lower = surface.points.at(0), upper = lower;
    for (const Vec3& point : surface.points) {
        lower = lower.cwiseMin(point);
        upper = upper.cwiseMax(point);
    }
    const Vec3 room = Vec3::Constant(options.kernel_half_width + margin);
    const Vec3 first = (lower / options.spacing).array().floor().matrix() - room;
    const Vec3 last = (upper / options.spacing).array().ceil().matrix() + room;
    const Vec3 count = last - first + Vec3::Ones();
    if (!(count.prod() <= most_voxels)) {
        throw ConfigError(fmt::format(
            "grid.spacing = {:.6g} mm gives {:.6g} x {:.6g} x {:.6g} voxels around the device; at "
            "most {:.6g} in all are allowed",
            1e3 * options.spacing, count[0], count[1], count[2], most_voxels));
    }
    VoxelGrid grid;
    grid.spacing = options.spacing;
    grid.origin = options.spacing * first;
    grid.dims = {static_cast<int>(count[0]), static_cast<int>(count[1]),
                 static_cast<int>(count[2])};
    return grid;
}

/// Index after the last piece of each rhombus; the pieces are in the order of the rhombi.
std::vector<std::size_t> piece_ends(const std::vector<SheetPiece>& pieces, std::size_t num_rhombi)
{
    std::vector<std::size_t> ends(num_rhombi, 0);
    for (const SheetPiece& piece : pieces)
        ++ends[static_cast<std::size_t>(piece.rhombus)];
    std::partial_sum(ends.begin(), ends.end(), ends.begin());
    return ends;
}

/// Kernel weights of a point along one axis: those of `weights.size()` voxels from `first` on.
struct AxisWeights {
    int first = 0;
    std::vector<double> weights;
};

void evaluate_kernel(AxisWeights& axis, double position, int half_width)
{
    axis.first = static_cast<int>(std::floor(position)) - half_width + 1;
    for (std::size_t i = 0; i < axis.weights.size(); ++i) {
        axis.weights[i] = cosine_kernel(position - axis.first - static_cast<double>(i), half_width);
    }
}

/// Spreads the pieces of one rhombus over the fluid voxels around them.
RhombusShares spread(const SheetPiece* first_piece, const SheetPiece* end_piece,
                     const VoxelGrid& grid, const std::vector<CellType>& cell_type, int half_width)
{
    // A box of voxels that holds the kernels of all pieces.
    Vec3 lower = first_piece->position, upper = lower;
    for (const SheetPiece* piece = first_piece; piece != end_piece; ++piece) {
        lower = lower.cwiseMin(piece->position);
        upper = upper.cwiseMax(piece->position);
    }
    lower = (lower - grid.origin) / grid.spacing;
    upper = (upper - grid.origin) / grid.spacing;
    std::array<int, 3> box_first{}, box_size{};
    for (int axis = 0; axis < 3; ++axis) {
        const auto a = static_cast<std::size_t>(axis);
        box_first[a] = static_cast<int>(std::floor(lower[axis])) - half_width + 1;
        box_size[a] = static_cast<int>(std::floor(upper[axis])) + half_width + 1 - box_first[a];
    }
    const auto box_index = [&](int i, int j, int k) {
        return static_cast<std::size_t>(
            i - box_first[0] + box_size[0] * (j - box_first[1] + box_size[1] * (k - box_first[2])));
    };
    std::vector<double> area(static_cast<std::size_t>(box_size[0] * box_size[1] * box_size[2]),
                             0.0);

    RhombusShares result;
    const int width = 2 * half_width;
    std::array<AxisWeights, 3> kernel;
    for (AxisWeights& axis : kernel)
        axis.weights.resize(static_cast<std::size_t>(width));
    std::vector<std::pair<std::size_t, double>> weights;
    for (const SheetPiece* piece = first_piece; piece != end_piece; ++piece) {
        const Vec3 position = (piece->position - grid.origin) / grid.spacing;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            evaluate_kernel(kernel[axis], position[static_cast<int>(axis)], half_width);
        }
        weights.clear();
        double sum = 0.0;
        for (int c = 0; c < width; ++c) {
            for (int b = 0; b < width; ++b) {
                const int j = kernel[1].first + b, k = kernel[2].first + c;
                const double plane_weight = kernel[1].weights[static_cast<std::size_t>(b)] *
                                            kernel[2].weights[static_cast<std::size_t>(c)];
                for (int a = 0; a < width; ++a) {
                    const int i = kernel[0].first + a;
                    const double weight =
                        plane_weight * kernel[0].weights[static_cast<std::size_t>(a)];
                    if (weight > 0.0 && cell_type[grid.index(i, j, k)] == CellType::fluid) {
                        weights.emplace_back(box_index(i, j, k), weight);
                        sum += weight;
                    }
                }
            }
        }
        if (!(sum > 0.0)) {
            result.lost_piece = piece;
            return result;
        }
        for (const auto& [voxel, weight] : weights)
            area[voxel] += piece->area * weight / sum;
    }

    for (int k = box_first[2]; k < box_first[2] + box_size[2]; ++k) {
        for (int j = box_first[1]; j < box_first[1] + box_size[1]; ++j) {
            for (int i = box_first[0]; i < box_first[0] + box_size[0]; ++i) {
                const double share = area[box_index(i, j, k)];
                if (share > 0.0) {
                    result.shares.push_back(
                        {static_cast<std::int64_t>(grid.index(i, j, k)), share});
                }
            }
        }
    }
    return result;
}

[[noreturn]] void report_lost_piece(const SheetPiece& piece, const DepositOptions& options)
{
    throw GeometryError(fmt::format(
        "the device has no lumen around it at ({:.6g}, {:.6g}, {:.6g}) mm, rhombus {}: no voxel "
        "centre within {} voxels of {:.6g} mm lies in the vessel; a smaller grid.spacing helps if "
        "the device is there",
        1e3 * piece.position[0], 1e3 * piece.position[1], 1e3 * piece.position[2], piece.rhombus,
        options.kernel_half_width, 1e3 * options.spacing));
}

/// Adds up what every voxel receives; voxels by increasing index.
std::vector<VoxelSums> sum_over_sheet(const ResistanceSheet& sheet, const VoxelGrid& grid,
                                      const std::vector<CellType>& cell_type,
                                      const DepositOptions& options)
{
    const BraidSurface& surface = sheet.surface;
    const std::vector<SheetPiece> pieces = cut_into_pieces(surface, piece_edge * grid.spacing);
    const std::vector<std::size_t> ends = piece_ends(pieces, surface.rhombi.size());

    constexpr std::int32_t untouched = -1;
    std::vector<std::int32_t> slot_of_voxel(grid.num_voxels(), untouched);
    std::vector<VoxelSums> sums;
    std::vector<RhombusShares> batch;
    for (std::size_t first = 0; first < surface.rhombi.size(); first += batch_size) {
        batch.assign(std::min(batch_size, surface.rhombi.size() - first), {});
        tbb::parallel_for(std::size_t{0}, batch.size(), [&](std::size_t i) {
            const std::size_t rhombus = first + i;
            batch[i] =
                spread(pieces.data() + (rhombus == 0 ? 0 : ends[rhombus - 1]),
                       pieces.data() + ends[rhombus], grid, cell_type, options.kernel_half_width);
        });
        for (std::size_t i = 0; i < batch.size(); ++i) {
            const std::size_t rhombus = first + i;
            if (batch[i].lost_piece != nullptr) report_lost_piece(*batch[i].lost_piece, options);
            const double metal_per_area =
                metal_volume(surface, rhombus) / surface.rhombi[rhombus].area;
            const double darcy = sheet_darcy(sheet, static_cast<int>(rhombus));
            const double forchheimer = sheet_forchheimer(sheet, static_cast<int>(rhombus));
            for (const Share& share : batch[i].shares) {
                std::int32_t& slot = slot_of_voxel[static_cast<std::size_t>(share.voxel)];
                if (slot == untouched) {
                    slot = static_cast<std::int32_t>(sums.size());
                    sums.push_back({.voxel = share.voxel});
                }
                VoxelSums& voxel = sums[static_cast<std::size_t>(slot)];
                voxel.area += share.area;
                voxel.metal += share.area * metal_per_area;
                voxel.darcy += share.area * darcy;
                voxel.forchheimer += share.area * forchheimer;
                voxel.normal += share.area * surface.normals[rhombus];
            }
        }
    }
    std::sort(sums.begin(), sums.end(),
              [](const VoxelSums& a, const VoxelSums& b) { return a.voxel < b.voxel; });
    return sums;
}

}  // namespace

PorousField deposit(const ResistanceSheet& sheet, const Vessel& vessel,
                    const DepositOptions& options)
{
    PorousField field;
    field.grid = make_grid(sheet.surface, options);
    field.wall_distance = voxel_wall_distance(field.grid, vessel);
    field.cell_type.reserve(field.wall_distance.size());
    for (const float distance : field.wall_distance) {
        field.cell_type.push_back(distance < 0.0F ? CellType::fluid : CellType::outside);
    }

    const std::vector<VoxelSums> sums = sum_over_sheet(sheet, field.grid, field.cell_type, options);
    const double voxel_volume = std::pow(field.grid.spacing, 3);
    for (const VoxelSums& voxel : sums) {
        field.voxels.push_back(voxel.voxel);
        field.void_fraction.push_back(1.0 - voxel.metal / voxel_volume);
        field.surface_density.push_back(voxel.area / voxel_volume);
        field.darcy_normal.push_back(voxel.darcy / voxel_volume);
        field.darcy_tangential.push_back(sheet.tangential_ratio * voxel.darcy / voxel_volume);
        field.forchheimer_normal.push_back(voxel.forchheimer / voxel_volume);
        // Two sheets back to back cancel; Eigen leaves a zero vector as it is.
        field.normal.push_back(voxel.normal.normalized());
        if (voxel.darcy > 0.0 || voxel.forchheimer > 0.0) {
            field.cell_type[static_cast<std::size_t>(voxel.voxel)] = CellType::porous;
        }
    }
    return field;
}

double resistance_integral(const PorousField& field)
{
    const double sum = std::accumulate(field.darcy_normal.begin(), field.darcy_normal.end(), 0.0);
    return sum * std::pow(field.grid.spacing, 3);
}

double metal_volume(const PorousField& field)
{
    double sum = 0.0;
    for (const double void_fraction : field.void_fraction)
        sum += 1.0 - void_fraction;
    return sum * std::pow(field.grid.spacing, 3);
}

}  // namespace braidzone
