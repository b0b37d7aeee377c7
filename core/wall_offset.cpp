#include "core/wall_offset.hpp"

#include "core/error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace braidzone {

TriangleMesh with_wall_offset(const TriangleMesh& mesh, double offset)
{
    if (!std::isfinite(offset)) throw InputError(fmt::format("the wall's offset is {} m", offset));
    std::vector<Vec3> normals(mesh.points.size(), Vec3::Zero());
    for (const auto& triangle : mesh.triangles) {
        for (std::size_t corner = 0; corner < 3; ++corner) {
            const auto here = static_cast<std::size_t>(triangle[corner]);
            const Vec3& p = mesh.points[here];
            const Vec3 u = mesh.points[static_cast<std::size_t>(triangle[(corner + 1) % 3])] - p;
            const Vec3 v = mesh.points[static_cast<std::size_t>(triangle[(corner + 2) % 3])] - p;
            const Vec3 across = u.cross(v);
            const double angle = std::atan2(across.norm(), u.dot(v));
            if (across.norm() > 0.0) normals[here] += angle * across.normalized();
        }
    }
    TriangleMesh moved = mesh;
    for (std::size_t i = 0; i < normals.size(); ++i) {
        if (normals[i].norm() > 0.0) moved.points[i] += offset * normals[i].normalized();
    }
    return moved;
}

}  // namespace braidzone
