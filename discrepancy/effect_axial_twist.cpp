#include "discrepancy/effect.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace braidzone {
namespace {

constexpr double degree = std::numbers::pi / 180.0;

/// Where fits begin: such twists all along the device, a half width apart, as a waist is found from
/// half its width away. A narrow waist is not found from a wide one.
struct StartShape {
    double angle;       ///< [rad]
    double half_width;  ///< [m]
};
constexpr std::array<StartShape, 3> start_shapes = {
    {{100.0 * degree, 2.5e-3}, {150.0 * degree, 2.5e-3}, {75.0 * degree, 1.25e-3}}};

/// The angle over a stretch at which the flatter wires lie at nine tenths of the turn that no braid
/// reaches: x = t R0 d phi / ds (`axial_twist.hpp`), with 1.5 times the mean slope in the middle.
double steepest_angle(const FlowDiverter& device, double half_width)
{
    constexpr double largest_turn = 0.9, steepest_slope = 1.5;
    return largest_turn * 2.0 * half_width /
           (steepest_slope * device.braid_ratio * device.nominal_radius());
}

}  // namespace

/// The device was twisted at its release: torque of the delivery wire.
///
/// Over a stretch the rings are turned against each other, and the braid narrows to a waist
/// (`axial_twist.hpp`), seen where the waist is narrower than the vessel. Only the size of the
/// angle shows in the surface. Prior of the angle 100 degrees: it takes 110 degrees over 5 mm until
/// a 4 mm braid that is 10 % oversized leaves the wall, and more than 180 degrees over 4 mm would
/// lay one family of wires along the vessel. Key: deployment.twist.
Effect axial_twist_effect()
{
    const auto parameters = [](const EffectSetting& setting) {
        EffectParameter half_width = normal_parameter("half_width", "mm", 2e-3, 1e-3, 1e-3, 6e-3);
        half_width.step = 0.2e-3;
        return std::vector<EffectParameter>{
            normal_parameter("angle", "deg", 0.0, 100.0 * degree, 0.0, 180.0 * degree),
            uniform_parameter("centre", "mm", setting.from, setting.to, 0.2e-3), half_width};
    };
    const auto starts = [](const EffectSetting& setting) {
        std::vector<std::vector<double>> all;
        for (const auto& [angle, half_width] : start_shapes) {
            const double first = setting.from + half_width, last = setting.to - half_width;
            const int gaps =
                std::max(1, static_cast<int>(std::lround((last - first) / half_width)));
            for (int i = 0; i <= gaps; ++i)
                all.push_back({angle, first + (last - first) * i / gaps, half_width});
        }
        return all;
    };
    const auto apply = [](const EffectSetting& setting, const std::vector<double>& x) {
        Model model = setting.base;
        if (x[0] == 0.0) return model;
        const double angle = std::min(x[0], steepest_angle(model.device, x[2]));
        model.schedule.twists.push_back({.angle = angle, .centre = x[1], .half_width = x[2]});
        return model;
    };
    return {"axial_twist", "the device was twisted",
            true,          "a map of the braid angle, or a projection that shows single wires",
            parameters,    starts,
            apply,         3.5};
}

}  // namespace braidzone
