#include "core/phantom_axis.hpp"
#include "support/hidden/hidden_effect.hpp"

#include <cmath>
#include <numbers>

// What no catalogue knows: changes of the wall's shape and of what presses on the device.

namespace braidzone::hidden {
namespace {

/// Where a point is along and around the axis of the parent vessel, near a place on it.
struct AxisPlace {
    CrossSection section;
    double along(const Vec3& point) const { return (point - section.origin).dot(section.tangent); }
    double angle(const Vec3& point) const
    {
        const Vec3 away = point - section.origin;
        return std::atan2(away.dot(section.binormal), away.dot(section.normal));
    }
};

AxisPlace place_at(const HiddenStory& story, double arc_length)
{
    return {section_along(make_axis(story.scene.phantom.segments), arc_length)};
}

void add_unevenness(HiddenScene& scene, const WallLevel& more)
{
    const auto before = scene.unevenness;
    scene.unevenness = [=](const Vec3& point) { return before(point) + more(point); };
}

void add_load(HiddenScene& scene, const std::function<double(const SheetPoint&)>& more)
{
    const auto before = scene.load;
    scene.load = [=](const SheetPoint& at) { return before(at) + more(at); };
}

double bell(double value, double width)
{
    return std::exp(-0.5 * value * value / (width * width));
}

/// A plaque that the scan of the vessel did not show.
std::map<std::string, double> hide_dent(HiddenStory& story, EffectSize size, std::mt19937& random)
{
    const double depth = sized(size, {0.1e-3, 0.17e-3, 0.25e-3, 0.4e-3}, random);
    const double width = between(0.9e-3, 1.4e-3, random);
    const double centre = along_device(story.belief, random);
    // On the wall away from the sac.
    const double angle = between(-0.5, 0.5, random) * std::numbers::pi;
    const CrossSection section = place_at(story, centre).section;
    const Vec3 place = section.origin +
                       story.scene.phantom.distal_radius *
                           (std::cos(angle) * section.normal + std::sin(angle) * section.binormal);
    add_unevenness(story.scene,
                   [=](const Vec3& point) { return -depth * bell((point - place).norm(), width); });
    return {{"centre", centre}, {"depth", depth}};
}

/// The vessel is pressed flat over a stretch.
std::map<std::string, double> hide_oval(HiddenStory& story, EffectSize size, std::mt19937& random)
{
    const double depth = sized(size, {0.08e-3, 0.13e-3, 0.2e-3, 0.3e-3}, random);
    const double centre = along_device(story.belief, random);
    const double direction = between(0.0, std::numbers::pi, random);
    const AxisPlace place = place_at(story, centre);
    add_unevenness(story.scene, [=](const Vec3& point) {
        return depth * std::cos(2.0 * (place.angle(point) - direction)) *
               bell(place.along(point), 3e-3);
    });
    return {{"centre", centre}, {"depth", depth}};
}

/// The braid is drawn into a side branch that the case does not have.
std::map<std::string, double> hide_herniation(HiddenStory& story, EffectSize size,
                                              std::mt19937& random)
{
    const double opening = between(0.8e-3, 1.2e-3, random);
    const double pressure = sized(size, {6e3, 10e3, 16e3, 25e3}, random);
    const double centre = along_device(story.belief, random);
    const double angle = between(-0.4, 0.4, random) * std::numbers::pi;
    const CrossSection section = place_at(story, centre).section;
    const double radius = story.scene.phantom.distal_radius;
    const Vec3 mouth = section.origin + radius * (std::cos(angle) * section.normal +
                                                  std::sin(angle) * section.binormal);
    add_unevenness(story.scene, [=](const Vec3& point) {
        const double from_rim = ((point - mouth).norm() - opening) / 0.1e-3;
        return 0.5e-3 * (1.0 - std::tanh(from_rim));
    });
    add_load(story.scene, [=](const SheetPoint& at) {
        const double around = radius * std::remainder(at.angle - angle, 2.0 * std::numbers::pi);
        return pressure * bell(std::hypot(at.arc_length - centre, around), 0.6 * opening);
    });
    return {{"centre", centre}, {"opening", opening}};
}

/// A ridge that winds along the wall.
std::map<std::string, double> hide_ridge(HiddenStory& story, EffectSize size, std::mt19937& random)
{
    constexpr double half_angle = 0.35;  // of the ridge, standard deviation [rad]
    const double height = sized(size, {0.08e-3, 0.14e-3, 0.22e-3, 0.35e-3}, random);
    const double pitch = either_sign(between(5e-3, 9e-3, random), random);
    const double phase = between(0.0, 2.0 * std::numbers::pi, random);
    const double widest = story.scene.phantom.proximal_radius;
    story.scene.obstacles.push_back([=](const RowPoint& at) {
        const AxisPlace place{at.axis};
        const double off = std::remainder(
            place.angle(at.point) - phase - 2.0 * std::numbers::pi * at.arc_length / pitch,
            2.0 * std::numbers::pi);
        return beyond_obstacle((at.point - at.axis.origin).norm() - widest, height,
                               bell(off, half_angle));
    });
    return {{"height", height}, {"pitch", pitch}};
}

/// An edge folds the device in from one side over a short stretch.
std::map<std::string, double> hide_kink(HiddenStory& story, EffectSize size, std::mt19937& random)
{
    const double depth = sized(size, {0.12e-3, 0.2e-3, 0.3e-3, 0.5e-3}, random);
    const double centre = along_device(story.belief, random);
    const double direction = between(0.0, 2.0 * std::numbers::pi, random);
    const double radius = story.scene.phantom.distal_radius;
    story.scene.obstacles.push_back([=](const RowPoint& at) {
        const Vec3 side =
            std::cos(direction) * at.axis.normal + std::sin(direction) * at.axis.binormal;
        return beyond_obstacle((at.point - at.axis.origin).dot(side) - radius, depth,
                               bell(at.arc_length - centre, 0.6e-3));
    });
    return {{"centre", centre}, {"depth", depth}};
}

}  // namespace

std::vector<EffectMaker> unknown_effects()
{
    return {{"dent", false, hide_dent},
            {"oval", false, hide_oval},
            {"herniation", false, hide_herniation},
            {"ridge", false, hide_ridge},
            {"kink", false, hide_kink}};
}

}  // namespace braidzone::hidden
