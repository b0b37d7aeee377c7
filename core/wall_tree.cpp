#include "core/wall_tree.hpp"

#include "core/error.hpp"

#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>
#include <CGAL/Simple_cartesian.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

namespace braidzone {

namespace {

using Kernel = CGAL::Simple_cartesian<double>;
using Triangles = std::vector<Kernel::Triangle_3>;
using Primitive = CGAL::AABB_triangle_primitive<Kernel, Triangles::const_iterator>;
using Traits = CGAL::AABB_traits<Kernel, Primitive>;
using Node = CGAL::AABB_node<Traits>;

/// A segment prepared for crossing tests by Woop, Benthin and Wald (2013), J. Comput. Graph. Tech.
/// 2:1, 65-82: coordinates are sheared so that the segment runs along one axis.
///
/// The shear moves a point alike whichever triangle it belongs to, so two triangles see an edge
/// between them on the same side of the segment, to the last bit: no segment slips through.
class Segment {
public:
    Segment(const Vec3& from, const Vec3& to, double slack)
        : from_(from), direction_(to - from), slack_(slack)
    {
        direction_.cwiseAbs().maxCoeff(&z_);
        x_ = (z_ + 1) % 3;
        y_ = (z_ + 2) % 3;
        shear_x_ = direction_[x_] / direction_[z_];
        shear_y_ = direction_[y_] / direction_[z_];
        const double length = direction_.norm();
        fraction_slack_ = slack / length;
        for (int axis = 0; axis < 3; ++axis) {
            // A finite stand-in for 1 / 0 keeps 0 * inf out of the box test.
            constexpr double huge = 1e300;
            const double component = direction_[axis];
            inverse_[axis] = std::abs(component) > 1.0 / huge ? 1.0 / component : huge;
        }
    }

    /// True if the part of the segment up to `last_fraction` comes into the box.
    bool meets(const CGAL::Bbox_3& box, double last_fraction) const
    {
        double enter = -fraction_slack_;
        double leave = last_fraction + fraction_slack_;
        for (int axis = 0; axis < 3; ++axis) {
            const double a = (box.min(axis) - slack_ - from_[axis]) * inverse_[axis];
            const double b = (box.max(axis) + slack_ - from_[axis]) * inverse_[axis];
            enter = std::max(enter, std::min(a, b));
            leave = std::min(leave, std::max(a, b));
        }
        return enter <= leave;
    }

    struct Crossing {
        bool exists = false;
        bool grazes = false;    ///< meets the border of the triangle, or runs in its plane
        double fraction = 0.0;  ///< 0 to 1
    };

    Crossing crossing(const Vec3& a, const Vec3& b, const Vec3& c) const
    {
        const Sheared p = shear(a), q = shear(b), r = shear(c);
        // Twice the areas that the segment, seen end on, spans with each side of the triangle.
        const double u = r.x * q.y - r.y * q.x;
        const double v = p.x * r.y - p.y * r.x;
        const double w = q.x * p.y - q.y * p.x;
        Crossing crossing;
        if ((u < 0.0 || v < 0.0 || w < 0.0) && (u > 0.0 || v > 0.0 || w > 0.0)) return crossing;
        crossing.grazes = u == 0.0 || v == 0.0 || w == 0.0;
        const double sum = u + v + w;
        if (sum == 0.0) return crossing;  // in the triangle's plane
        const double fraction = (u * p.z + v * q.z + w * r.z) / (sum * direction_[z_]);
        if (!(fraction >= -fraction_slack_ && fraction <= 1.0 + fraction_slack_)) {
            return Crossing{};
        }
        crossing.exists = true;
        crossing.fraction = std::clamp(fraction, 0.0, 1.0);
        return crossing;
    }

    Vec3 at(double fraction) const { return from_ + fraction * direction_; }

private:
    struct Sheared {
        double x, y, z;
    };

    Sheared shear(const Vec3& point) const
    {
        const Vec3 relative = point - from_;
        return {relative[x_] - shear_x_ * relative[z_], relative[y_] - shear_y_ * relative[z_],
                relative[z_]};
    }

    Vec3 from_, direction_;
    Vec3 inverse_ = Vec3::Zero();
    double slack_;
    double fraction_slack_ = 0.0;
    int x_ = 0, y_ = 1, z_ = 2;
    double shear_x_ = 0.0, shear_y_ = 0.0;
};

/// The point of a triangle nearest to `p`, by the Voronoi region that `p` lies in
/// (Ericson 2005, Real-Time Collision Detection, section 5.1.5).
Vec3 nearest_of_triangle(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c)
{
    const Vec3 ab = b - a, ac = c - a, ap = p - a;
    const double d1 = ab.dot(ap), d2 = ac.dot(ap);
    if (d1 <= 0.0 && d2 <= 0.0) return a;
    const Vec3 bp = p - b;
    const double d3 = ab.dot(bp), d4 = ac.dot(bp);
    if (d3 >= 0.0 && d4 <= d3) return b;
    const double vc = d1 * d4 - d3 * d2;
    if (vc <= 0.0 && d1 >= 0.0 && d3 <= 0.0) return a + d1 / (d1 - d3) * ab;
    const Vec3 cp = p - c;
    const double d5 = ab.dot(cp), d6 = ac.dot(cp);
    if (d6 >= 0.0 && d5 <= d6) return c;
    const double vb = d5 * d2 - d1 * d6;
    if (vb <= 0.0 && d2 >= 0.0 && d6 <= 0.0) return a + d2 / (d2 - d6) * ac;
    const double va = d3 * d6 - d5 * d4;
    if (va <= 0.0 && d4 >= d3 && d5 >= d6) {
        return b + (d4 - d3) / ((d4 - d3) + (d5 - d6)) * (c - b);
    }
    const double sum = va + vb + vc;
    return a + vb / sum * ab + vc / sum * ac;
}

/// A tree of boxes over triangles. CGAL builds it and walks through it; the tests at its nodes and
/// leaves are ours, because CGAL's make intersection objects and cost several times as much.
class TriangleTree {
public:
    explicit TriangleTree(const TriangleMesh& mesh)
    {
        for (const std::array<int, 3>& triangle : mesh.triangles) {
            Corners corners;
            for (std::size_t k = 0; k < 3; ++k) {
                corners[k] = mesh.points[static_cast<std::size_t>(triangle[k])];
            }
            corners_.push_back(corners);
            const auto cgal = [&](const Vec3& p) { return Kernel::Point_3(p.x(), p.y(), p.z()); };
            triangles_.emplace_back(cgal(corners[0]), cgal(corners[1]), cgal(corners[2]));
        }
        tree_.insert(triangles_.cbegin(), triangles_.cend());
        tree_.build();  // now: a first query would build it, which is no constant operation
    }

    TriangleTree(const TriangleTree&) = delete;
    TriangleTree& operator=(const TriangleTree&) = delete;

    using Corners = std::array<Vec3, 3>;
    const Corners& corners(int triangle) const
    {
        return corners_[static_cast<std::size_t>(triangle)];
    }
    int index(const Primitive& primitive) const
    {
        return static_cast<int>(primitive.id() - triangles_.cbegin());
    }
    template <typename Walk>
    void walk(Walk& walk) const
    {
        tree_.traversal(0, walk);
    }
    template <typename Walk>
    void walk_nearest_first(Walk& walk) const
    {
        tree_.traversal_with_priority(0, walk);
    }

private:
    std::vector<Corners> corners_;
    Triangles triangles_;
    CGAL::AABB_tree<Traits> tree_;
};

// Walks through the tree, in the form that CGAL asks for. The query is held by the walk itself, so
// the one that CGAL hands through is a dummy.

struct FirstHitWalk {
    const TriangleTree& tree;
    const Segment& segment;
    int triangle = -1;
    double fraction = 1.0;

    bool go_further() const { return true; }
    bool do_intersect(int, const Node& node) const { return segment.meets(node.bbox(), fraction); }
    void intersection(int, const Primitive& primitive)
    {
        const int candidate = tree.index(primitive);
        const auto& [a, b, c] = tree.corners(candidate);
        const Segment::Crossing crossing = segment.crossing(a, b, c);
        if (!crossing.exists) return;
        // On an edge two triangles are hit alike: the smaller index makes the answer definite.
        const bool is_tie = crossing.fraction == fraction && candidate < triangle;
        if (triangle < 0 || crossing.fraction < fraction || is_tie) {
            triangle = candidate;
            fraction = crossing.fraction;
        }
    }
};

struct CountCrossingsWalk {
    const TriangleTree& tree;
    const Segment& segment;
    int crossings = 0;
    bool grazes = false;

    bool go_further() const { return !grazes; }
    bool do_intersect(int, const Node& node) const { return segment.meets(node.bbox(), 1.0); }
    void intersection(int, const Primitive& primitive)
    {
        const auto& [a, b, c] = tree.corners(tree.index(primitive));
        const Segment::Crossing crossing = segment.crossing(a, b, c);
        grazes = grazes || crossing.grazes;
        crossings += crossing.exists ? 1 : 0;
    }
};

double squared_distance_between(const Vec3& point, const CGAL::Bbox_3& box)
{
    double sum = 0.0;
    for (int axis = 0; axis < 3; ++axis) {
        const double outside =
            std::max({box.min(axis) - point[axis], point[axis] - box.max(axis), 0.0});
        sum += outside * outside;
    }
    return sum;
}

struct NearestWalk {
    using Priority = double;

    const TriangleTree& tree;
    const Vec3& point;
    double squared_share = 1.0;  ///< of the distance found, within which a nearer one is looked for
    int triangle = -1;
    Vec3 nearest = Vec3::Zero();
    double squared_distance = std::numeric_limits<double>::infinity();

    bool go_further() const { return true; }
    bool do_intersect(int, const Node& node) const
    {
        return squared_distance_between(point, node.bbox()) <= squared_share * squared_distance;
    }
    std::pair<bool, Priority> do_intersect_with_priority(int, const Node& node) const
    {
        const double box_distance = squared_distance_between(point, node.bbox());
        // The larger goes first.
        return {box_distance <= squared_share * squared_distance, -box_distance};
    }
    void intersection(int, const Primitive& primitive)
    {
        const int candidate = tree.index(primitive);
        const auto& [a, b, c] = tree.corners(candidate);
        const Vec3 candidate_point = nearest_of_triangle(point, a, b, c);
        const double candidate_distance = (candidate_point - point).squaredNorm();
        const bool is_tie = candidate_distance == squared_distance && candidate < triangle;
        if (candidate_distance < squared_distance || is_tie) {
            triangle = candidate;
            nearest = candidate_point;
            squared_distance = candidate_distance;
        }
    }
};

struct ComesNearerWalk {
    const TriangleTree& tree;
    const Vec3& point;
    double squared_distance;
    bool found = false;

    bool go_further() const { return !found; }
    bool do_intersect(int, const Node& node) const
    {
        return squared_distance_between(point, node.bbox()) < squared_distance;
    }
    void intersection(int, const Primitive& primitive)
    {
        const auto& [a, b, c] = tree.corners(tree.index(primitive));
        found =
            found || (nearest_of_triangle(point, a, b, c) - point).squaredNorm() < squared_distance;
    }
};

struct WithinWalk {
    const TriangleTree& tree;
    const Vec3& point;
    double squared_distance;
    std::vector<WallPoint> found = {};

    bool go_further() const { return true; }
    bool do_intersect(int, const Node& node) const
    {
        return squared_distance_between(point, node.bbox()) <= squared_distance;
    }
    void intersection(int, const Primitive& primitive)
    {
        WallPoint candidate;
        candidate.triangle = tree.index(primitive);
        const auto& [a, b, c] = tree.corners(candidate.triangle);
        candidate.point = nearest_of_triangle(point, a, b, c);
        candidate.distance = (candidate.point - point).norm();
        if (candidate.distance * candidate.distance <= squared_distance) found.push_back(candidate);
    }
};

TriangleMesh joined(TriangleMesh mesh, const TriangleMesh& other)
{
    const int offset = static_cast<int>(mesh.points.size());
    mesh.points.insert(mesh.points.end(), other.points.begin(), other.points.end());
    for (const auto& [a, b, c] : other.triangles) {
        mesh.triangles.push_back({a + offset, b + offset, c + offset});
    }
    return mesh;
}

/// Unit directions that are spread over the sphere by irrational steps, so that none lies along an
/// axis or in a plane of symmetry, where meshes have their edges.
Vec3 ray_direction(int ray)
{
    constexpr double golden = std::numbers::phi - 1.0;
    const double turns = golden * (ray + 1);
    const double height = 2.0 * (turns - std::floor(turns)) - 1.0;
    const double angle = std::numbers::sqrt2 * (ray + 1);
    const double radius = std::sqrt(1.0 - height * height);
    return {radius * std::cos(angle), radius * std::sin(angle), height};
}

}  // namespace

struct WallTree::Impl {
    TriangleMesh closed;  ///< the wall's triangles first
    TriangleTree wall;
    TriangleTree lumen;
    Box bounds;
    double diagonal;  ///< of the bounds [m]
    double slack;     ///< [m]
    std::vector<Vec3> normals;

    Impl(const Vessel& vessel, const TriangleMesh& lined_wall)
        : closed(close_openings(vessel).mesh),
          wall(lined_wall),
          lumen(closed),
          bounds(bounding_box(closed)),
          diagonal((bounds.upper - bounds.lower).norm()),
          // Some tens of rounding errors of a coordinate: a path cut into pieces at the wall must
          // not pass between the end of one piece and the start of the next.
          slack(1e-14 * diagonal)
    {
        for (std::size_t triangle = 0; triangle < lined_wall.triangles.size(); ++triangle) {
            normals.push_back(area_vector(lined_wall, static_cast<int>(triangle)).normalized());
        }
    }

    const Vec3& normal(int triangle) const { return normals[static_cast<std::size_t>(triangle)]; }
};

WallTree::WallTree(const Vessel& vessel) : WallTree(vessel, TriangleMesh{}) {}
WallTree::WallTree(const Vessel& vessel, const TriangleMesh& lining)
{
    if (vessel.wall.triangles.empty()) throw InputError("the vessel's wall has no triangles");
    impl_ = std::make_unique<Impl>(vessel, joined(vessel.wall, lining));
}
WallTree::~WallTree() = default;
WallTree::WallTree(WallTree&&) noexcept = default;
WallTree& WallTree::operator=(WallTree&&) noexcept = default;

std::optional<WallHit> WallTree::first_hit(const Vec3& from, const Vec3& to) const
{
    if (from == to) return std::nullopt;
    const Segment segment(from, to, impl_->slack);
    FirstHitWalk walk{impl_->wall, segment};
    impl_->wall.walk(walk);
    if (walk.triangle < 0) return std::nullopt;
    return WallHit{walk.triangle, walk.fraction, segment.at(walk.fraction),
                   impl_->normal(walk.triangle)};
}

WallPoint WallTree::nearest(const Vec3& point) const
{
    return nearly_nearest(point, 0.0);
}

WallPoint WallTree::nearly_nearest(const Vec3& point, double relative_error) const
{
    if (!(relative_error >= 0.0 && relative_error < 1.0)) {
        throw InputError(
            fmt::format("the relative error of a distance is {:.6g}; allowed are 0 to less than 1",
                        relative_error));
    }
    NearestWalk walk{impl_->wall, point, (1.0 - relative_error) * (1.0 - relative_error)};
    impl_->wall.walk_nearest_first(walk);
    return {walk.triangle, walk.nearest, impl_->normal(walk.triangle),
            std::sqrt(walk.squared_distance)};
}

bool WallTree::comes_nearer(const Vec3& point, double distance) const
{
    ComesNearerWalk walk{impl_->wall, point, distance * distance};
    impl_->wall.walk(walk);
    return walk.found;
}

std::vector<WallPoint> WallTree::within(const Vec3& point, double distance) const
{
    WithinWalk walk{impl_->wall, point, distance * distance};
    impl_->wall.walk(walk);
    std::sort(walk.found.begin(), walk.found.end(),
              [](const WallPoint& a, const WallPoint& b) { return a.triangle < b.triangle; });
    for (WallPoint& candidate : walk.found)
        candidate.normal = impl_->normal(candidate.triangle);
    return std::move(walk.found);
}

bool WallTree::contains(const Vec3& point) const
{
    if (!((point.array() >= impl_->bounds.lower.array()).all() &&
          (point.array() <= impl_->bounds.upper.array()).all())) {
        return false;
    }
    constexpr int max_rays = 64;
    for (int ray = 0; ray < max_rays; ++ray) {
        const Segment segment(point, point + impl_->diagonal * ray_direction(ray), impl_->slack);
        CountCrossingsWalk walk{impl_->lumen, segment};
        impl_->lumen.walk(walk);
        if (!walk.grazes) return walk.crossings % 2 == 1;
    }
    return false;  // every ray grazes an edge: the point lies on the surface
}

}  // namespace braidzone
