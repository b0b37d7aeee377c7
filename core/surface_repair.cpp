#include "core/surface_repair.hpp"

#include "core/error.hpp"
#include "core/surface_check.hpp"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/repair_degeneracies.h>
#include <CGAL/Polygon_mesh_processing/repair_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/repair_self_intersections.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Polygon_mesh_processing/stitch_borders.h>
#include <CGAL/Surface_mesh.h>
#include <fmt/format.h>

#include <algorithm>

namespace braidzone {

namespace {

namespace PMP = CGAL::Polygon_mesh_processing;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

/// Triangles without any connectivity but their points: what CGAL calls a polygon soup.
struct Soup {
    std::vector<Kernel::Point_3> points;
    std::vector<std::vector<std::size_t>> triangles;
};

Soup soup_of(const TriangleMesh& mesh)
{
    Soup soup;
    for (const Vec3& point : mesh.points)
        soup.points.emplace_back(point.x(), point.y(), point.z());
    for (const std::array<int, 3>& corners : mesh.triangles) {
        soup.triangles.emplace_back(corners.begin(), corners.end());
    }
    return soup;
}

TriangleMesh triangle_mesh_of(const Mesh& mesh)
{
    TriangleMesh result;
    std::vector<int> index(mesh.number_of_vertices() + mesh.number_of_removed_vertices(), -1);
    for (const Mesh::Vertex_index vertex : mesh.vertices()) {
        index[vertex] = static_cast<int>(result.points.size());
        const Kernel::Point_3& point = mesh.point(vertex);
        result.points.emplace_back(point.x(), point.y(), point.z());
    }
    for (const Mesh::Face_index face : mesh.faces()) {
        std::array<int, 3> corners{};
        std::size_t k = 0;
        for (const Mesh::Vertex_index vertex : mesh.vertices_around_face(mesh.halfedge(face))) {
            corners[k++] = index[vertex];
        }
        result.triangles.push_back(corners);
    }
    return result;
}

using Notes = std::vector<std::string>;

void drop_repeated_elements(Soup& soup, Notes& notes)
{
    const std::size_t before = soup.triangles.size();
    PMP::repair_polygon_soup(soup.points, soup.triangles);
    if (soup.triangles.size() < before) {
        notes.push_back(fmt::format("dropped {} triangles that were repeated or had equal corners",
                                    before - soup.triangles.size()));
    }
}

void orient(Soup& soup, Notes& notes)
{
    const auto normal = [&](std::size_t triangle) {
        const std::vector<std::size_t>& corners = soup.triangles[triangle];
        return CGAL::cross_product(soup.points[corners[1]] - soup.points[corners[0]],
                                   soup.points[corners[2]] - soup.points[corners[0]]);
    };
    std::vector<Kernel::Vector_3> normals_before;
    for (std::size_t k = 0; k < soup.triangles.size(); ++k)
        normals_before.push_back(normal(k));
    const std::size_t points_before = soup.points.size();

    PMP::orient_polygon_soup(soup.points, soup.triangles);

    std::size_t num_turned = 0;
    for (std::size_t k = 0; k < soup.triangles.size(); ++k) {
        if (normal(k) * normals_before[k] < 0.0) ++num_turned;
    }
    if (num_turned > 0) {
        notes.push_back(
            fmt::format("turned {} triangles to the winding of the others", num_turned));
    }
    if (soup.points.size() > points_before) {
        notes.push_back(fmt::format("split the surface at {} points where it was not manifold",
                                    soup.points.size() - points_before));
    }
}

void drop_small_parts(Mesh& mesh, Notes& notes)
{
    constexpr double smallest_share = 0.1;  // of the largest part's area
    auto part_of = mesh.add_property_map<Mesh::Face_index, std::size_t>("f:part").first;
    const std::size_t num_parts = PMP::connected_components(mesh, part_of);
    std::vector<double> area(num_parts, 0.0);
    for (const Mesh::Face_index face : mesh.faces()) {
        area[part_of[face]] += PMP::face_area(face, mesh);
    }
    const double largest = *std::max_element(area.begin(), area.end());
    std::vector<std::size_t> small_parts;
    for (std::size_t part = 0; part < num_parts; ++part) {
        if (area[part] < smallest_share * largest) small_parts.push_back(part);
    }
    if (!small_parts.empty()) {
        PMP::remove_connected_components(mesh, small_parts, part_of);
        notes.push_back(fmt::format("dropped {} separate parts of less than {:.6g} % of the area",
                                    small_parts.size(), 100.0 * smallest_share));
    }
    mesh.remove_property_map(part_of);
}

void remove_flat_triangles(Mesh& mesh, Notes& notes)
{
    mesh.collect_garbage();  // numbers the faces as in the copy that is examined
    const std::vector<int> found = find_defects(triangle_mesh_of(mesh)).degenerate_triangles;
    if (found.empty()) return;
    std::vector<Mesh::Face_index> faces;
    for (const int face : found)
        faces.emplace_back(static_cast<Mesh::size_type>(face));
    // A triangle without area has either a short side, which is collapsed, or a corner on the
    // opposite side, which is flipped. CGAL's usual limits, for these triangles only.
    const double flattest_angle_cosine = -0.94;  // 160 degrees
    const double longest_over_shortest = 4.0;
    const double any_length = 0.0;
    PMP::experimental::remove_almost_degenerate_faces(faces, mesh, flattest_angle_cosine,
                                                      longest_over_shortest, any_length);
    notes.push_back(fmt::format("removed {} triangles without area", found.size()));
}

void remove_crossings(Mesh& mesh, Notes& notes)
{
    if (!PMP::does_self_intersect(mesh)) return;
    const std::size_t before = mesh.number_of_faces();
    PMP::experimental::remove_self_intersections(mesh);
    notes.push_back(fmt::format("removed self-intersections ({} triangles became {})", before,
                                mesh.number_of_faces()));
}

}  // namespace

std::pair<TriangleMesh, std::vector<std::string>> repair(const TriangleMesh& mesh)
{
    Notes notes;
    Soup soup = soup_of(mesh);
    drop_repeated_elements(soup, notes);
    orient(soup, notes);
    Mesh surface;
    PMP::polygon_soup_to_polygon_mesh(soup.points, soup.triangles, surface);
    if (surface.number_of_faces() > 0) {
        drop_small_parts(surface, notes);
        // Where a fin was cut off at an edge, the two triangles beside it are joined again.
        PMP::stitch_borders(surface);
        remove_flat_triangles(surface, notes);
        remove_crossings(surface, notes);
    }
    TriangleMesh result = triangle_mesh_of(surface);
    SurfaceDefects defects = find_defects(result);
    if (defects.is_inverted) {
        for (std::array<int, 3>& corners : result.triangles)
            std::swap(corners[1], corners[2]);
        defects.is_inverted = false;
        notes.push_back("turned all normals out of the lumen");
    }
    if (!is_sound(defects)) {
        throw GeometryError("the surface could not be repaired; what remains:\n" +
                            describe(defects));
    }
    return {std::move(result), std::move(notes)};
}

}  // namespace braidzone
