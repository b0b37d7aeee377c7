#include "core/triangle_mesh.hpp"

#include "core/error.hpp"

namespace braidzone {

namespace {

const Vec3& corner(const TriangleMesh& mesh, int triangle, std::size_t which)
{
    const std::array<int, 3>& corners = mesh.triangles[static_cast<std::size_t>(triangle)];
    return mesh.points[static_cast<std::size_t>(corners[which])];
}

int num_triangles(const TriangleMesh& mesh)
{
    return static_cast<int>(mesh.triangles.size());
}

}  // namespace

Vec3 area_vector(const TriangleMesh& mesh, int triangle)
{
    const Vec3& a = corner(mesh, triangle, 0);
    const Vec3& b = corner(mesh, triangle, 1);
    const Vec3& c = corner(mesh, triangle, 2);
    return 0.5 * (b - a).cross(c - a);
}

double surface_area(const TriangleMesh& mesh)
{
    double area = 0.0;
    for (int triangle = 0; triangle < num_triangles(mesh); ++triangle) {
        area += area_vector(mesh, triangle).norm();
    }
    return area;
}

double enclosed_volume(const TriangleMesh& mesh)
{
    if (mesh.points.empty()) return 0.0;
    // Relative to a point of the surface: about a far origin the tetrahedra nearly cancel.
    const Vec3& origin = mesh.points.front();
    double volume = 0.0;
    for (int triangle = 0; triangle < num_triangles(mesh); ++triangle) {
        volume += (corner(mesh, triangle, 0) - origin).dot(area_vector(mesh, triangle)) / 3.0;
    }
    return volume;
}

Box bounding_box(const TriangleMesh& mesh)
{
    if (mesh.points.empty()) throw InputError("the surface has no points");
    Box box{mesh.points.front(), mesh.points.front()};
    for (const Vec3& point : mesh.points) {
        box.lower = box.lower.cwiseMin(point);
        box.upper = box.upper.cwiseMax(point);
    }
    return box;
}

}  // namespace braidzone
