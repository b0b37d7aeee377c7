#pragma once

#include "core/phantom.hpp"
#include "core/phantom_axis.hpp"

#include <Eigen/Geometry>

#include <vector>

namespace braidzone::hidden {

/// A vessel that gives up a share of its curvature in the middle third of each bend only.
/// @param share  0 (as it was) to 1 (that third is straight)
std::vector<PhantomSegment> straightened(const std::vector<PhantomSegment>& segments, double share);

/// The rigid motion that lays one axis upon another best over a stretch (least squares, Umeyama
/// 1991, doi 10.1109/34.88573): how a scan after the deployment is registered.
/// @param from, to  arc lengths [m]
Eigen::Isometry3d aligned(const PhantomAxis& axis, const PhantomAxis& onto, double from, double to);

}  // namespace braidzone::hidden
