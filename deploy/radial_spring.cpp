#include "deploy/radial_spring.hpp"

#include <cmath>

namespace braidzone {

namespace {

/// Of the rest angle's sine: where the torsion part leaves its curve, see `radial_force`.
constexpr double smallest_sine_ratio = 0.5;

/// A radius, the sines of the braid angle there and at rest, and the radius beyond which the
/// torsion is continued along its tangent.
struct BraidAngle {
    double sine;
    double sine_at_rest;
    double cosine_per_radius;  ///< cos b0 / R0 [1/m]
    double last_radius;        ///< [m]
};

BraidAngle braid_angle(const RadialSpring& spring, double radius)
{
    const double cosine_at_rest = 1.0 / std::hypot(1.0, spring.braid_ratio);
    BraidAngle angle{};
    angle.sine_at_rest = spring.braid_ratio * cosine_at_rest;
    angle.cosine_per_radius = cosine_at_rest / spring.rest_radius;
    const double smallest_sine = smallest_sine_ratio * angle.sine_at_rest;
    angle.last_radius = std::sqrt(1.0 - smallest_sine * smallest_sine) / angle.cosine_per_radius;
    const double cosine = angle.cosine_per_radius * std::fmin(radius, angle.last_radius);
    angle.sine = std::sqrt(1.0 - cosine * cosine);
    return angle;
}

/// f_torsion and its derivative at min(radius, last_radius).
struct Torsion {
    double force;
    double slope;
};

Torsion torsion_at(const RadialSpring& spring, const BraidAngle& angle, double radius)
{
    const double r = std::fmin(radius, angle.last_radius);
    const double force = spring.torsion * r * (1.0 - angle.sine_at_rest / angle.sine);
    // d sin b / dr = -(cos b0 / R0)^2 r / sin b
    const double sine_slope = -angle.cosine_per_radius * angle.cosine_per_radius * r / angle.sine;
    const double slope =
        spring.torsion * (1.0 - angle.sine_at_rest / angle.sine +
                          r * angle.sine_at_rest * sine_slope / (angle.sine * angle.sine));
    return {force, slope};
}

}  // namespace

double radial_force(const RadialSpring& spring, double radius)
{
    double force = spring.bending * (spring.rest_radius - radius);
    if (spring.torsion == 0.0) return force;
    const BraidAngle angle = braid_angle(spring, radius);
    const Torsion torsion = torsion_at(spring, angle, radius);
    return force + torsion.force + torsion.slope * std::fmax(0.0, radius - angle.last_radius);
}

double radial_energy(const RadialSpring& spring, double radius)
{
    const double compression = spring.rest_radius - radius;
    double energy = 0.5 * spring.bending * compression * compression;
    if (spring.torsion == 0.0) return energy;
    const BraidAngle angle = braid_angle(spring, radius);
    const double twist = (angle.sine - angle.sine_at_rest) / angle.cosine_per_radius;
    const Torsion torsion = torsion_at(spring, angle, radius);
    const double beyond = std::fmax(0.0, radius - angle.last_radius);
    return energy + 0.5 * spring.torsion * twist * twist -
           beyond * (torsion.force + 0.5 * torsion.slope * beyond);
}

double radial_stiffness_at(const RadialSpring& spring, double radius)
{
    if (spring.torsion == 0.0) return spring.bending;
    return spring.bending - torsion_at(spring, braid_angle(spring, radius), radius).slope;
}

double radial_stiffness(const RadialSpring& spring)
{
    if (spring.torsion == 0.0) return spring.bending;
    return spring.bending + spring.torsion / (spring.braid_ratio * spring.braid_ratio);
}

RadialSpring at_rest_radius(const RadialSpring& spring, double radius)
{
    RadialSpring result = spring;
    result.rest_radius = radius;
    // The wires keep their length: cos b is proportional to the radius.
    const double ratio = radius / spring.rest_radius;
    const double square = (1.0 + spring.braid_ratio * spring.braid_ratio) / (ratio * ratio) - 1.0;
    result.braid_ratio = std::sqrt(std::fmax(0.0, square));
    return result;
}

RadialSpring scaled(const RadialSpring& spring, double factor)
{
    RadialSpring result = spring;
    result.bending *= factor;
    result.torsion *= factor;
    return result;
}

}  // namespace braidzone
