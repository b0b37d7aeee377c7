#include "porous/porous_field.hpp"

#include "core/error.hpp"
#include "porous/deposit_kernel.hpp"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <optional>

namespace braidzone {

namespace {

/// Beyond these the table of cubes, or the voxels around the device, fill a workstation's memory.
constexpr double most_voxels = 1e11;
constexpr double most_held_voxels = 1e9;
/// Voxels around the kernel, so that the wall beside the device lies within the grid.
constexpr int margin = 3;
/// Longest edge of a piece of the sheet, over the spacing.
constexpr double piece_edge = 0.5;
/// Rhombi whose shares are held at once. Fixed, and they are added up in order, so that the sums do
/// not depend on the threads.
constexpr std::size_t batch_size = 2048;

/// Area of a rhombus that falls to a voxel.
struct Share {
    int i = 0, j = 0, k = 0;
    double area = 0.0;  ///< [m^2]
};

struct RhombusShares {
    std::vector<Share> shares;
    std::optional<SheetPiece> lost_piece;  ///< one without a fluid voxel, if any
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

/// A box of voxels around a rhombus that holds the kernels of all its pieces.
struct VoxelBox {
    std::array<int, 3> first{};
    std::array<int, 3> size{};

    int index(int i, int j, int k) const
    {
        return i - first[0] + size[0] * (j - first[1] + size[1] * (k - first[2]));
    }
    std::size_t num_voxels() const { return static_cast<std::size_t>(size[0] * size[1] * size[2]); }
};

VoxelBox box_around(const BraidSurface& surface, std::size_t rhombus, const VoxelGrid& grid,
                    int half_width)
{
    const auto corner = [&](std::size_t i) -> const Vec3& {
        return surface.points[static_cast<std::size_t>(surface.corners[rhombus][i])];
    };
    Vec3 lower = corner(0), upper = lower;
    for (std::size_t i = 1; i < 4; ++i) {
        lower = lower.cwiseMin(corner(i));
        upper = upper.cwiseMax(corner(i));
    }
    // A piece in a plane of voxel centres must not fall out of the box by round-off.
    const Vec3 slack = Vec3::Constant(1e-6);
    lower = (lower - grid.origin) / grid.spacing - slack;
    upper = (upper - grid.origin) / grid.spacing + slack;
    VoxelBox box;
    for (int axis = 0; axis < 3; ++axis) {
        const auto a = static_cast<std::size_t>(axis);
        box.first[a] = static_cast<int>(std::floor(lower[axis])) - half_width + 1;
        box.size[a] = static_cast<int>(std::floor(upper[axis])) + half_width + 1 - box.first[a];
    }
    return box;
}

CubeMarks cubes_around(const BraidSurface& surface, const VoxelGrid& grid, int half_width)
{
    CubeMarks marks(grid);
    for (std::size_t rhombus = 0; rhombus < surface.rhombi.size(); ++rhombus) {
        const VoxelBox box = box_around(surface, rhombus, grid, half_width);
        std::array<int, 3> last{};
        for (std::size_t axis = 0; axis < 3; ++axis)
            last[axis] = box.first[axis] + box.size[axis] - 1;
        marks.mark(box.first, last);
    }
    const double held =
        static_cast<double>(VoxelCubes::volume) * static_cast<double>(marks.num_marked());
    if (!(held <= most_held_voxels)) {
        throw ConfigError(fmt::format(
            "grid.spacing = {:.6g} mm gives {:.6g} voxels on the device; at most {:.6g} are "
            "allowed",
            1e3 * grid.spacing, held, most_held_voxels));
    }
    return marks;
}

/// Spreads the pieces of one rhombus over the fluid voxels around them.
RhombusShares spread(const BraidSurface& surface, std::size_t rhombus, const VoxelGrid& grid,
                     const VoxelWallDistance& wall_distance, int half_width)
{
    const VoxelBox box = box_around(surface, rhombus, grid, half_width);
    const auto for_each_voxel = [&](const auto& visit) {
        for (int k = box.first[2]; k < box.first[2] + box.size[2]; ++k)
            for (int j = box.first[1]; j < box.first[1] + box.size[1]; ++j)
                for (int i = box.first[0]; i < box.first[0] + box.size[0]; ++i)
                    visit(i, j, k);
    };
    std::vector<double> is_fluid, area(box.num_voxels(), 0.0);  // 1 in the lumen, 0 elsewhere
    is_fluid.reserve(box.num_voxels());
    for_each_voxel([&](int i, int j, int k) {
        is_fluid.push_back(distance_at(wall_distance, i, j, k) < 0.0F ? 1.0 : 0.0);
    });

    RhombusShares result;
    const int width = 2 * half_width;
    CosineWeights along_x(half_width), along_y(half_width), along_z(half_width);
    std::vector<double> weights(static_cast<std::size_t>(width * width * width));
    for (const SheetPiece& piece : cut_into_pieces(surface, rhombus, piece_edge * grid.spacing)) {
        const Vec3 position = (piece.position - grid.origin) / grid.spacing;
        along_x.evaluate(position.x());
        along_y.evaluate(position.y());
        along_z.evaluate(position.z());
        double sum = 0.0;
        double* weight = weights.data();
        for (int c = 0; c < width; ++c) {
            for (int b = 0; b < width; ++b) {
                const double of_row = along_y[b] * along_z[c];
                const double* fluid =
                    is_fluid.data() +
                    box.index(along_x.first(), along_y.first() + b, along_z.first() + c);
                for (int a = 0; a < width; ++a) {
                    *weight = of_row * along_x[a] * fluid[a];
                    sum += *weight++;
                }
            }
        }
        if (!(sum > 0.0)) {
            result.lost_piece = piece;
            return result;
        }
        const double area_per_weight = piece.area / sum;
        weight = weights.data();
        for (int c = 0; c < width; ++c) {
            for (int b = 0; b < width; ++b) {
                double* row = area.data() +
                              box.index(along_x.first(), along_y.first() + b, along_z.first() + c);
                for (int a = 0; a < width; ++a)
                    row[a] += area_per_weight * *weight++;
            }
        }
    }
    for_each_voxel([&](int i, int j, int k) {
        const double share = area[static_cast<std::size_t>(box.index(i, j, k))];
        if (share > 0.0) result.shares.push_back({i, j, k, share});
    });
    return result;
}

[[noreturn]] void report_lost_piece(const SheetPiece& piece, const DepositOptions& options)
{
    throw GeometryError(fmt::format(
        "the device has no lumen around it at ({:.6g}, {:.6g}, {:.6g}) mm, rhombus {}: no voxel "
        "centre within {} voxels of {:.6g} mm lies in the vessel. If the device is there: a "
        "smaller "
        "grid.spacing where that is coarse against the lumen, a larger grid.kernel_half_width "
        "where "
        "it is so fine that the braid's facets stand out of the wall",
        1e3 * piece.position[0], 1e3 * piece.position[1], 1e3 * piece.position[2], piece.rhombus,
        options.kernel_half_width, 1e3 * options.spacing));
}

/// Adds up what every voxel receives; voxels cube by cube.
std::vector<VoxelSums> sum_over_sheet(const ResistanceSheet& sheet, const VoxelGrid& grid,
                                      const VoxelWallDistance& wall_distance,
                                      const DepositOptions& options)
{
    const BraidSurface& surface = sheet.surface;
    const VoxelCubes& cubes = wall_distance.cubes;
    constexpr std::int32_t untouched = -1;
    std::vector<std::int32_t> place_of_voxel(cubes.num_held_voxels(), untouched);
    std::vector<VoxelSums> sums;
    std::vector<RhombusShares> batch;
    for (std::size_t first = 0; first < surface.rhombi.size(); first += batch_size) {
        batch.assign(std::min(batch_size, surface.rhombi.size() - first), {});
        tbb::parallel_for(std::size_t{0}, batch.size(), [&](std::size_t i) {
            batch[i] = spread(surface, first + i, grid, wall_distance, options.kernel_half_width);
        });
        for (std::size_t i = 0; i < batch.size(); ++i) {
            const std::size_t rhombus = first + i;
            if (batch[i].lost_piece) report_lost_piece(*batch[i].lost_piece, options);
            const double metal_per_area =
                metal_volume(surface, rhombus) / surface.rhombi[rhombus].area;
            const double darcy = sheet_darcy(sheet, static_cast<int>(rhombus));
            const double forchheimer = sheet_forchheimer(sheet, static_cast<int>(rhombus));
            for (const Share& share : batch[i].shares) {
                std::int32_t& place = place_of_voxel[held_place(cubes, share.i, share.j, share.k)];
                if (place == untouched) {
                    place = static_cast<std::int32_t>(sums.size());
                    sums.push_back({.voxel = static_cast<std::int64_t>(
                                        grid.index(share.i, share.j, share.k))});
                }
                VoxelSums& voxel = sums[static_cast<std::size_t>(place)];
                voxel.area += share.area;
                voxel.metal += share.area * metal_per_area;
                voxel.darcy += share.area * darcy;
                voxel.forchheimer += share.area * forchheimer;
                voxel.normal += share.area * surface.normals[rhombus];
            }
        }
    }
    std::vector<VoxelSums> in_order;
    in_order.reserve(sums.size());
    for (const std::int32_t place : place_of_voxel)
        if (place != untouched) in_order.push_back(sums[static_cast<std::size_t>(place)]);
    return in_order;
}

}  // namespace

PorousField deposit(const ResistanceSheet& sheet, const Vessel& vessel,
                    const DepositOptions& options)
{
    PorousField field;
    field.grid = make_grid(sheet.surface, options);
    field.tangential_ratio = sheet.tangential_ratio;
    field.fluid = sheet.fluid;
    field.wall_distance = voxel_wall_distance(
        field.grid, vessel, cubes_around(sheet.surface, field.grid, options.kernel_half_width));

    const std::vector<VoxelSums> sums =
        sum_over_sheet(sheet, field.grid, field.wall_distance, options);
    const double voxel_volume = std::pow(field.grid.spacing, 3);
    for (const VoxelSums& voxel : sums) {
        field.voxels.push_back(voxel.voxel);
        field.void_fraction.push_back(1.0 - voxel.metal / voxel_volume);
        field.surface_density.push_back(voxel.area / voxel_volume);
        field.darcy_normal.push_back(voxel.darcy / voxel_volume);
        field.forchheimer_normal.push_back(voxel.forchheimer / voxel_volume);
        // Two sheets back to back cancel; Eigen leaves a zero vector as it is.
        field.normal.push_back(voxel.normal.normalized());
    }
    return field;
}

CellType cell_type(const PorousField& field, std::size_t touched)
{
    const bool resists =
        field.darcy_normal[touched] > 0.0 || field.forchheimer_normal[touched] > 0.0;
    return resists ? CellType::porous : CellType::fluid;
}

namespace {

std::vector<double> scaled(const std::vector<double>& values, double factor)
{
    std::vector<double> result;
    result.reserve(values.size());
    for (const double value : values)
        result.push_back(factor * value);
    return result;
}

/// Values per volume over the device's area per volume.
std::vector<double> per_area(const PorousField& field, const std::vector<double>& values,
                             double factor)
{
    std::vector<double> result;
    result.reserve(values.size());
    for (std::size_t i = 0; i < values.size(); ++i)
        result.push_back(factor * values[i] / field.surface_density[i]);
    return result;
}

}  // namespace

std::vector<double> darcy_tangential(const PorousField& field)
{
    return scaled(field.darcy_normal, field.tangential_ratio.linear);
}

std::vector<double> forchheimer_tangential(const PorousField& field)
{
    return scaled(field.forchheimer_normal, field.tangential_ratio.quadratic);
}

std::vector<double> pressure_loss_linear(const PorousField& field)
{
    return per_area(field, field.darcy_normal, field.fluid.viscosity);
}

std::vector<double> pressure_loss_quadratic(const PorousField& field)
{
    return per_area(field, field.forchheimer_normal, 0.5 * field.fluid.density);
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
