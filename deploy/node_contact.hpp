#pragma once

#include "core/vector.hpp"

#include <Eigen/Core>

#include <functional>
#include <limits>
#include <optional>
#include <vector>

namespace braidzone {

/// A piece of a surface near a point, as the plane that the point must not pass.
struct ContactPlane {
    double gap = 0.0;              ///< of the point, negative where the surface presses [m]
    Vec3 outward = Vec3::UnitX();  ///< unit, towards the surface
    bool acts = false;             ///< in the step that is being found
};

/// A surface that nodes may touch: the vessel's wall, another device, a test bench.
struct Obstacle {
    /// Distance of a point to the surface, or less [m].
    std::function<double(const Vec3& point)> clearance;
    /// Adds a plane for each piece of the surface that is nearer than `range` [m]; gaps are
    /// distances, negative beyond the surface.
    std::function<void(const Vec3& point, double range, std::vector<ContactPlane>& planes)> pieces;
    /// The plane in which a segment first passes the surface, if it does: gap at its start.
    std::function<std::optional<ContactPlane>(const Vec3& from, const Vec3& to)> passage;
};

/// Forces between a node and surfaces.
///
/// Each piece of a surface (a triangle of the wall) that is nearer than `offset` presses on the
/// node by a spring: E = k_n g^2 / 2 with the gap g = distance - offset < 0. The sum is continuous
/// with its gradient, across edges between triangles too.
///
/// Along the surface a spring holds the node to its anchor, up to Coulomb's limit: with u the way
/// from the anchor along the surface and f_n the normal force,
///
///     E = k_t u^2 / 2                    for u <= u_max = mu f_n / k_t
///         k_t u_max (u - u_max / 2)      beyond
///
/// after which the anchor follows (`settle`). At infinite friction it stays. A node that begins to
/// touch slides freely until it is settled, so that it does not stick where a step towards rest
/// happens to have carried it.
struct ContactLaw {
    double offset = 0.0;                ///< gap at which the normal force begins [m]
    double normal_stiffness = 0.0;      ///< k_n, of a node [N/m]
    double tangential_stiffness = 0.0;  ///< k_t, of a node [N/m]
    double friction = 0.0;              ///< mu [-]; may be infinite
};

/// A node's contact. Planes are held fixed while the node takes a step.
struct NodeContact {
    std::vector<ContactPlane> planes;
    Vec3 position = Vec3::Zero();      ///< where the gaps were measured [m]
    Vec3 normal_force = Vec3::Zero();  ///< of the node on the surface, there [N]
    bool anchored = false;
    Vec3 anchor = Vec3::Zero();  ///< [m]; counts while anchored
};

/// Measures the gaps anew: `planes` with distances as gaps, at a node's position. A node that no
/// longer touches loses its anchor.
void update(NodeContact& contact, const ContactLaw& law, std::vector<ContactPlane> planes,
            const Vec3& position);

/// True if a piece of a surface presses on the node.
bool touches(const NodeContact& contact);

/// Energy of the contact for a node at a place near the one where its gaps were measured [J].
double contact_energy(const NodeContact& contact, const ContactLaw& law, const Vec3& place);

/// Gradient of the energy of the planes that act and of the anchor, in a quadratic model of the
/// energy around the node's position [N].
Vec3 contact_gradient(const NodeContact& contact, const ContactLaw& law);

/// Second derivatives of that model, positive semidefinite [N/m].
Eigen::Matrix3d contact_hessian(const NodeContact& contact, const ContactLaw& law);

/// Gap of a plane after a step of the node [m].
double gap_after(const ContactPlane& plane, const Vec3& step);

/// Anchors a node that touches where it is; an anchor that it has follows it if it slides, so that
/// it lags by u_max.
void settle(NodeContact& contact, const ContactLaw& law);

}  // namespace braidzone
