#include "discrepancy/imaging.hpp"

namespace braidzone {

Vec3 in_vessel_frame(const Imaging& imaging, const Vec3& point)
{
    const double angle = imaging.rotation.norm();
    Vec3 turned = point - imaging.pivot;
    if (angle > 0.0) turned = Eigen::AngleAxisd(angle, imaging.rotation / angle) * turned;
    return turned + imaging.pivot + imaging.shift;
}

}  // namespace braidzone
