#pragma once

#include "core/vector.hpp"
#include "deploy/deployment.hpp"

#include <memory>

namespace braidzone {

/// The point of a device's surface that is nearest to some point.
struct SurfaceFoot {
    Vec3 point = Vec3::Zero();
    Vec3 normal = Vec3::UnitX();  ///< unit, outwards; interpolated between the crossings
    double distance = 0.0;        ///< signed: positive if the other point lies outside [m]
    double arc_length = 0.0;      ///< of the foot on the centerline [m]
    double angle = 0.0;           ///< about the ring's frame, -pi to pi [rad]
    int node = -1;                ///< crossing of the wires nearest to the foot
    bool is_on_rim = false;       ///< in the last row of rhombi at either end
};

/// Direction of a point from a ring's hub: angle from the frame's normal [rad], -pi to pi.
double angle_about(const CrossSection& ring, const Vec3& point);

/// The mid-surface of a deployed braid, each rhombus as two triangles, in a tree of boxes (CGAL).
/// Queries may run in several threads.
class DeviceSurface {
public:
    explicit DeviceSurface(const Deployment& deployment);
    ~DeviceSurface();
    DeviceSurface(DeviceSurface&&) noexcept;
    DeviceSurface& operator=(DeviceSurface&&) noexcept;

    SurfaceFoot nearest(const Vec3& point) const;

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace braidzone
