#include "core/surface_labels.hpp"

#include "core/lumen_behind.hpp"
#include "core/mesh_topology.hpp"
#include "core/place_text.hpp"
#include "core/vessel.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

namespace braidzone {

namespace {

/// The label of the largest area.
int wall_label(const LabelledSurface& surface)
{
    std::map<int, double> area;
    for (std::size_t k = 0; k < surface.labels.size(); ++k)
        area[surface.labels[k]] += area_vector(surface.mesh, static_cast<int>(k)).norm();
    return std::max_element(area.begin(), area.end(),
                            [](const auto& a, const auto& b) { return a.second < b.second; })
        ->first;
}

/// The connected regions of each label but the wall's.
std::vector<LabelledCap> regions_beside_wall(const LabelledSurface& surface)
{
    const int wall = wall_label(surface);
    std::map<int, std::vector<int>> triangles;
    for (std::size_t k = 0; k < surface.labels.size(); ++k) {
        if (surface.labels[k] != wall) triangles[surface.labels[k]].push_back(static_cast<int>(k));
    }
    std::vector<LabelledCap> regions;
    for (const auto& [label, of_label] : triangles) {
        const TriangleMesh part = submesh(surface.mesh, of_label);
        for (const std::vector<int>& connected : connected_parts(part)) {
            LabelledCap region;
            region.label = label;
            for (const int triangle : connected)
                region.triangles.push_back(of_label[static_cast<std::size_t>(triangle)]);
            regions.push_back(std::move(region));
        }
    }
    return regions;
}

/// V - E + F.
int euler_characteristic(const TriangleMesh& mesh)
{
    int num_edges = 0;
    for_each_edge(sorted_sides(mesh), [&](auto, auto) { ++num_edges; });
    return static_cast<int>(mesh.points.size()) - num_edges +
           static_cast<int>(mesh.triangles.size());
}

/// Measures the rim of a region; false if the region is no disc that bulges as a cap may.
bool measure_cap(const TriangleMesh& mesh, LabelledCap& region)
{
    constexpr double largest_bulge = 2.5;  // over the rim's area; a half sphere has 2
    const TriangleMesh part = submesh(mesh, region.triangles);
    if (border_loops(part).size() != 1 || euler_characteristic(part) != 1) return false;
    TriangleMesh same_points{mesh.points, {}};
    for (const int triangle : region.triangles)
        same_points.triangles.push_back(mesh.triangles[static_cast<std::size_t>(triangle)]);
    std::vector<int> rim = border_loops(same_points).front();
    std::reverse(rim.begin(), rim.end());  // the wall's loops run the other way than a region's
    region.opening = measured_opening(mesh, std::move(rim));
    return surface_area(part) <= largest_bulge * region.opening.area;
}

TriangleMesh without_regions(const TriangleMesh& mesh, const std::vector<LabelledCap>& regions)
{
    std::set<int> left_out;
    for (const LabelledCap& region : regions)
        left_out.insert(region.triangles.begin(), region.triangles.end());
    TriangleMesh rest{mesh.points, {}};
    for (std::size_t k = 0; k < mesh.triangles.size(); ++k) {
        if (!left_out.contains(static_cast<int>(k))) rest.triangles.push_back(mesh.triangles[k]);
    }
    return rest;
}

std::string region_text(const LabelledSurface& surface, const LabelledCap& region)
{
    const Box box = bounding_box(submesh(surface.mesh, region.triangles));
    return fmt::format("{} {}, {} triangles about {}", surface.label_name, region.label,
                       region.triangles.size(), place_text(0.5 * (box.lower + box.upper)));
}

}  // namespace

LabelledCaps labelled_caps(const LabelledSurface& surface)
{
    LabelledCaps found;
    if (surface.labels.empty() || surface.labels.size() != surface.mesh.triangles.size())
        return found;
    std::vector<LabelledCap> discs, others;
    for (LabelledCap& region : regions_beside_wall(surface)) {
        const bool is_disc = measure_cap(surface.mesh, region);
        (is_disc ? discs : others).push_back(std::move(region));
    }
    Vessel open;
    open.wall = without_regions(surface.mesh, discs);
    if (open.wall.triangles.empty()) return found;
    const WallTree wall(open);
    for (LabelledCap& disc : discs) {
        const bool is_end = lumen_behind(disc.opening, surface.mesh, wall).is_tube;
        (is_end ? found.caps : others).push_back(std::move(disc));
    }
    constexpr std::size_t most = 5;
    for (std::size_t k = 0; k < std::min(others.size(), most); ++k) {
        found.notes.push_back(
            fmt::format("no cap, kept as wall: {}", region_text(surface, others[k])));
    }
    if (others.size() > most) {
        found.notes.push_back(fmt::format("no caps, kept as wall: {} further labelled regions",
                                          others.size() - most));
    }
    return found;
}

}  // namespace braidzone
