#pragma once

#include "core/triangle_mesh.hpp"
#include "core/vessel.hpp"

#include <memory>
#include <optional>
#include <vector>

namespace braidzone {

/// Where a segment first meets the wall.
struct WallHit {
    int triangle = -1;      ///< of the vessel's wall
    double fraction = 0.0;  ///< along the segment, 0 at its start, 1 at its end
    Vec3 point = Vec3::Zero();
    Vec3 normal = Vec3::UnitX();  ///< unit normal of the triangle, out of the lumen
};

/// The nearest point of the wall.
struct WallPoint {
    int triangle = -1;
    Vec3 point = Vec3::Zero();
    Vec3 normal = Vec3::UnitX();  ///< unit normal of the triangle, out of the lumen
    double distance = 0.0;        ///< [m], not negative
};

/// Geometric queries on a vessel's wall through a tree of axis-aligned boxes (van den Bergen 1997;
/// CGAL's AABB tree). Cost is logarithmic in the triangles. Queries may run in several threads.
class WallTree {
public:
    explicit WallTree(const Vessel& vessel);
    /// A vessel lined with another surface in its lumen, a device that lies there, which stops and
    /// carries like the wall. Its triangles are numbered after the wall's, its normals point to the
    /// wall. `contains` does not know it.
    WallTree(const Vessel& vessel, const TriangleMesh& lining);
    ~WallTree();
    WallTree(WallTree&&) noexcept;
    WallTree& operator=(WallTree&&) noexcept;

    /// First intersection of the segment with the wall; none if it does not meet it. A segment
    /// within a triangle's plane does not count as meeting that triangle. A segment through an edge
    /// or a point of the wall hits one of the triangles there, however the numbers round.
    std::optional<WallHit> first_hit(const Vec3& from, const Vec3& to) const;

    /// Nearest point of the wall (the openings' caps do not count).
    WallPoint nearest(const Vec3& point) const;

    /// A point of the wall that is hardly farther than the nearest one: the nearest has at least
    /// (1 - relative_error) of its distance. Near the axis of a tube, where all of the wall is
    /// nearly as near, this costs far less.
    /// @param relative_error  0 (`nearest` itself) to less than 1
    /// @throws InputError if it is not
    WallPoint nearly_nearest(const Vec3& point, double relative_error) const;

    /// True if the wall comes nearer to a point than a distance [m]. In the middle of a tube, where
    /// all of the wall is as near as the nearest point, this costs far less than to find that.
    bool comes_nearer(const Vec3& point, double distance) const;

    /// The nearest point of every triangle of the wall that is within a distance [m], in the order
    /// of the triangles. Together they tell a crease of the wall from a face, as one point does
    /// not.
    std::vector<WallPoint> within(const Vec3& point, double distance) const;

    /// True inside the lumen: wall and flat caps over the openings. By the parity of a ray's
    /// crossings; a ray that grazes an edge is replaced by another one. For a point on the surface
    /// itself either answer may come.
    bool contains(const Vec3& point) const;

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace braidzone
