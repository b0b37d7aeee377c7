#include "export/foam_resistance.hpp"

#include "core/error.hpp"
#include "export/foam_cell_search.hpp"
#include "porous/deposit_kernel.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
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

/// The cells that the kernel reaches from `start` through faces.
/// @param visited  per cell, the number of the last call that visited it
std::vector<Share> spread(const SearchableMesh& mesh, const Kernel& kernel, int start,
                          std::vector<int>& visited, int call)
{
    std::vector<Share> shares;
    const auto visit = [&](int cell) {
        if (std::exchange(visited[static_cast<std::size_t>(cell)], call) == call) return;
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
    double darcy = 0.0;        ///< D V [m]
    double forchheimer = 0.0;  ///< F V [m^2]
    Vec3 normal = Vec3::Zero();

    void add(double darcy_part, double forchheimer_part, const Vec3& area)
    {
        darcy += darcy_part;
        forchheimer += forchheimer_part;
        // Two sheets that face each other have one direction, not none.
        normal += normal.dot(area) < 0.0 ? Vec3(-area) : area;
    }
};

[[noreturn]] void refuse(const SheetPiece& piece, const SearchableMesh& mesh, int nearest)
{
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

/// The smallest local cell size along the acting sheet [m]; infinity if nothing acts.
double finest_size(const ResistanceSheet& sheet, const SearchableMesh& mesh)
{
    double finest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < sheet.acting.size(); ++i)
        if (sheet.acting[i] > 0.0)
            finest =
                std::min(finest, mesh.local_size(mesh.search.nearest(sheet.surface.centres[i])));
    return finest;
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
    const double finest = finest_size(sheet, searchable);
    if (!std::isfinite(finest)) return result;

    std::vector<Collected> collected(mesh.cell_volumes.size());
    std::vector<int> visited(mesh.cell_volumes.size(), -1);
    double area = 0.0, coarse_area = 0.0;
    const std::vector<SheetPiece> pieces = cut_into_pieces(sheet.surface, 0.5 * finest);
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        const SheetPiece& piece = pieces[i];
        const auto rhombus = static_cast<std::size_t>(piece.rhombus);
        if (!(sheet.acting[rhombus] > 0.0)) continue;

        const int start = searchable.search.nearest(piece.position);
        const Kernel kernel{piece.position, sheet.surface.normals[rhombus],
                            searchable.local_size(start), options};
        const auto shares = spread(searchable, kernel, start, visited, static_cast<int>(i));
        if (shares.empty()) refuse(piece, searchable, start);

        const double darcy = sheet_darcy(sheet, piece.rhombus) * piece.area;
        const double forchheimer = sheet_forchheimer(sheet, piece.rhombus) * piece.area;
        const Vec3 vector_area = sheet.acting[rhombus] * piece.area * kernel.normal;
        double largest_volume = 0.0;
        for (const Share& share : shares) {
            collected[static_cast<std::size_t>(share.cell)].add(
                share.fraction * darcy, share.fraction * forchheimer, share.fraction * vector_area);
            largest_volume = std::max(largest_volume, searchable.volume(share.cell));
        }
        const double cells_across =
            2.0 * options.kernel_half_width * kernel.size / std::cbrt(largest_volume);
        area += piece.area;
        if (cells_across < 4.0) coarse_area += piece.area;
    }

    for (std::size_t cell = 0; cell < collected.size(); ++cell) {
        const Collected& sum = collected[cell];
        if (!(sum.normal.norm() > 0.0)) continue;
        result.cells.push_back(static_cast<int>(cell));
        result.darcy.push_back(sum.darcy / mesh.cell_volumes[cell]);
        result.forchheimer.push_back(sum.forchheimer / mesh.cell_volumes[cell]);
        result.normal.push_back(sum.normal.normalized());
    }
    if (coarse_area > 0.05 * area)
        result.warnings.push_back(
            fmt::format("the mesh has fewer than 4 cells across the kernel over {:.3g} % of the "
                        "device's free area; the pressure drop will come out too low",
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
