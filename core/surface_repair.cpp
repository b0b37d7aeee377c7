#include "core/surface_repair.hpp"

#include "core/error.hpp"
#include "core/mesh_topology.hpp"
#include "core/place_text.hpp"
#include "core/surface_check.hpp"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
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
#include <array>

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

Mesh polygon_mesh_of(const Soup& soup)
{
    Mesh surface;
    PMP::polygon_soup_to_polygon_mesh(soup.points, soup.triangles, surface);
    return surface;
}

/// Equal points one, repeated and flat triangles gone, split where it is not manifold.
TriangleMesh with_clean_topology(const TriangleMesh& mesh, Notes& notes)
{
    Soup soup = soup_of(mesh);
    drop_repeated_elements(soup, notes);
    orient(soup, notes);
    Mesh surface = polygon_mesh_of(soup);
    if (surface.number_of_faces() > 0) remove_flat_triangles(surface, notes);
    return triangle_mesh_of(surface);
}

TriangleMesh with_one_winding(const TriangleMesh& mesh, Notes& notes)
{
    Soup soup = soup_of(mesh);
    orient(soup, notes);
    return triangle_mesh_of(polygon_mesh_of(soup));
}

/// "a part of 12 triangles, 0.4 mm across, about (1, 2, 3) mm"
std::string part_text(const TriangleMesh& part, const LengthUnit& unit)
{
    const Box box = bounding_box(part);
    return fmt::format("a part of {} triangles, {:.4g} {} across, about {}", part.triangles.size(),
                       (box.upper - box.lower).norm() / unit.metres, unit.name,
                       place_text(0.5 * (box.lower + box.upper), unit));
}

/// The parts of a surface, largest area first.
std::vector<TriangleMesh> parts_by_area(const TriangleMesh& mesh)
{
    std::vector<TriangleMesh> parts;
    for (const std::vector<int>& triangles : connected_parts(mesh))
        parts.push_back(submesh(mesh, triangles));
    std::stable_sort(parts.begin(), parts.end(), [](const TriangleMesh& a, const TriangleMesh& b) {
        return surface_area(a) > surface_area(b);
    });
    return parts;
}

/// The smaller parts, five at most by name, one a line.
std::string smaller_parts_text(const TriangleMesh& mesh, const LengthUnit& unit)
{
    constexpr std::size_t most = 5;
    const std::vector<TriangleMesh> parts = parts_by_area(mesh);
    std::string text;
    for (std::size_t k = 1; k < std::min(parts.size(), most + 1); ++k)
        text += "  beside the largest: " + part_text(parts[k], unit) + "\n";
    return text;
}

TriangleMesh largest_part(const TriangleMesh& mesh, const LengthUnit& unit, Notes& notes)
{
    constexpr double largest_share = 0.5;  // of the largest one's area: else which is the vessel?
    const std::vector<TriangleMesh> parts = parts_by_area(mesh);
    if (surface_area(parts[1]) > largest_share * surface_area(parts[0])) {
        throw GeometryError(fmt::format(
            "the surface has {} separate parts, and the second is no small one ({:.3g} % of the "
            "largest one's area):\n{}take out what is not the vessel",
            parts.size(), 100.0 * surface_area(parts[1]) / surface_area(parts[0]),
            smaller_parts_text(mesh, unit)));
    }
    for (std::size_t k = 1; k < parts.size(); ++k)
        notes.push_back("dropped " + part_text(parts[k], unit));
    // Where a fin was cut off at an edge, the two triangles beside it are joined again.
    Mesh surface = polygon_mesh_of(soup_of(parts.front()));
    PMP::stitch_borders(surface);
    return triangle_mesh_of(surface);
}

TriangleMesh without_crossings(const TriangleMesh& mesh, const LengthUnit& unit, Notes& notes)
{
    const auto crossing = find_defects(mesh).intersecting_triangles;
    if (crossing.empty()) return mesh;
    const auto& corners = mesh.triangles[static_cast<std::size_t>(crossing.front()[0])];
    const Vec3& first = mesh.points[static_cast<std::size_t>(corners[0])];
    Mesh surface = polygon_mesh_of(soup_of(mesh));
    PMP::experimental::remove_self_intersections(surface);
    notes.push_back(
        fmt::format("removed self-intersections, the first at {} ({} triangles became {})",
                    place_text(first, unit), mesh.triangles.size(), surface.number_of_faces()));
    return triangle_mesh_of(surface);
}

/// The repairs that the defects call for; holes are no defect of the surface.
Repairs needed_repairs(const SurfaceDefects& defects)
{
    Repairs needed;
    needed.merge = !defects.degenerate_triangles.empty() || !defects.non_manifold_edges.empty() ||
                   !defects.non_manifold_points.empty();
    needed.normals = !defects.inconsistent_edges.empty();
    needed.parts = defects.num_components > 1;
    needed.self_intersections = !defects.intersecting_triangles.empty();
    return needed;
}

constexpr std::array<std::pair<const char*, bool Repairs::*>, 5> repairs_by_name = {
    {{"normals", &Repairs::normals},
     {"merge", &Repairs::merge},
     {"holes", &Repairs::holes},
     {"self_intersections", &Repairs::self_intersections},
     {"parts", &Repairs::parts}}};

/// The largest number of rounds: a repair may bring another defect to light, as a fin that is cut
/// off is a part.
constexpr int most_rounds = 4;

void require_allowed(const TriangleMesh& mesh, const SurfaceDefects& defects,
                     const Repairs& allowed, const LengthUnit& unit)
{
    const Repairs needed = needed_repairs(defects);
    Repairs all = allowed;
    for (const auto& [name, member] : repairs_by_name)
        all.*member = all.*member || needed.*member;
    if (all == allowed && !mesh.triangles.empty()) return;
    const std::string parts = needed.parts ? smaller_parts_text(mesh, unit) : "";
    throw GeometryError(
        fmt::format("the vessel's surface is defective:\n{}{}mend it, or state `{}` in "
                    "[vessel]",
                    describe(defects), parts, repair_text(all)));
}

}  // namespace

std::vector<std::string> repair_names()
{
    std::vector<std::string> names;
    for (const auto& [name, member] : repairs_by_name)
        names.emplace_back(name);
    return names;
}

Repairs repairs_at(const std::vector<std::size_t>& places)
{
    Repairs repairs;
    for (const std::size_t place : places)
        repairs.*(repairs_by_name.at(place).second) = true;
    return repairs;
}

std::vector<std::string> names_of(const Repairs& repairs)
{
    std::vector<std::string> names;
    for (const auto& [name, member] : repairs_by_name) {
        if (repairs.*member) names.emplace_back(name);
    }
    return names;
}

std::string repair_text(const Repairs& repairs)
{
    return fmt::format("repair = [\"{}\"]", fmt::join(names_of(repairs), "\", \""));
}

std::pair<TriangleMesh, std::vector<std::string>> repair(const TriangleMesh& mesh,
                                                         const Repairs& allowed,
                                                         const LengthUnit& unit)
{
    Notes notes;
    TriangleMesh result = mesh;
    SurfaceDefects defects = find_defects(result);
    for (int round = 0; round < most_rounds && !is_sound(defects); ++round) {
        require_allowed(result, defects, allowed, unit);
        const Repairs needed = needed_repairs(defects);
        if (needed.merge) result = with_clean_topology(result, notes);
        if (needed.normals) result = with_one_winding(result, notes);
        if (needed.parts) result = largest_part(result, unit, notes);
        if (needed.self_intersections) result = without_crossings(result, unit, notes);
        if (defects.is_inverted) {
            for (std::array<int, 3>& corners : result.triangles)
                std::swap(corners[1], corners[2]);
            notes.push_back("turned all normals out of the lumen");
        }
        defects = find_defects(result);
    }
    if (!is_sound(defects)) {
        throw GeometryError("the surface could not be repaired; what remains:\n" +
                            describe(defects));
    }
    return {std::move(result), std::move(notes)};
}

}  // namespace braidzone
