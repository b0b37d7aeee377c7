#include "support/devices_of_any_size.hpp"
#include "support/hidden/hidden_effect.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace braidzone::hidden {
namespace {

/// A narrower device would lie loose in the vessel.
double possible_diameter_change(EffectSize size, std::mt19937& random)
{
    if (between(0.0, 1.0, random) < 0.4)
        return -sized(size, {0.05e-3, 0.08e-3, 0.12e-3, 0.18e-3}, random);
    return sized(size, {0.08e-3, 0.15e-3, 0.25e-3, 0.4e-3}, random);
}

/// The braid of another size altogether: its angle and coefficients too.
std::map<std::string, double> hide_diameter(HiddenStory& story, EffectSize size,
                                            std::mt19937& random)
{
    const double change = possible_diameter_change(size, random);
    FlowDiverter& device = story.scene.device;
    const FlowDiverter other =
        test::pipeline(device.nominal_diameter + change, device.nominal_length);
    device.nominal_diameter = other.nominal_diameter;
    device.braid_ratio = other.braid_ratio;
    device.surface_coefficient = other.surface_coefficient;
    device.radial_coefficient = other.radial_coefficient;
    device.reference_node_area = other.reference_node_area;
    return {{"change", change}};
}

/// Not alike all along: the angle drifts by a fifth of the change from end to end.
std::map<std::string, double> hide_ratio(HiddenStory& story, EffectSize size, std::mt19937& random)
{
    const double change = either_sign(sized(size, {0.06, 0.1, 0.16, 0.25}, random), random);
    const double drift = either_sign(0.1 * change, random);
    const double length = story.scene.device.nominal_length;
    const auto before = story.scene.pitch;
    story.scene.pitch = [=](double from_distal) {
        return before(from_distal) * (1.0 + change + drift * (2.0 * from_distal / length - 1.0));
    };
    return {{"relative_change", change}};
}

/// Torque of the operator's hand: the wires that it tightens hold the device in a waist, a
/// Lorentzian along it that is slightly oval, and turn one end against the other.
struct Torque {
    double centre = 0.0;      ///< arc length [m]
    double half_width = 0.0;  ///< [m]
    double depth = 0.0;       ///< of the waist below the nominal radius [m]
    double ovality = 0.0;     ///< share of the depth
    double direction = 0.0;   ///< of the oval's narrow side [rad]
    double turn = 0.0;        ///< [rad]
};

Obstacle waist(const Torque& torque, double nominal_radius)
{
    return [=](const RowPoint& at) {
        const double u = (at.arc_length - torque.centre) / torque.half_width;
        const Vec3 away = at.point - at.axis.origin;
        const double angle = std::atan2(away.dot(at.axis.binormal), away.dot(at.axis.normal));
        const double oval = 1.0 + torque.ovality * std::cos(2.0 * (angle - torque.direction));
        return beyond_obstacle(away.norm() - nominal_radius, torque.depth * oval,
                               1.0 / (1.0 + u * u));
    };
}

std::map<std::string, double> hide_twist(HiddenStory& story, EffectSize size, std::mt19937& random)
{
    const Belief& belief = story.belief;
    const double nominal = belief.device.nominal_radius();
    const double held =
        nominal - 0.5 * (belief.phantom.proximal_radius + belief.phantom.distal_radius);
    Torque torque;
    torque.centre = along_device(belief, random);
    torque.half_width = between(0.8e-3, 1.6e-3, random);
    const double depth = sized(size, {0.08e-3, 0.15e-3, 0.25e-3, 0.4e-3}, random);
    torque.depth = held + depth;
    torque.ovality = between(0.05, 0.2, random);
    torque.direction = between(0.0, std::numbers::pi, random);
    torque.turn = either_sign(between(0.2, 0.6, random), random);
    story.scene.obstacles.push_back(waist(torque, nominal));
    story.scene.turn = [=](double arc_length) {
        return torque.turn / std::numbers::pi *
               std::atan((arc_length - torque.centre) / torque.half_width);
    };
    return {{"centre", torque.centre}, {"depth", depth}};
}

std::map<std::string, double> hide_free_hub(HiddenStory& story, EffectSize size,
                                            std::mt19937& random)
{
    story.scene.hub_pull = sized(size, {0.06e-3, 0.1e-3, 0.16e-3, 0.25e-3}, random);
    return {{"shift", story.scene.hub_pull}};
}

/// A cone about a line beside the axis, inside which an end of the device stays.
struct ClosedEnd {
    bool is_distal = false;
    double length = 0.0;        ///< of the cone, from that end [m]
    double end_radius = 0.0;    ///< at the end [m]
    double eccentricity = 0.0;  ///< of the cone's middle at the end [m]
    double direction = 0.0;     ///< of it, about the axis' frame [rad]
};

Obstacle cone(const ClosedEnd& end, const FlowDiverter& device)
{
    const double widest = 1.05 * device.nominal_radius(), length = device.nominal_length;
    return [=](const RowPoint& at) {
        const double from_end = end.is_distal ? at.from_distal : length - at.from_distal;
        const double share = 1.0 - from_end / end.length;
        if (share <= 0.0) return -widest;
        const Vec3 aside =
            std::cos(end.direction) * at.axis.normal + std::sin(end.direction) * at.axis.binormal;
        const Vec3 middle = at.axis.origin + share * end.eccentricity * aside;
        return (at.point - middle).norm() - std::lerp(widest, end.end_radius, share);
    };
}

std::map<std::string, double> hide_closed_end(bool is_distal, HiddenStory& story, EffectSize size,
                                              std::mt19937& random)
{
    const Phantom& phantom = story.belief.phantom;
    ClosedEnd end;
    end.is_distal = is_distal;
    end.length = sized(size, {2e-3, 3e-3, 4.5e-3, 6e-3}, random);
    const double wall = is_distal ? phantom.distal_radius : phantom.proximal_radius;
    end.end_radius = wall * (1.0 - sized(size, {0.06, 0.1, 0.17, 0.28}, random));
    end.eccentricity = between(0.2, 0.7, random) * (wall - end.end_radius);
    end.direction = between(0.0, 2.0 * std::numbers::pi, random);
    story.scene.obstacles.push_back(cone(end, story.belief.device));
    return {{"cone_length", end.length}, {"shrink", 1.0 - end.end_radius / wall}};
}

std::map<std::string, double> hide_closed_proximal(HiddenStory& story, EffectSize size,
                                                   std::mt19937& random)
{
    return hide_closed_end(false, story, size, random);
}

std::map<std::string, double> hide_closed_distal(HiddenStory& story, EffectSize size,
                                                 std::mt19937& random)
{
    return hide_closed_end(true, story, size, random);
}

}  // namespace

std::vector<EffectMaker> device_effects()
{
    return {{"nominal_diameter", true, hide_diameter},
            {"braid_ratio", true, hide_ratio},
            {"axial_twist", true, hide_twist},
            {"free_hub", true, hide_free_hub},
            {"incomplete_opening_proximal", true, hide_closed_proximal},
            {"incomplete_opening_distal", true, hide_closed_distal}};
}

}  // namespace braidzone::hidden
