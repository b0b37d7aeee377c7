#include "core/surface_caps.hpp"

#include "core/mesh_topology.hpp"
#include "core/vessel.hpp"
#include "core/wall_tree.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace braidzone {

namespace {

constexpr double degree = std::numbers::pi / 180.0;

/// Regions of triangles that are connected across edges no sharper than `angle_deg`.
std::vector<std::vector<int>> smooth_regions(const TriangleMesh& mesh, double angle_deg)
{
    const double smallest_cosine = std::cos(angle_deg * degree);
    std::vector<Vec3> normals;
    for (std::size_t k = 0; k < mesh.triangles.size(); ++k) {
        normals.push_back(area_vector(mesh, static_cast<int>(k)).normalized());
    }
    std::vector<std::vector<std::size_t>> neighbours(mesh.triangles.size());
    for_each_edge(sorted_sides(mesh), [&](auto first, auto last) {
        if (last - first != 2) return;
        const auto a = static_cast<std::size_t>(first->triangle);
        const auto b = static_cast<std::size_t>((first + 1)->triangle);
        if (normals[a].dot(normals[b]) < smallest_cosine) return;
        neighbours[a].push_back(b);
        neighbours[b].push_back(a);
    });

    std::vector<std::vector<int>> regions;
    std::vector<char> taken(mesh.triangles.size(), 0);
    for (std::size_t seed = 0; seed < mesh.triangles.size(); ++seed) {
        if (taken[seed]) continue;
        std::vector<int> region;
        std::vector<std::size_t> front{seed};
        taken[seed] = 1;
        while (!front.empty()) {
            const std::size_t triangle = front.back();
            front.pop_back();
            region.push_back(static_cast<int>(triangle));
            for (const std::size_t neighbour : neighbours[triangle]) {
                if (!taken[neighbour]) front.push_back(neighbour);
                taken[neighbour] = 1;
            }
        }
        std::sort(region.begin(), region.end());
        regions.push_back(std::move(region));
    }
    return regions;
}

Vec3 vector_area(const TriangleMesh& mesh, const std::vector<int>& region)
{
    Vec3 sum = Vec3::Zero();
    for (const int triangle : region)
        sum += area_vector(mesh, triangle);
    return sum;
}

bool is_flat(const TriangleMesh& mesh, const std::vector<int>& region, double angle_deg)
{
    const Vec3 mean = vector_area(mesh, region).normalized();
    return std::all_of(region.begin(), region.end(), [&](int triangle) {
        return area_vector(mesh, triangle).normalized().dot(mean) > std::cos(angle_deg * degree);
    });
}

/// True for a region with one rim that is not much longer than a circle of its area.
bool is_round(const TriangleMesh& mesh, const std::vector<int>& region)
{
    // The long facet of a prismatic wall is flat and sharp-edged too.
    constexpr double least_quotient = 0.5;
    const TriangleMesh part = submesh(mesh, region);
    const std::vector<std::vector<int>> rims = border_loops(part);
    if (rims.size() != 1) return false;
    double perimeter = 0.0;
    const std::vector<int>& rim = rims.front();
    for (std::size_t k = 0; k < rim.size(); ++k) {
        const auto from = static_cast<std::size_t>(rim[k]);
        const auto to = static_cast<std::size_t>(rim[(k + 1) % rim.size()]);
        perimeter += (part.points[to] - part.points[from]).norm();
    }
    const double area = vector_area(mesh, region).norm();
    return 4.0 * std::numbers::pi * area >= least_quotient * perimeter * perimeter;
}

/// True if the lumen behind a flat region is not much wider than the region.
bool is_end_of_lumen(const TriangleMesh& mesh, const std::vector<int>& region, const WallTree& wall)
{
    constexpr double depth = 2.0, largest_distance = 1.5;  // over the region's radius
    const Vec3 area = vector_area(mesh, region);
    Vec3 centre = Vec3::Zero();
    for (const int triangle : region) {
        const std::array<int, 3>& corners = mesh.triangles[static_cast<std::size_t>(triangle)];
        const double share = area_vector(mesh, triangle).dot(area) / area.squaredNorm();
        for (const int corner : corners)
            centre += share / 3.0 * mesh.points[static_cast<std::size_t>(corner)];
    }
    const double radius = std::sqrt(area.norm() / std::numbers::pi);
    const Vec3 behind = centre - depth * radius * area.normalized();
    return wall.nearest(behind).distance <= largest_distance * radius;
}

}  // namespace

std::vector<std::vector<int>> flat_caps(const TriangleMesh& mesh, double angle_deg)
{
    constexpr double rim_angle_deg = 45.0;
    constexpr double smallest_area_share = 1.0 / 100.0;  // a tenth of the radius

    std::vector<std::vector<int>> caps = smooth_regions(mesh, rim_angle_deg);
    std::erase_if(caps, [&](const std::vector<int>& region) {
        return !is_flat(mesh, region, angle_deg) || !is_round(mesh, region);
    });
    if (caps.empty()) return caps;
    Vessel surface;
    surface.wall = mesh;
    const WallTree wall(surface);
    std::erase_if(caps,
                  [&](const std::vector<int>& cap) { return !is_end_of_lumen(mesh, cap, wall); });
    double largest_area = 0.0;
    for (const std::vector<int>& cap : caps) {
        largest_area = std::max(largest_area, vector_area(mesh, cap).norm());
    }
    std::erase_if(caps, [&](const std::vector<int>& cap) {
        return vector_area(mesh, cap).norm() < smallest_area_share * largest_area;
    });
    return caps;
}

}  // namespace braidzone
