#include "core/phantom_mesh.hpp"

#include "core/error.hpp"
#include "core/level_contour.hpp"
#include "core/surface_check.hpp"

#include <CGAL/Polygon_mesh_processing/border.h>
#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Polygon_mesh_processing/remesh.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/helpers.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <map>
#include <utility>
#include <vector>

namespace braidzone {

namespace {

namespace pmp = CGAL::Polygon_mesh_processing;
using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using FaceSet = std::vector<Mesh::Face_index>;

Vec3 position(const Mesh& mesh, Mesh::Vertex_index vertex)
{
    const Kernel::Point_3& point = mesh.point(vertex);
    return {point.x(), point.y(), point.z()};
}

/// How far a point lies beyond the end; negative for points that do not belong to it.
double beyond(const PhantomEnd& end, double overhang, const Vec3& point)
{
    const Vec3 offset = point - end.centre;
    const double along = offset.dot(end.outwards);
    const double across = (offset - along * end.outwards).norm();
    const bool belongs = across < 1.5 * end.radius && along < overhang + 1.5 * end.radius;
    return belongs ? along : -end.radius;
}

/// The mesh without what lies beyond the end: triangles across its plane are cut along it.
TriangleMesh cut_off(const TriangleMesh& mesh, const PhantomEnd& end, double overhang)
{
    TriangleMesh kept;
    std::vector<int> new_index(mesh.points.size(), -1);
    std::map<std::pair<int, int>, int> cut_index;
    std::vector<double> height;
    for (const Vec3& point : mesh.points)
        height.push_back(beyond(end, overhang, point));

    const auto kept_point = [&](int old) {
        int& index = new_index[static_cast<std::size_t>(old)];
        if (index < 0) {
            index = static_cast<int>(kept.points.size());
            kept.points.push_back(mesh.points[static_cast<std::size_t>(old)]);
        }
        return index;
    };
    const auto cut_point = [&](int a, int b) {
        const auto [entry, is_new] =
            cut_index.try_emplace(std::minmax(a, b), static_cast<int>(kept.points.size()));
        if (is_new) {
            const auto [low, high] = entry->first;
            const double at_low = height[static_cast<std::size_t>(low)];
            const double at_high = height[static_cast<std::size_t>(high)];
            const double fraction = at_low / (at_low - at_high);
            kept.points.push_back((1.0 - fraction) * mesh.points[static_cast<std::size_t>(low)] +
                                  fraction * mesh.points[static_cast<std::size_t>(high)]);
        }
        return entry->second;
    };
    for (const auto& triangle : mesh.triangles) {
        std::vector<int> polygon;
        for (std::size_t corner = 0; corner < 3; ++corner) {
            const int a = triangle[corner], b = triangle[(corner + 1) % 3];
            const bool a_kept = height[static_cast<std::size_t>(a)] < 0.0;
            const bool b_kept = height[static_cast<std::size_t>(b)] < 0.0;
            if (a_kept) polygon.push_back(kept_point(a));
            if (a_kept != b_kept) polygon.push_back(cut_point(a, b));
        }
        for (std::size_t i = 2; i < polygon.size(); ++i) {
            kept.triangles.push_back({polygon[0], polygon[i - 1], polygon[i]});
        }
    }
    return kept;
}

[[noreturn]] void refuse_topology(const std::string& finding)
{
    throw ConfigError("the parts of the phantom do not make one vessel with separate ends: " +
                      finding);
}

Mesh to_cgal(const TriangleMesh& triangles)
{
    Mesh mesh;
    for (const Vec3& point : triangles.points) {
        mesh.add_vertex(Kernel::Point_3(point.x(), point.y(), point.z()));
    }
    for (const auto& [a, b, c] : triangles.triangles) {
        const auto vertex = [](int index) {
            return Mesh::Vertex_index(static_cast<Mesh::size_type>(index));
        };
        if (mesh.add_face(vertex(a), vertex(b), vertex(c)) == Mesh::null_face()) {
            refuse_topology("its wall touches itself");
        }
    }
    return mesh;
}

/// One component, one rim for each end and no handles: Euler's V - E + F is 2 without the rims.
void require_tree_of_tubes(Mesh& mesh, std::size_t num_ends)
{
    std::vector<Mesh::Halfedge_index> rims;
    pmp::extract_boundary_cycles(mesh, std::back_inserter(rims));
    auto components = mesh.add_property_map<Mesh::Face_index, std::size_t>("f:component").first;
    const std::size_t num_components = pmp::connected_components(mesh, components);
    mesh.remove_property_map(components);
    const auto euler = static_cast<long>(mesh.number_of_vertices()) -
                       static_cast<long>(mesh.number_of_edges()) +
                       static_cast<long>(mesh.number_of_faces());
    if (num_components != 1) {
        refuse_topology(fmt::format("there are {} separate pieces", num_components));
    }
    if (rims.size() != num_ends) {
        refuse_topology(fmt::format("{} ends, {} openings", num_ends, rims.size()));
    }
    if (euler != 2 - static_cast<long>(num_ends)) {
        refuse_topology("it is joined with itself into a loop");
    }
}

/// Moves a point onto the zero level, along the gradient; on a rim within the end's plane.
Vec3 onto_level(const PhantomShape& shape, Vec3 point, const PhantomEnd* end, double edge_length)
{
    const double step = 1e-3 * edge_length;
    if (end != nullptr) point -= (point - end->centre).dot(end->outwards) * end->outwards;
    for (int iteration = 0; iteration < 20; ++iteration) {
        const double value = level(shape, point);
        if (std::abs(value) < 1e-9 * edge_length) break;
        Vec3 gradient = level_gradient(shape, point, step);
        if (end != nullptr) gradient -= gradient.dot(end->outwards) * end->outwards;
        point -= value / gradient.squaredNorm() * gradient;
    }
    return point;
}

void project(Mesh& mesh, const PhantomShape& shape, double edge_length)
{
    for (const Mesh::Vertex_index vertex : mesh.vertices()) {
        const Vec3 point = position(mesh, vertex);
        const PhantomEnd* rim_of = nullptr;
        if (mesh.is_border(vertex)) {
            rim_of =
                &*std::min_element(shape.ends.begin(), shape.ends.end(),
                                   [&](const PhantomEnd& a, const PhantomEnd& b) {
                                       return (point - a.centre).norm() < (point - b.centre).norm();
                                   });
        }
        const Vec3 moved = onto_level(shape, point, rim_of, edge_length);
        mesh.point(vertex) = Kernel::Point_3(moved.x(), moved.y(), moved.z());
    }
}

void remesh_all(Mesh& mesh, double edge_length)
{
    pmp::isotropic_remeshing(FaceSet(mesh.faces().begin(), mesh.faces().end()), edge_length, mesh,
                             CGAL::parameters::number_of_iterations(1)
                                 .number_of_relaxation_steps(3)
                                 .relax_constraints(true)
                                 .do_project(false));
}

/// Remeshes some faces and leaves the edges around them as they are.
void remesh_within(Mesh& mesh, const FaceSet& faces, double edge_length)
{
    pmp::isotropic_remeshing(faces, edge_length, mesh,
                             CGAL::parameters::number_of_iterations(1)
                                 .number_of_relaxation_steps(3)
                                 .protect_constraints(true)
                                 .do_project(false));
}

/// Faces of the sac that lie clear of every other part.
FaceSet dome_faces(const Mesh& mesh, const PhantomShape& shape, const PhantomDome& dome)
{
    FaceSet faces;
    for (const Mesh::Face_index face : mesh.faces()) {
        bool in_dome = true;
        for (const Mesh::Vertex_index vertex :
             CGAL::vertices_around_face(mesh.halfedge(face), mesh)) {
            const Vec3 point = position(mesh, vertex);
            for (std::size_t part = 0; part < shape.parts.size(); ++part) {
                const double distance = shape.parts[part].level(point);
                in_dome = in_dome && (part == dome.part ? distance < 0.1 * dome.edge_length
                                                        : distance > 2.0 * dome.edge_length);
            }
        }
        if (in_dome) faces.push_back(face);
    }
    return faces;
}

TriangleMesh from_cgal(const Mesh& mesh)
{
    TriangleMesh result;
    for (const Mesh::Vertex_index vertex : mesh.vertices()) {
        result.points.push_back(position(mesh, vertex));
    }
    for (const Mesh::Face_index face : mesh.faces()) {
        std::array<int, 3> triangle{};
        std::size_t corner = 0;
        for (const Mesh::Vertex_index vertex :
             CGAL::vertices_around_face(mesh.halfedge(face), mesh)) {
            triangle[corner++] = static_cast<int>(vertex.idx());
        }
        result.triangles.push_back(triangle);
    }
    return result;
}

/// @param contour_cell  of the grid that the contour is taken from [m]
TriangleMesh mesh_wall_from(const PhantomShape& shape, double edge_length, double contour_cell)
{
    Box bounds = shape.parts.front().bounds;
    for (const PhantomPart& part : shape.parts) {
        bounds.lower = bounds.lower.cwiseMin(part.bounds.lower);
        bounds.upper = bounds.upper.cwiseMax(part.bounds.upper);
    }
    TriangleMesh wall =
        contour([&](const Vec3& point) { return level(shape, point); }, bounds, contour_cell);
    for (const PhantomEnd& end : shape.ends)
        wall = cut_off(wall, end, shape.overhang);

    Mesh mesh = to_cgal(wall);
    require_tree_of_tubes(mesh, shape.ends.size());
    // After ten rounds the edge lengths no longer change visibly.
    for (int round = 0; round < 10; ++round) {
        remesh_all(mesh, edge_length);
        project(mesh, shape, edge_length);
    }
    for (const PhantomDome& dome : shape.domes) {
        // Coarser by steps, each farther from the other parts: neighbours of similar size make
        // good triangles.
        constexpr double ratio = 1.4;
        double coarser = edge_length;
        while (coarser < dome.edge_length) {
            coarser = std::min(ratio * coarser, dome.edge_length);
            for (int round = 0; round < 5; ++round) {
                remesh_within(mesh, dome_faces(mesh, shape, {dome.part, coarser}), coarser);
                project(mesh, shape, edge_length);
            }
        }
    }
    mesh.collect_garbage();
    return from_cgal(mesh);
}

}  // namespace

TriangleMesh mesh_wall(const PhantomShape& shape, double edge_length)
{
    for (const double cell : {0.6, 0.55, 0.65, 0.5}) {
        TriangleMesh wall = mesh_wall_from(shape, edge_length, cell * edge_length);
        if (find_defects(wall).intersecting_triangles.empty()) return wall;
    }
    throw GeometryError(
        fmt::format("triangles of {:.4g} mm cross each other on this phantom; another "
                    "vessel.edge_length, or a larger vessel.blend_radius, may do",
                    1e3 * edge_length));
}

}  // namespace braidzone
