#include "core/mesh_topology.hpp"

#include "core/disjoint_sets.hpp"

#include <algorithm>
#include <tuple>

namespace braidzone {

std::vector<TriangleSide> sorted_sides(const TriangleMesh& mesh)
{
    std::vector<TriangleSide> sides;
    sides.reserve(3 * mesh.triangles.size());
    for (std::size_t triangle = 0; triangle < mesh.triangles.size(); ++triangle) {
        const std::array<int, 3>& corners = mesh.triangles[triangle];
        for (std::size_t k = 0; k < 3; ++k) {
            const int from = corners[k], to = corners[(k + 1) % 3];
            sides.push_back(
                {std::min(from, to), std::max(from, to), static_cast<int>(triangle), from < to});
        }
    }
    std::sort(sides.begin(), sides.end(), [](const TriangleSide& a, const TriangleSide& b) {
        return std::tie(a.low, a.high, a.triangle, a.forward) <
               std::tie(b.low, b.high, b.triangle, b.forward);
    });
    return sides;
}

std::vector<std::vector<int>> connected_parts(const TriangleMesh& mesh)
{
    DisjointSets points(mesh.points.size());
    const auto index = [](int point) { return static_cast<std::size_t>(point); };
    for (const std::array<int, 3>& corners : mesh.triangles) {
        points.unite(index(corners[0]), index(corners[1]));
        points.unite(index(corners[0]), index(corners[2]));
    }
    std::vector<std::vector<int>> parts;
    std::vector<int> part_of(mesh.points.size(), -1);
    for (std::size_t triangle = 0; triangle < mesh.triangles.size(); ++triangle) {
        int& part = part_of[points.find(index(mesh.triangles[triangle][0]))];
        if (part < 0) {
            part = static_cast<int>(parts.size());
            parts.emplace_back();
        }
        parts[static_cast<std::size_t>(part)].push_back(static_cast<int>(triangle));
    }
    return parts;
}

std::vector<std::vector<int>> border_loops(const TriangleMesh& mesh)
{
    // next[p] follows p on its rim; a manifold point lies on one rim at most.
    std::vector<int> next(mesh.points.size(), -1);
    for_each_edge(sorted_sides(mesh), [&](auto first, auto last) {
        if (last - first != 1) return;
        const int from = first->forward ? first->high : first->low;
        next[static_cast<std::size_t>(from)] = first->forward ? first->low : first->high;
    });

    std::vector<std::vector<int>> loops;
    for (std::size_t start = 0; start < next.size(); ++start) {
        std::vector<int> loop;
        for (int point = static_cast<int>(start); point >= 0;) {
            const int following = next[static_cast<std::size_t>(point)];
            if (following >= 0) loop.push_back(point);
            next[static_cast<std::size_t>(point)] = -1;  // each point once
            point = following;
        }
        if (loop.size() >= 3) loops.push_back(std::move(loop));
    }
    return loops;
}

void append_fan(TriangleMesh& mesh, const std::vector<int>& loop, const Vec3& centre)
{
    const int apex = static_cast<int>(mesh.points.size());
    mesh.points.push_back(centre);
    for (std::size_t k = 0; k < loop.size(); ++k) {
        mesh.triangles.push_back({apex, loop[k], loop[(k + 1) % loop.size()]});
    }
}

TriangleMesh submesh(const TriangleMesh& mesh, const std::vector<int>& triangles)
{
    constexpr int unused = -1;
    std::vector<int> new_index(mesh.points.size(), unused);
    for (const int triangle : triangles) {
        for (const int point : mesh.triangles[static_cast<std::size_t>(triangle)]) {
            new_index[static_cast<std::size_t>(point)] = 0;
        }
    }
    TriangleMesh part;
    for (std::size_t point = 0; point < mesh.points.size(); ++point) {
        if (new_index[point] == unused) continue;
        new_index[point] = static_cast<int>(part.points.size());
        part.points.push_back(mesh.points[point]);
    }
    for (const int triangle : triangles) {
        std::array<int, 3> corners = mesh.triangles[static_cast<std::size_t>(triangle)];
        for (int& point : corners)
            point = new_index[static_cast<std::size_t>(point)];
        part.triangles.push_back(corners);
    }
    return part;
}

}  // namespace braidzone
