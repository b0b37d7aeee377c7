#pragma once

#include "core/phantom.hpp"
#include "core/phantom_axis.hpp"
#include "core/phantom_parts.hpp"

#include <vector>

namespace braidzone {

/// Where a tube is cut square, and the piece beyond it that is cut off.
struct PhantomEnd {
    Vec3 centre = Vec3::Zero();
    Vec3 outwards = Vec3::UnitX();  ///< unit, along the tube
    double radius = 0.0;            ///< of the tube; its larger half axis [m]
    std::size_t part = 0;           ///< index of the tube
};

/// A sac with triangles of their own size, where it is clear of the other parts.
struct PhantomDome {
    std::size_t part = 0;      ///< index of the sac
    double edge_length = 0.0;  ///< [m]
};

/// The lumen of a phantom as the smooth union of its parts.
struct PhantomShape {
    PhantomAxis axis;                ///< of the parent vessel
    std::vector<PhantomPart> parts;  ///< the parent vessel first
    std::vector<PhantomEnd> ends;    ///< the inlet first
    std::vector<PhantomDome> domes;
    double overhang = 0.0;      ///< length of a tube beyond its end [m]
    double blend_radius = 0.0;  ///< [m]
};

/// The parts of a phantom, put where they belong.
/// @throws ConfigError if a parameter is out of range, a sac or branch does not meet the parent
///         vessel, or a part reaches another one's opening
PhantomShape make_shape(const Phantom& phantom);

/// The level of the whole lumen: its zero is the wall, it is negative inside [m].
double level(const PhantomShape& shape, const Vec3& point);

/// Gradient of the level, by central differences over twice `step` [m].
Vec3 level_gradient(const PhantomShape& shape, const Vec3& point, double step);

}  // namespace braidzone
