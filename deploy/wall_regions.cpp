#include "deploy/wall_regions.hpp"

#include "core/mesh_topology.hpp"
#include "deploy/neck.hpp"

#include <algorithm>
#include <functional>
#include <numbers>
#include <utility>

namespace braidzone {

namespace {

constexpr double outside_ratio = NeckOptions{}.outside_ratio;
/// What rises less above a branch's tube is a flare of its ostium, or a bulge of its wall.
constexpr double sac_ratio = 1.6;
/// Wall of a sac over the parent's cross-section: that of a hemisphere half as wide as the parent.
constexpr double least_sac_area = 0.5;

std::size_t index(int i)
{
    return static_cast<std::size_t>(i);
}

std::vector<std::vector<int>> triangle_neighbours(const TriangleMesh& mesh)
{
    std::vector<std::vector<int>> neighbours(mesh.triangles.size());
    for_each_edge(sorted_sides(mesh), [&](auto first, auto last) {
        for (auto side = first; side != last; ++side) {
            for (auto other = first; other != last; ++other) {
                if (other != side) neighbours[index(side->triangle)].push_back(other->triangle);
            }
        }
    });
    return neighbours;
}

/// Triangles that share edges and for which `belongs` holds, by parts.
std::vector<std::vector<int>> parts_by_edges(const std::vector<std::vector<int>>& neighbours,
                                             const std::function<bool(int)>& belongs)
{
    std::vector<char> seen(neighbours.size(), 0);
    std::vector<std::vector<int>> parts;
    for (int seed = 0; seed < static_cast<int>(neighbours.size()); ++seed) {
        if (seen[index(seed)] || !belongs(seed)) continue;
        std::vector<int> part{seed};
        seen[index(seed)] = 1;
        for (std::size_t next = 0; next < part.size(); ++next) {
            for (const int neighbour : neighbours[index(part[next])]) {
                if (seen[index(neighbour)] || !belongs(neighbour)) continue;
                seen[index(neighbour)] = 1;
                part.push_back(neighbour);
            }
        }
        parts.push_back(std::move(part));
    }
    return parts;
}

/// Relative distances of the triangles' middles from a tube.
std::vector<double> distances_from(const LumenTube& tube, const TriangleMesh& mesh)
{
    std::vector<double> distances;
    distances.reserve(mesh.triangles.size());
    for (const auto& [a, b, c] : mesh.triangles) {
        distances.push_back(relative_distance(
            tube, (mesh.points[index(a)] + mesh.points[index(b)] + mesh.points[index(c)]) / 3.0));
    }
    return distances;
}

/// The openings whose rims a part of the wall reaches, increasing.
std::vector<int> openings_at(const std::vector<int>& part, const Vessel& vessel)
{
    std::vector<int> opening_at(vessel.wall.points.size(), -1);
    for (std::size_t opening = 0; opening < vessel.openings.size(); ++opening) {
        for (const int point : vessel.openings[opening].rim)
            opening_at[index(point)] = static_cast<int>(opening);
    }
    std::vector<int> openings;
    for (const int triangle : part) {
        for (const int point : vessel.wall.triangles[index(triangle)]) {
            if (opening_at[index(point)] >= 0) openings.push_back(opening_at[index(point)]);
        }
    }
    std::sort(openings.begin(), openings.end());
    openings.erase(std::unique(openings.begin(), openings.end()), openings.end());
    return openings;
}

void add(WallRegions& regions, const std::vector<int>& part, std::vector<int> branches)
{
    const int number = static_cast<int>(regions.branches.size());
    for (const int triangle : part)
        regions.of_triangle[index(triangle)] = number;
    regions.branches.push_back(std::move(branches));
}

/// The parent's section nearest to the middle of the border between a region and the rest of the
/// wall.
std::size_t section_at_mouth(const WallRegions& regions, int region, const TriangleMesh& mesh,
                             const std::vector<std::vector<int>>& neighbours,
                             const LumenTube& parent)
{
    Vec3 sum = Vec3::Zero();
    double number = 0.0;
    for (std::size_t triangle = 0; triangle < mesh.triangles.size(); ++triangle) {
        if (regions.of_triangle[triangle] != region) continue;
        for (const int neighbour : neighbours[triangle]) {
            if (regions.of_triangle[index(neighbour)] == region) continue;
            sum += mesh.points[index(mesh.triangles[triangle][0])];
            number += 1.0;
        }
    }
    const Vec3 mouth = sum / std::max(number, 1.0);
    const auto nearest = std::min_element(
        parent.sections.begin(), parent.sections.end(),
        [&](const CrossSection& first, const CrossSection& second) {
            return (first.origin - mouth).squaredNorm() < (second.origin - mouth).squaredNorm();
        });
    return static_cast<std::size_t>(nearest - parent.sections.begin());
}

double area_of(const std::vector<int>& part, const TriangleMesh& mesh)
{
    double area = 0.0;
    for (const int triangle : part)
        area += area_vector(mesh, triangle).norm();
    return area;
}

/// Of the tube across a section, with the mean of its radii [m^2].
double cross_section(const LumenTube& tube, std::size_t section)
{
    double sum = 0.0;
    for (const double radius : tube.radii[section])
        sum += radius;
    const double mean = sum / static_cast<double>(tube.radii[section].size());
    return std::numbers::pi * mean * mean;
}

}  // namespace

WallRegions wall_regions(const Vessel& vessel, const LumenTube& parent,
                         const std::array<int, 2>& ends)
{
    const std::vector<double> distances = distances_from(parent, vessel.wall);
    WallRegions regions;
    regions.of_triangle.assign(vessel.wall.triangles.size(), WallRegions::none);
    for (const std::vector<int>& part :
         parts_by_edges(triangle_neighbours(vessel.wall),
                        [&](int triangle) { return distances[index(triangle)] > outside_ratio; })) {
        std::vector<int> branches = openings_at(part, vessel);
        std::erase_if(branches,
                      [&](int opening) { return opening == ends[0] || opening == ends[1]; });
        add(regions, part, std::move(branches));
    }
    return regions;
}

void part_sacs_from_branches(WallRegions& regions, int region, const Vessel& vessel,
                             const WallTree& wall, const LumenTube& parent, double reach)
{
    const std::vector<std::vector<int>> neighbours = triangle_neighbours(vessel.wall);
    std::vector<double> nearest = distances_from(parent, vessel.wall);
    const std::size_t mouth = section_at_mouth(regions, region, vessel.wall, neighbours, parent);
    const double least_area = least_sac_area * cross_section(parent, mouth);
    for (const int branch : regions.branches[index(region)]) {
        const LumenTube tube = branch_tube(wall, vessel.openings[index(branch)],
                                           parent.sections[mouth].origin, parent, reach);
        if (tube.sections.empty()) return;
        const std::vector<double> distances = distances_from(tube, vessel.wall);
        for (std::size_t triangle = 0; triangle < nearest.size(); ++triangle)
            nearest[triangle] = std::min(nearest[triangle], distances[triangle]);
    }
    for (const std::vector<int>& beside : parts_by_edges(neighbours, [&](int triangle) {
             return regions.of_triangle[index(triangle)] == region &&
                    nearest[index(triangle)] > outside_ratio;
         })) {
        const bool is_sac = area_of(beside, vessel.wall) >= least_area &&
                            std::any_of(beside.begin(), beside.end(), [&](int triangle) {
                                return nearest[index(triangle)] > sac_ratio;
                            });
        if (is_sac && openings_at(beside, vessel).empty()) add(regions, beside, {});
    }
}

}  // namespace braidzone
