#pragma once

#include "core/triangle_mesh.hpp"
#include "core/vector.hpp"
#include "deploy/deployment.hpp"
#include "discrepancy/imaging_chain.hpp"

#include <memory>

namespace braidzone {

/// The point of a device's surface that is nearest to some point.
struct SurfaceFoot {
    Vec3 point = Vec3::Zero();
    Vec3 normal = Vec3::UnitX();  ///< unit, outwards; interpolated between the crossings
    /// Of the other point from the face that is seen, signed: positive if it lies outside [m].
    double distance = 0.0;
    double arc_length = 0.0;  ///< of the foot on the centerline [m]
    double angle = 0.0;       ///< about the ring's frame, -pi to pi [rad]
    int node = -1;            ///< crossing of the wires nearest to the foot
    bool is_on_rim = false;   ///< in the last row of rhombi at either end
};

/// Direction of a point from a ring's hub: angle from the frame's normal [rad], -pi to pi.
double angle_about(const CrossSection& ring, const Vec3& point);

/// The surface of a deployed braid, each rhombus as two triangles, in a tree of boxes (CGAL): its
/// mid-surface, or what a volume shows of it. Queries may run in several threads.
class DeviceSurface {
public:
    /// The mid-surface of the wires.
    explicit DeviceSurface(const Deployment& deployment);
    /// The outer face of a sheet: distances are measured from its middle, less half its thickness.
    DeviceSurface(const Deployment& deployment, ImagedSheet sheet);
    ~DeviceSurface();
    DeviceSurface(DeviceSurface&&) noexcept;
    DeviceSurface& operator=(DeviceSurface&&) noexcept;

    SurfaceFoot nearest(const Vec3& point) const;

    /// The middle of the sheet, on which feet lie, and from there to the face that is seen [m].
    const TriangleMesh& middle() const;
    double half_thickness() const;

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace braidzone
