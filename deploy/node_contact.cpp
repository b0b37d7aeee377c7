#include "deploy/node_contact.hpp"

#include <algorithm>
#include <cmath>

namespace braidzone {

namespace {

/// Part of the limit by which rounding may make a settled node seem to stick.
constexpr double limit_slack = 1e-6;

/// Way from the anchor along the surface [m].
Vec3 slip(const NodeContact& contact, const Vec3& place)
{
    const Vec3 outward = contact.normal_force.normalized();
    const Vec3 way = place - contact.anchor;
    return way - outward.dot(way) * outward;
}

/// Where the spring to the anchor gives way [m].
double slip_limit(const NodeContact& contact, const ContactLaw& law)
{
    if (std::isinf(law.friction)) return law.friction;
    return law.friction * contact.normal_force.norm() / law.tangential_stiffness;
}

}  // namespace

double gap_after(const ContactPlane& plane, const Vec3& step)
{
    return plane.gap - plane.outward.dot(step);
}

void update(NodeContact& contact, const ContactLaw& law, std::vector<ContactPlane> planes,
            const Vec3& position)
{
    contact.planes = std::move(planes);
    contact.position = position;
    contact.normal_force = Vec3::Zero();
    for (ContactPlane& plane : contact.planes) {
        plane.gap -= law.offset;
        plane.acts = plane.gap < 0.0;
        contact.normal_force -= law.normal_stiffness * std::min(0.0, plane.gap) * plane.outward;
    }
    contact.anchored = contact.anchored && touches(contact);
}

bool touches(const NodeContact& contact)
{
    return contact.normal_force.squaredNorm() > 0.0;
}

double contact_energy(const NodeContact& contact, const ContactLaw& law, const Vec3& place)
{
    double energy = 0.0;
    for (const ContactPlane& plane : contact.planes) {
        const double depth = std::min(0.0, gap_after(plane, place - contact.position));
        energy += 0.5 * law.normal_stiffness * depth * depth;
    }
    if (!contact.anchored) return energy;
    const double way = slip(contact, place).norm(), limit = slip_limit(contact, law);
    energy += way <= limit ? 0.5 * law.tangential_stiffness * way * way
                           : law.tangential_stiffness * limit * (way - 0.5 * limit);
    return energy;
}

Vec3 contact_gradient(const NodeContact& contact, const ContactLaw& law)
{
    Vec3 gradient = Vec3::Zero();
    for (const ContactPlane& plane : contact.planes) {
        if (plane.acts) gradient -= law.normal_stiffness * plane.gap * plane.outward;
    }
    if (!contact.anchored) return gradient;
    const Vec3 way = slip(contact, contact.position);
    const double length = way.norm(), limit = slip_limit(contact, law);
    gradient += law.tangential_stiffness * (length <= limit ? way : Vec3(limit / length * way));
    return gradient;
}

Eigen::Matrix3d contact_hessian(const NodeContact& contact, const ContactLaw& law)
{
    Eigen::Matrix3d hessian = Eigen::Matrix3d::Zero();
    for (const ContactPlane& plane : contact.planes) {
        if (plane.acts) hessian += law.normal_stiffness * plane.outward * plane.outward.transpose();
    }
    if (!contact.anchored) return hessian;
    const Vec3 outward = contact.normal_force.normalized();
    const Eigen::Matrix3d along = Eigen::Matrix3d::Identity() - outward * outward.transpose();
    const Vec3 way = slip(contact, contact.position);
    const double length = way.norm(), limit = slip_limit(contact, law);
    if (length < (1.0 - limit_slack) * limit) return hessian + law.tangential_stiffness * along;
    // A sliding node meets no resistance ahead that grows with its way, only sideways.
    if (!(length > 0.0)) return hessian;
    const Vec3 direction = way / length;
    return hessian +
           law.tangential_stiffness * limit / length * (along - direction * direction.transpose());
}

void settle(NodeContact& contact, const ContactLaw& law)
{
    if (!touches(contact)) return;
    if (!contact.anchored) {
        contact.anchored = true;
        contact.anchor = contact.position;
        return;
    }
    const Vec3 way = slip(contact, contact.position);
    const double length = way.norm(), limit = slip_limit(contact, law);
    if (length > limit) contact.anchor = contact.position - limit / length * way;
}

}  // namespace braidzone
