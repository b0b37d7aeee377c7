#include "support/hidden/straightened_bend.hpp"

namespace braidzone::hidden {

std::vector<PhantomSegment> straightened(const std::vector<PhantomSegment>& segments, double share)
{
    std::vector<PhantomSegment> result;
    for (const PhantomSegment& segment : segments) {
        if (segment.angle == 0.0) {
            result.push_back(segment);
            continue;
        }
        for (const double kept : {1.0, 1.0 - share, 1.0}) {
            PhantomSegment third = segment;
            third.length /= 3.0;
            third.angle *= kept / 3.0;
            result.push_back(third);
        }
    }
    return result;
}

Eigen::Isometry3d aligned(const PhantomAxis& axis, const PhantomAxis& onto, double from, double to)
{
    constexpr int count = 60;
    Eigen::Matrix3Xd source(3, count), target(3, count);
    for (int i = 0; i < count; ++i) {
        const double s = from + (to - from) * i / (count - 1);
        source.col(i) = section_along(axis, s).origin;
        target.col(i) = section_along(onto, s).origin;
    }
    return Eigen::Isometry3d(Eigen::umeyama(source, target, false));
}

}  // namespace braidzone::hidden
