#include "core/near_points.hpp"

#include "core/disjoint_sets.hpp"
#include "core/mesh_topology.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace braidzone {

namespace {

constexpr double share_of_edge = 1e-4;

std::size_t at(int index)
{
    return static_cast<std::size_t>(index);
}

const Vec3& corner(const TriangleMesh& mesh, const std::array<int, 3>& corners, std::size_t k)
{
    return mesh.points[at(corners[k % 3])];
}

/// Mean length of the sides at each point [m].
std::vector<double> mean_edges(const TriangleMesh& mesh)
{
    std::vector<double> sum(mesh.points.size(), 0.0), number(mesh.points.size(), 0.0);
    for (const std::array<int, 3>& corners : mesh.triangles) {
        for (std::size_t k = 0; k < 3; ++k) {
            const double length = (corner(mesh, corners, k + 1) - corner(mesh, corners, k)).norm();
            for (const int point : {corners[k], corners[(k + 1) % 3]}) {
                sum[at(point)] += length;
                number[at(point)] += 1.0;
            }
        }
    }
    for (std::size_t k = 0; k < sum.size(); ++k)
        sum[k] /= std::max(number[k], 1.0);
    return sum;
}

/// Points at a rim or of a flat triangle: only there do near points spoil the surface.
std::vector<char> suspects(const TriangleMesh& mesh)
{
    std::vector<char> found(mesh.points.size(), 0);
    for_each_edge(sorted_sides(mesh), [&](auto first, auto last) {
        if (last - first == 1) found[at(first->low)] = found[at(first->high)] = 1;
    });
    for (std::size_t triangle = 0; triangle < mesh.triangles.size(); ++triangle) {
        const std::array<int, 3>& corners = mesh.triangles[triangle];
        double longest = 0.0;
        for (std::size_t k = 0; k < 3; ++k) {
            longest =
                std::max(longest, (corner(mesh, corners, k + 1) - corner(mesh, corners, k)).norm());
        }
        const double area = area_vector(mesh, static_cast<int>(triangle)).norm();
        if (2.0 * area > share_of_edge * longest * longest) continue;
        for (const int point : corners)
            found[at(point)] = 1;
    }
    return found;
}

/// Unites the points that are to become one.
DisjointSets near_groups(const TriangleMesh& mesh)
{
    const std::vector<double> edge = mean_edges(mesh);
    const std::vector<char> is_suspect = suspects(mesh);
    const double longest = edge.empty() ? 0.0 : *std::max_element(edge.begin(), edge.end());
    std::vector<int> order(mesh.points.size());
    std::iota(order.begin(), order.end(), 0);
    std::sort(order.begin(), order.end(),
              [&](int a, int b) { return mesh.points[at(a)].x() < mesh.points[at(b)].x(); });

    DisjointSets groups(mesh.points.size());
    const auto unite_if_near = [&](std::size_t a, std::size_t b) {
        const Vec3 apart = mesh.points[b] - mesh.points[a];
        if (apart.norm() < share_of_edge * std::min(edge[a], edge[b])) groups.unite(a, b);
        return std::abs(apart.x()) <= share_of_edge * longest;
    };
    const int num_points = static_cast<int>(order.size());
    for (int i = 0; i < num_points; ++i) {
        const auto point = at(order[at(i)]);
        if (!is_suspect[point]) continue;
        for (int j = i + 1; j < num_points && unite_if_near(point, at(order[at(j)])); ++j) {
        }
        for (int j = i - 1; j >= 0 && unite_if_near(point, at(order[at(j)])); --j) {
        }
    }
    return groups;
}

}  // namespace

MergedPoints merged_near_points(const TriangleMesh& mesh)
{
    DisjointSets groups = near_groups(mesh);
    MergedPoints result;
    TriangleMesh joined = mesh;
    for (std::size_t point = 0; point < mesh.points.size(); ++point) {
        if (groups.find(point) != point) ++result.num_merged;
    }
    for (std::size_t triangle = 0; triangle < mesh.triangles.size(); ++triangle) {
        std::array<int, 3>& corners = joined.triangles[triangle];
        const std::array<int, 3> before = corners;
        for (int& point : corners)
            point = static_cast<int>(groups.find(at(point)));
        const bool has_collapsed =
            corners != before &&
            (corners[0] == corners[1] || corners[1] == corners[2] || corners[2] == corners[0]);
        if (!has_collapsed) result.kept.push_back(static_cast<int>(triangle));
    }
    result.mesh = result.num_merged > 0 ? submesh(joined, result.kept) : mesh;
    return result;
}

}  // namespace braidzone
