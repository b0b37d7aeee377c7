#include "discrepancy/imaging.hpp"

namespace braidzone {

namespace {

Eigen::AngleAxisd turn(const Vec3& rotation)
{
    const double angle = rotation.norm();
    return {angle, angle > 0.0 ? Vec3(rotation / angle) : Vec3::UnitX()};
}

}  // namespace

Vec3 in_vessel_frame(const Imaging& imaging, const Vec3& point)
{
    return turn(imaging.rotation) * (point - imaging.pivot) + imaging.pivot + imaging.shift;
}

Imaging moved_on(const Imaging& imaging, const Vec3& shift, const Vec3& rotation,
                 const Vec3& middle)
{
    const Eigen::AngleAxisd further = turn(rotation);
    const Eigen::AngleAxisd whole(further * turn(imaging.rotation));
    Imaging moved = imaging;
    moved.rotation = whole.angle() * whole.axis();
    moved.shift =
        further * (imaging.pivot + imaging.shift - middle) + middle + shift - imaging.pivot;
    return moved;
}

}  // namespace braidzone
