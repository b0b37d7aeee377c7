#include "export/foam_resistance.hpp"

#include "core/error.hpp"
#include "export/foam_cell_search.hpp"
#include "porous/deposit_kernel.hpp"

#include <fmt/format.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace braidzone {

namespace {

/// The mesh with what a deposit asks of it.
struct SearchableMesh {
    const FoamMesh& mesh;
    CellSearch search;
    std::vector<std::vector<int>> neighbours;

    explicit SearchableMesh(const FoamMesh& m) : mesh(m), search(m), neighbours(cell_neighbours(m))
    {
    }
    const Vec3& centre(int cell) const { return mesh.cell_centres[static_cast<std::size_t>(cell)]; }
    double volume(int cell) const { return mesh.cell_volumes[static_cast<std::size_t>(cell)]; }
    const std::vector<int>& beside(int cell) const
    {
        return neighbours[static_cast<std::size_t>(cell)];
    }
    /// The largest cube root of the volume of the cell and its neighbours [m].
    double local_size(int cell) const
    {
        double largest = volume(cell);
        for (const int other : beside(cell))
            largest = std::max(largest, volume(other));
        return std::cbrt(largest);
    }
};

/// A cell that the kernel reaches, with its share of the piece; shares sum to 1.
struct Share {
    int cell = -1;
    double fraction = 0.0;
};

/// The kernel around one piece of the sheet.
struct Kernel {
    Vec3 position = Vec3::Zero();
    Vec3 normal = Vec3::UnitX();
    double size = 0.0;  ///< h [m]
    FoamDepositOptions half_width;

    double weight(const Vec3& centre) const
    {
        const Vec3 r = (centre - position) / size;
        const double along = r.dot(normal);
        return cosine_kernel(along, half_width.kernel_half_width) *
               cosine_kernel((r - along * normal).norm(), half_width.tangential_half_width);
    }
};

/// Which cells a search has been to; each thread has its own.
struct Visited {
    std::vector<int> search_of_cell;
    int search = 0;
};

/// The cells that the kernel reaches from `start` through faces.
std::vector<Share> spread(const SearchableMesh& mesh, const Kernel& kernel, int start,
                          Visited& visited)
{
    ++visited.search;
    std::vector<Share> shares;
    const auto visit = [&](int cell) {
        int& search = visited.search_of_cell[static_cast<std::size_t>(cell)];
        if (std::exchange(search, visited.search) == visited.search) return;
        const double weight = kernel.weight(mesh.centre(cell)) * mesh.volume(cell);
        if (weight > 0.0) shares.push_back({cell, weight});
    };
    visit(start);
    for (std::size_t next = 0; next < shares.size(); ++next)
        for (const int cell : mesh.beside(shares[next].cell))
            visit(cell);

    double sum = 0.0;
    for (const Share& share : shares)
        sum += share.fraction;
    for (Share& share : shares)
        share.fraction /= sum;
    return shares;
}

/// What the cells collect: volume integrals of the coefficients, and the mean normal.
struct Collected {
    double area = 0.0;         ///< of the device, whether it acts or not [m^2]
    double metal = 0.0;        ///< [m^3]
    double darcy = 0.0;        ///< D V [m]
    double forchheimer = 0.0;  ///< F V [m^2]
    Vec3 normal = Vec3::Zero();

    void add(double darcy_part, double forchheimer_part, const Vec3& vector_area)
    {
        darcy += darcy_part;
        forchheimer += forchheimer_part;
        // Two sheets that face each other have one direction, not none.
        normal += normal.dot(vector_area) < 0.0 ? Vec3(-vector_area) : vector_area;
    }
};

[[noreturn]] void refuse(const SheetPiece& piece, const SearchableMesh& mesh)
{
    const int nearest = mesh.search.nearest(piece.position);
    Vec3 lower = mesh.centre(0), upper = mesh.centre(0);
    for (const Vec3& centre : mesh.mesh.cell_centres) {
        lower = lower.cwiseMin(centre);
        upper = upper.cwiseMax(centre);
    }
    const Vec3& p = piece.position;
    throw GeometryError(fmt::format(
        "the mesh does not hold the device: rhombus {} at ({:.6g}, {:.6g}, {:.6g}) m is {:.6g} m "
        "from the nearest cell centre; the mesh reaches from ({:.6g}, {:.6g}, {:.6g}) to "
        "({:.6g}, {:.6g}, {:.6g}) m. OpenFOAM meshes are in metres, at the vessel's position",
        piece.rhombus, p.x(), p.y(), p.z(), (mesh.centre(nearest) - p).norm(), lower.x(), lower.y(),
        lower.z(), upper.x(), upper.y(), upper.z()));
}

/// The smallest local cell size around a rhombus [m].
double finest_size(const BraidSurface& surface, std::size_t rhombus, const SearchableMesh& mesh)
{
    double finest = mesh.local_size(mesh.search.nearest(surface.centres[rhombus]));
    for (const int corner : surface.corners[rhombus]) {
        const Vec3& point = surface.points[static_cast<std::size_t>(corner)];
        finest = std::min(finest, mesh.local_size(mesh.search.nearest(point)));
    }
    return finest;
}

/// Rhombi whose shares are held at once. Fixed, and they are added up in order, so that the sums do
/// not depend on the threads.
constexpr std::size_t batch_size = 1024;

/// Longest edge of a piece of the sheet, over the local cell size.
constexpr double piece_edge = 0.5;

/// Area of one rhombus that falls to cells.
struct RhombusShares {
    std::vector<std::pair<int, double>> areas;  ///< cell and area [m^2]; a cell may come repeatedly
    double coarse_area = 0.0;                   ///< with too few cells across the kernel [m^2]
    double area_times_cells = 0.0;              ///< area times cells across the kernel [m^2]
    std::optional<SheetPiece> lost_piece;       ///< one without a cell, if any
};

RhombusShares share_out(const BraidSurface& surface, std::size_t rhombus,
                        const SearchableMesh& mesh, const FoamDepositOptions& options,
                        Visited& visited)
{
    RhombusShares result;
    const double edge = piece_edge * finest_size(surface, rhombus, mesh);
    for (const SheetPiece& piece : cut_into_pieces(surface, rhombus, edge)) {
        const int start = mesh.search.nearest(piece.position);
        const Kernel kernel{piece.position, surface.normals[rhombus], mesh.local_size(start),
                            options};
        const std::vector<Share> shares = spread(mesh, kernel, start, visited);
        if (shares.empty()) {
            result.lost_piece = piece;
            return result;
        }
        double largest_volume = 0.0;
        for (const Share& share : shares) {
            result.areas.emplace_back(share.cell, share.fraction * piece.area);
            largest_volume = std::max(largest_volume, mesh.volume(share.cell));
        }
        const double cells_across =
            2.0 * options.kernel_half_width * kernel.size / std::cbrt(largest_volume);
        if (cells_across < 4.0) result.coarse_area += piece.area;
        result.area_times_cells += piece.area * cells_across;
    }
    return result;
}

/// Lists what the cells collected.
void add_cells(CellResistance& result, const std::vector<Collected>& collected,
               const FoamMesh& mesh)
{
    for (std::size_t cell = 0; cell < collected.size(); ++cell) {
        const Collected& sum = collected[cell];
        const double volume = mesh.cell_volumes[cell];
        if (sum.area > 0.0) {
            result.metal.cells.push_back(static_cast<int>(cell));
            result.metal.void_fraction.push_back(1.0 - sum.metal / volume);
            result.metal.surface_density.push_back(sum.area / volume);
        }
        if (sum.normal.norm() > 0.0) {
            result.cells.push_back(static_cast<int>(cell));
            result.darcy.push_back(sum.darcy / volume);
            result.forchheimer.push_back(sum.forchheimer / volume);
            result.normal.push_back(sum.normal.normalized());
        }
    }
}

}  // namespace

CellResistance deposit(const ResistanceSheet& sheet, const FoamMesh& mesh,
                       const FoamDepositOptions& options)
{
    if (!(options.kernel_half_width >= 1.0) || !(options.tangential_half_width >= 1.0))
        throw InputError(
            fmt::format("kernel half-widths of {:.6g} and {:.6g} cells; allowed: 1 or more",
                        options.kernel_half_width, options.tangential_half_width));
    CellResistance result;
    result.tangential_ratio = sheet.tangential_ratio;

    const SearchableMesh searchable(mesh);
    const BraidSurface& surface = sheet.surface;
    std::vector<Collected> collected(mesh.cell_volumes.size());
    tbb::enumerable_thread_specific<Visited> visited(
        Visited{std::vector<int>(mesh.cell_volumes.size(), 0), 0});
    double area = 0.0, coarse_area = 0.0;
    std::vector<RhombusShares> batch;
    for (std::size_t first = 0; first < surface.rhombi.size(); first += batch_size) {
        batch.assign(std::min(batch_size, surface.rhombi.size() - first), {});
        tbb::parallel_for(std::size_t{0}, batch.size(), [&](std::size_t i) {
            batch[i] = share_out(surface, first + i, searchable, options, visited.local());
        });
        for (std::size_t i = 0; i < batch.size(); ++i) {
            const std::size_t rhombus = first + i;
            if (batch[i].lost_piece) refuse(*batch[i].lost_piece, searchable);
            const double metal_per_area =
                metal_volume(surface, rhombus) / surface.rhombi[rhombus].area;
            const double darcy = sheet_darcy(sheet, static_cast<int>(rhombus));
            const double forchheimer = sheet_forchheimer(sheet, static_cast<int>(rhombus));
            const Vec3 acting_normal = sheet.acting[rhombus] * surface.normals[rhombus];
            for (const auto& [cell, share] : batch[i].areas) {
                Collected& sum = collected[static_cast<std::size_t>(cell)];
                sum.area += share;
                sum.metal += share * metal_per_area;
                sum.add(share * darcy, share * forchheimer, share * acting_normal);
            }
            if (!(sheet.acting[rhombus] > 0.0)) continue;
            area += surface.rhombi[rhombus].area;
            coarse_area += batch[i].coarse_area;
            result.cells_across += batch[i].area_times_cells;
        }
    }
    if (area > 0.0) result.cells_across /= area;
    add_cells(result, collected, mesh);
    if (coarse_area > 0.05 * area)
        result.warnings.push_back(
            fmt::format("the mesh has fewer than 4 cells across the kernel over {:.3g} % of the "
                        "device's free area; the pressure drop comes out too low (by how much: "
                        "thin_layer_error in fd_export.json)",
                        100.0 * coarse_area / area));
    return result;
}

double resistance_integral(const CellResistance& resistance, const FoamMesh& mesh)
{
    double sum = 0.0;
    for (std::size_t i = 0; i < resistance.cells.size(); ++i)
        sum +=
            resistance.darcy[i] * mesh.cell_volumes[static_cast<std::size_t>(resistance.cells[i])];
    return sum;
}

}  // namespace braidzone
