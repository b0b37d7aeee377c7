#pragma once

#include "core/centerline.hpp"
#include "core/phantom.hpp"
#include "deploy/flow_diverter.hpp"
#include "support/hidden/yielding_wall.hpp"

#include <Eigen/Geometry>

#include <functional>
#include <limits>
#include <vector>

namespace braidzone::hidden {

/// A place on the device, as its loads see it.
struct SheetPoint {
    double arc_length = 0.0;   ///< of its row on the axis [m]
    double angle = 0.0;        ///< about the axis' frame [rad]
    double from_distal = 0.0;  ///< length of force-free braid from the distal end [m]
};

/// A point and the row of the device that it belongs to.
struct RowPoint {
    const Vec3& point;
    const CrossSection& axis;  ///< of the vessel, where the row is
    double arc_length = 0.0;   ///< of the row [m]
    double from_distal = 0.0;  ///< as above [m]
};

/// What holds a device besides the wall: depth beyond it [m], as `WallLevel`.
using Obstacle = std::function<double(const RowPoint&)>;

/// Room beside an obstacle [m]: more than a braid bulges into a neck, so that what holds it in one
/// place does not hold it elsewhere.
constexpr double obstacle_room = 0.5e-3;

/// Depth beyond an obstacle that stands `height` out of a surface at its middle (`share` 1), and
/// has room beside it (`share` 0).
inline double beyond_obstacle(double beyond_surface, double height, double share)
{
    return beyond_surface - obstacle_room + (obstacle_room + height) * share;
}

/// Everything that really happened to a device, other than its measurement.
struct HiddenScene {
    Phantom phantom;       ///< the true vessel
    FlowDiverter device;   ///< the true device
    double landing = 0.0;  ///< arc length of its distal end [m]
    /// Ring spacing at release over nominal, at an arc length.
    std::function<double(double)> spacing = [](double) { return 1.0; };
    /// Braid ratio over that of the device, at a length from the distal end.
    std::function<double(double)> pitch = [](double) { return 1.0; };
    /// What the wall is deeper (positive) or shallower than the phantom's at a point [m].
    WallLevel unevenness = [](const Vec3&) { return 0.0; };
    /// What pushes the device outwards, besides its springs [Pa].
    std::function<double(const SheetPoint&)> load = [](const SheetPoint&) { return 0.0; };
    WallSprings springs;  ///< of the wall, in real units
    /// Coulomb's coefficient between the rings and the wall along the vessel; or they do not slide.
    double friction = std::numeric_limits<double>::infinity();
    /// By which the hub of the ring that is held least moves towards where nothing holds it, others
    /// by their share [m].
    double hub_pull = 0.0;
    std::vector<Obstacle> obstacles;
    /// Angle by which the ring at an arc length is turned about the axis [rad].
    std::function<double(double)> turn = [](double) { return 0.0; };
    /// Brings the true vessel into the frame of the believed one.
    Eigen::Isometry3d frame = Eigen::Isometry3d::Identity();
};

}  // namespace braidzone::hidden
