#pragma once

#include "core/vector.hpp"
#include "deploy/node_contact.hpp"

#include <functional>
#include <numbers>

namespace braidzone {

/// Nose of the part that presses: a blade whose rounded edge runs across the device, or a flat
/// plate wider than the device is long.
enum class PressHead { cylinder, flat };

/// A V-notch press bench: a block with a groove, and a head above the middle of the groove.
///
/// The groove runs along y; the block's top is the plane z = 0 and the head moves along -z. The
/// section in the plane of x and z, the same at every y:
///
///     top  ______        ______ z = 0      width: between the points in which the groove's
///                \      /                  faces and the top would meet without their rounding
///                 \    /
///                  \  /   angle between the faces
///                   \/
///
/// Both halves of the block are convex, as is the head: each is a surface of its own for contact.
struct PressBench {
    double notch_width = 10e-3;                   ///< [m]
    double notch_angle = 0.5 * std::numbers::pi;  ///< between the groove's faces, in (0, pi) [rad]
    double edge_radius = 0.5e-3;                  ///< of the groove's rounded edges; >= 0 [m]
    PressHead head = PressHead::cylinder;
    double head_radius = 2e-3;  ///< of a cylinder's nose [m]
};

/// The piece of a solid's surface that is nearest to a point.
struct SolidDistance {
    double distance = 0.0;        ///< negative inside the solid [m]
    Vec3 normal = Vec3::UnitZ();  ///< out of the solid, unit
};

/// Distance of a point to one half of the notched block.
/// @param side  +1: the half at positive x, -1: the one at negative x
SolidDistance distance_to_block(const PressBench& bench, int side, const Vec3& point);

/// Distance of a point to the head.
/// @param height  z of the head's lowest line [m]
SolidDistance distance_to_head(const PressBench& bench, double height, const Vec3& point);

/// Depth of the groove below the block's top, to where its faces meet [m].
double notch_depth(const PressBench& bench);

/// A convex solid as an obstacle for nodes outside it. A plane that touches it keeps a node out
/// however far the node slides. A segment passes its surface if it begins beyond `reach` and ends
/// inside, which holds for steps that are short against the solid.
/// @param distance  of a point; called for as long as the obstacle is in use
/// @param reach     up to which distance beyond the asked one nodes learn of the solid's plane [m]:
///                  several nodes that come to touch in one step are then found together
Obstacle solid_obstacle(std::function<SolidDistance(const Vec3& point)> distance, double reach);

}  // namespace braidzone
