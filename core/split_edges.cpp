#include "core/split_edges.hpp"

#include "core/mesh_topology.hpp"

#include <algorithm>
#include <array>
#include <numeric>
#include <utility>

namespace braidzone {

namespace {

constexpr double share_of_edge = 1e-4;

std::size_t at(int index)
{
    return static_cast<std::size_t>(index);
}

/// Rim edges by their triangle, and the points at their ends, sorted by x.
struct Rims {
    std::vector<std::vector<std::array<int, 2>>> edges;  ///< of each triangle; low and high point
    std::vector<int> points;
};

Rims rims_of(const TriangleMesh& mesh)
{
    Rims rims;
    rims.edges.resize(mesh.triangles.size());
    for_each_edge(sorted_sides(mesh), [&](auto first, auto last) {
        if (last - first != 1) return;
        rims.edges[at(first->triangle)].push_back({first->low, first->high});
        rims.points.insert(rims.points.end(), {first->low, first->high});
    });
    std::sort(rims.points.begin(), rims.points.end());
    rims.points.erase(std::unique(rims.points.begin(), rims.points.end()), rims.points.end());
    std::sort(rims.points.begin(), rims.points.end(),
              [&](int a, int b) { return mesh.points[at(a)].x() < mesh.points[at(b)].x(); });
    return rims;
}

/// Points of the rims that lie on an edge, from its first end on.
std::vector<int> points_on(const TriangleMesh& mesh, const Rims& rims, int first, int second)
{
    const Vec3& start = mesh.points[at(first)];
    const Vec3 along = mesh.points[at(second)] - start;
    const double length = along.norm(), tolerance = share_of_edge * length;
    if (!(length > 0.0)) return {};
    const double lowest = std::min(start.x(), start.x() + along.x()) - tolerance;
    const double highest = std::max(start.x(), start.x() + along.x()) + tolerance;
    std::vector<std::pair<double, int>> found;
    auto point = std::lower_bound(
        rims.points.begin(), rims.points.end(), lowest,
        [&](int candidate, double x) { return mesh.points[at(candidate)].x() < x; });
    for (; point != rims.points.end() && mesh.points[at(*point)].x() <= highest; ++point) {
        if (*point == first || *point == second) continue;
        const Vec3 from_start = mesh.points[at(*point)] - start;
        const double place = from_start.dot(along) / length;
        const double off = (from_start - place / length * along).norm();
        if (off < tolerance && place > tolerance && place < length - tolerance)
            found.emplace_back(place, *point);
    }
    std::sort(found.begin(), found.end());
    std::vector<int> points;
    for (const auto& [place, number] : found)
        points.push_back(number);
    return points;
}

/// The triangles of one, split along its first rim edge with points on it.
std::vector<std::array<int, 3>> split(const TriangleMesh& mesh, const Rims& rims, int triangle)
{
    const std::array<int, 3>& corners = mesh.triangles[at(triangle)];
    for (std::size_t side = 0; side < 3; ++side) {
        const int a = corners[side], b = corners[(side + 1) % 3], c = corners[(side + 2) % 3];
        const auto& edges = rims.edges[at(triangle)];
        const std::array<int, 2> edge = {std::min(a, b), std::max(a, b)};
        if (std::find(edges.begin(), edges.end(), edge) == edges.end()) continue;
        std::vector<int> stops = points_on(mesh, rims, a, b);
        std::erase(stops, c);
        if (stops.empty()) continue;
        stops.push_back(b);
        std::vector<std::array<int, 3>> fan;
        for (std::size_t k = 0; k < stops.size(); ++k)
            fan.push_back({k == 0 ? a : stops[k - 1], stops[k], c});
        return fan;
    }
    return {corners};
}

}  // namespace

SplitEdges with_split_edges(const TriangleMesh& mesh)
{
    SplitEdges result{mesh, 0, std::vector<int>(mesh.triangles.size())};
    std::iota(result.from.begin(), result.from.end(), 0);
    // Each side of a triangle may need it.
    for (int pass = 0; pass < 3; ++pass) {
        const Rims rims = rims_of(result.mesh);
        std::vector<std::array<int, 3>> triangles;
        std::vector<int> from;
        for (int triangle = 0; triangle < static_cast<int>(result.mesh.triangles.size());
             ++triangle) {
            for (const auto& part : split(result.mesh, rims, triangle)) {
                triangles.push_back(part);
                from.push_back(result.from[at(triangle)]);
            }
        }
        const auto num_added = triangles.size() - result.mesh.triangles.size();
        if (num_added == 0) break;
        result.num_corners += static_cast<int>(num_added);
        result.mesh.triangles = std::move(triangles);
        result.from = std::move(from);
    }
    return result;
}

}  // namespace braidzone
