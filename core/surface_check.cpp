#include "core/surface_check.hpp"

#include "core/disjoint_sets.hpp"
#include "core/mesh_topology.hpp"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Surface_mesh.h>
#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <utility>

namespace braidzone {

namespace {

bool has_equal_corners(const std::array<int, 3>& corners)
{
    return corners[0] == corners[1] || corners[1] == corners[2] || corners[2] == corners[0];
}

std::vector<int> degenerate_triangles(const TriangleMesh& mesh)
{
    const Box box = bounding_box(mesh);
    const double smallest_area =
        1e-12 * (box.upper - box.lower).squaredNorm() / static_cast<double>(mesh.triangles.size());
    std::vector<int> found;
    for (std::size_t k = 0; k < mesh.triangles.size(); ++k) {
        const int triangle = static_cast<int>(k);
        if (has_equal_corners(mesh.triangles[k]) ||
            !(area_vector(mesh, triangle).norm() > smallest_area)) {
            found.push_back(triangle);
        }
    }
    return found;
}

/// The sides that are edges: a triangle with two equal corners encloses nothing and joins nothing.
std::vector<TriangleSide> proper_sides(const TriangleMesh& mesh)
{
    std::vector<TriangleSide> sides = sorted_sides(mesh);
    std::erase_if(sides, [&](const TriangleSide& side) {
        return has_equal_corners(mesh.triangles[static_cast<std::size_t>(side.triangle)]);
    });
    return sides;
}

/// Points whose triangles form more than one fan: triangles are of one fan if they are neighbours
/// across an edge at the point.
std::vector<int> pinched_points(const TriangleMesh& mesh, const std::vector<TriangleSide>& sides)
{
    const auto corner_of = [&](int triangle, int point) {
        const std::array<int, 3>& corners = mesh.triangles[static_cast<std::size_t>(triangle)];
        const auto where = std::find(corners.begin(), corners.end(), point) - corners.begin();
        return 3 * static_cast<std::size_t>(triangle) + static_cast<std::size_t>(where);
    };
    DisjointSets fans(3 * mesh.triangles.size());
    for_each_edge(sides, [&](auto first, auto last) {
        for (auto side = first + 1; side < last; ++side) {
            for (const int point : {first->low, first->high}) {
                fans.unite(corner_of(first->triangle, point), corner_of(side->triangle, point));
            }
        }
    });
    constexpr std::size_t none = static_cast<std::size_t>(-1);
    std::vector<std::size_t> fan_of(mesh.points.size(), none);
    std::vector<int> pinched;
    for (std::size_t triangle = 0; triangle < mesh.triangles.size(); ++triangle) {
        if (has_equal_corners(mesh.triangles[triangle])) continue;
        for (std::size_t k = 0; k < 3; ++k) {
            const int point = mesh.triangles[triangle][k];
            std::size_t& fan = fan_of[static_cast<std::size_t>(point)];
            const std::size_t this_fan = fans.find(3 * triangle + k);
            if (fan == none) fan = this_fan;
            if (fan != this_fan) pinched.push_back(point);
        }
    }
    std::sort(pinched.begin(), pinched.end());
    pinched.erase(std::unique(pinched.begin(), pinched.end()), pinched.end());
    return pinched;
}

/// Pairs of triangles that cross or overlap, the smaller index first, in order.
std::vector<std::array<int, 2>> intersecting_triangles(const TriangleMesh& mesh)
{
    using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
    using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
    Mesh surface;
    surface.reserve(static_cast<Mesh::size_type>(mesh.points.size()),
                    static_cast<Mesh::size_type>(3 * mesh.triangles.size() / 2),
                    static_cast<Mesh::size_type>(mesh.triangles.size()));
    for (const Vec3& point : mesh.points) {
        surface.add_vertex(Kernel::Point_3(point.x(), point.y(), point.z()));
    }
    const auto vertex = [](int point) {
        return Mesh::Vertex_index(static_cast<Mesh::size_type>(point));
    };
    for (const std::array<int, 3>& corners : mesh.triangles) {
        surface.add_face(vertex(corners[0]), vertex(corners[1]), vertex(corners[2]));
    }
    std::vector<std::pair<Mesh::Face_index, Mesh::Face_index>> faces;
    CGAL::Polygon_mesh_processing::self_intersections(surface, std::back_inserter(faces));
    std::vector<std::array<int, 2>> pairs;
    for (const auto& [a, b] : faces) {
        const int first = static_cast<int>(a.idx()), second = static_cast<int>(b.idx());
        pairs.push_back({std::min(first, second), std::max(first, second)});
    }
    std::sort(pairs.begin(), pairs.end());
    return pairs;
}

std::string element_name(int element)
{
    return fmt::format("{}", element);
}

std::string element_name(const std::array<int, 2>& pair)
{
    return fmt::format("{}-{}", pair[0], pair[1]);
}

/// "3 degenerate triangles: 4, 8, 15", no more than five elements by name.
template <typename Element>
void append_line(std::string& text, const std::vector<Element>& elements, const std::string& kind)
{
    if (elements.empty()) return;
    constexpr std::size_t most = 5;
    text += fmt::format("{} {}: ", elements.size(), kind);
    for (std::size_t k = 0; k < std::min(elements.size(), most); ++k) {
        text += (k > 0 ? ", " : "") + element_name(elements[k]);
    }
    text += elements.size() > most ? ", ...\n" : "\n";
}

}  // namespace

SurfaceDefects find_defects(const TriangleMesh& mesh)
{
    SurfaceDefects defects;
    if (mesh.triangles.empty()) return defects;
    defects.degenerate_triangles = degenerate_triangles(mesh);
    const std::vector<TriangleSide> sides = proper_sides(mesh);
    for_each_edge(sides, [&](auto first, auto last) {
        if (last - first > 2) {
            defects.non_manifold_edges.push_back({first->low, first->high});
        } else if (last - first == 2 && first->forward == (first + 1)->forward) {
            defects.inconsistent_edges.push_back({first->low, first->high});
        }
    });
    defects.non_manifold_points = pinched_points(mesh, sides);
    defects.num_components = static_cast<int>(connected_parts(mesh).size());

    const bool is_consistent_manifold =
        defects.degenerate_triangles.empty() && defects.non_manifold_edges.empty() &&
        defects.non_manifold_points.empty() && defects.inconsistent_edges.empty();
    if (is_consistent_manifold) {
        defects.intersecting_triangles = intersecting_triangles(mesh);
        defects.is_inverted = defects.num_components == 1 && is_inverted(mesh);
    }
    return defects;
}

bool is_inverted(const TriangleMesh& mesh)
{
    TriangleMesh closed = mesh;
    for (const std::vector<int>& loop : border_loops(mesh)) {
        Vec3 centre = Vec3::Zero();
        for (const int point : loop)
            centre += mesh.points[static_cast<std::size_t>(point)];
        append_fan(closed, loop, centre / static_cast<double>(loop.size()));
    }
    return enclosed_volume(closed) < 0.0;
}

bool is_sound(const SurfaceDefects& defects)
{
    return defects.degenerate_triangles.empty() && defects.non_manifold_edges.empty() &&
           defects.non_manifold_points.empty() && defects.inconsistent_edges.empty() &&
           defects.intersecting_triangles.empty() && defects.num_components == 1 &&
           !defects.is_inverted;
}

std::string describe(const SurfaceDefects& defects)
{
    std::string text;
    append_line(text, defects.degenerate_triangles, "degenerate triangles");
    append_line(text, defects.non_manifold_edges, "non-manifold edges, by their points");
    append_line(text, defects.non_manifold_points, "non-manifold points");
    append_line(text, defects.inconsistent_edges,
                "edges between triangles of opposite winding, by their points");
    append_line(text, defects.intersecting_triangles, "pairs of intersecting triangles");
    if (defects.num_components != 1) {
        text += fmt::format("{} separate parts instead of 1\n", defects.num_components);
    }
    if (defects.is_inverted) text += "the normals point into the lumen\n";
    return text;
}

}  // namespace braidzone
