#include "discrepancy/device_surface.hpp"

#include "deploy/node_normals.hpp"

#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>
#include <CGAL/Simple_cartesian.h>
#include <Eigen/Dense>

#include <cmath>
#include <utility>
#include <vector>

namespace braidzone {
namespace {

using Kernel = CGAL::Simple_cartesian<double>;
using Triangles = std::vector<Kernel::Triangle_3>;
using Primitive = CGAL::AABB_triangle_primitive<Kernel, Triangles::const_iterator>;
using Tree = CGAL::AABB_tree<CGAL::AABB_traits<Kernel, Primitive>>;

Kernel::Point_3 as_cgal(const Vec3& p)
{
    return {p.x(), p.y(), p.z()};
}

std::size_t index(int i)
{
    return static_cast<std::size_t>(i);
}

/// Weights of a triangle's corners at a point of it.
Vec3 barycentric(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c)
{
    const Vec3 area = (b - a).cross(c - a);
    const double square = area.squaredNorm();
    if (!(square > 0.0)) return Vec3::Constant(1.0 / 3.0);
    const double wa = area.dot((b - p).cross(c - p)) / square;
    const double wb = area.dot((c - p).cross(a - p)) / square;
    return {wa, wb, 1.0 - wa - wb};
}

}  // namespace

struct DeviceSurface::Impl {
    TriangleMesh mesh;
    double half_thickness = 0.0;
    Triangles triangles;
    std::vector<Vec3> normals;       // of the nodes
    std::vector<double> arc_length;  // of the nodes
    std::vector<Vec2> direction;     // of the nodes from their hub, in the ring's frame
    int nodes_per_ring = 0;
    int num_rings = 0;
    Tree tree;
};

double angle_about(const CrossSection& ring, const Vec3& point)
{
    const Vec3 offset = point - ring.origin;
    return std::atan2(offset.dot(ring.binormal), offset.dot(ring.normal));
}

DeviceSurface::DeviceSurface(const Deployment& deployment)
    : DeviceSurface(deployment, {.middle = deployment.nodes})
{
}

DeviceSurface::DeviceSurface(const Deployment& deployment, ImagedSheet sheet)
    : impl_(std::make_unique<Impl>())
{
    Impl& impl = *impl_;
    impl.mesh = {std::move(sheet.middle), rhombus_triangles(deployment.lattice)};
    impl.half_thickness = sheet.half_thickness;
    impl.nodes_per_ring = deployment.lattice.nodes_per_ring;
    impl.num_rings = deployment.lattice.num_rings;
    impl.normals.assign(impl.mesh.points.size(), Vec3::Zero());
    for (int t = 0; t < static_cast<int>(impl.mesh.triangles.size()); ++t) {
        for (const int corner : impl.mesh.triangles[index(t)])
            impl.normals[index(corner)] += area_vector(impl.mesh, t);
    }
    for (Vec3& normal : impl.normals)
        normal.normalize();
    for (int ring = 0; ring < impl.num_rings; ++ring) {
        const CrossSection& hub = deployment.rings[index(ring)];
        for (int column = 0; column < impl.nodes_per_ring; ++column) {
            const double angle =
                angle_about(hub, impl.mesh.points[index(deployment.lattice.node(ring, column))]);
            impl.direction.emplace_back(std::cos(angle), std::sin(angle));
            impl.arc_length.push_back(deployment.ring_arc_length[index(ring)]);
        }
    }
    for (const auto& [a, b, c] : impl.mesh.triangles) {
        impl.triangles.emplace_back(as_cgal(impl.mesh.points[index(a)]),
                                    as_cgal(impl.mesh.points[index(b)]),
                                    as_cgal(impl.mesh.points[index(c)]));
    }
    impl.tree.insert(impl.triangles.begin(), impl.triangles.end());
    impl.tree.build();
    impl.tree.accelerate_distance_queries();
}

DeviceSurface::~DeviceSurface() = default;
DeviceSurface::DeviceSurface(DeviceSurface&&) noexcept = default;
DeviceSurface& DeviceSurface::operator=(DeviceSurface&&) noexcept = default;

SurfaceFoot DeviceSurface::nearest(const Vec3& point) const
{
    const Impl& impl = *impl_;
    const auto [nearest, primitive] = impl.tree.closest_point_and_primitive(as_cgal(point));
    const auto triangle = static_cast<std::size_t>(primitive - impl.triangles.begin());
    const auto& corners = impl.mesh.triangles[triangle];
    SurfaceFoot foot;
    foot.point = Vec3(nearest.x(), nearest.y(), nearest.z());
    const Vec3 weights =
        barycentric(foot.point, impl.mesh.points[index(corners[0])],
                    impl.mesh.points[index(corners[1])], impl.mesh.points[index(corners[2])]);
    Vec3 normal = Vec3::Zero();
    Vec2 direction = Vec2::Zero();
    double largest = -1.0;
    for (int i = 0; i < 3; ++i) {
        const int node = corners[index(i)];
        normal += weights[i] * impl.normals[index(node)];
        direction += weights[i] * impl.direction[index(node)];
        foot.arc_length += weights[i] * impl.arc_length[index(node)];
        const int ring = node / impl.nodes_per_ring;
        if (ring == 0 || ring + 1 == impl.num_rings) foot.is_on_rim = true;
        if (weights[i] > largest) {
            largest = weights[i];
            foot.node = node;
        }
    }
    foot.normal = normal.normalized();
    foot.angle = std::atan2(direction.y(), direction.x());
    const Vec3 away = point - foot.point;
    foot.distance = std::copysign(away.norm(), away.dot(foot.normal)) - impl.half_thickness;
    return foot;
}

const TriangleMesh& DeviceSurface::middle() const
{
    return impl_->mesh;
}

double DeviceSurface::half_thickness() const
{
    return impl_->half_thickness;
}

}  // namespace braidzone
