#include "discrepancy/effect.hpp"

#include <cmath>
#include <utility>

namespace braidzone {
namespace {

/// Of each part, so that both together stay below 1.
constexpr double largest_lean = 0.7;

/// An end that did not open in full (`incomplete_opening.hpp`).
///
/// The radius at the very end is smaller by `shrink`, the cone begins `length` before it. Priors
/// 0.2 and 4 mm with 2 mm: a gap of 0.1 to 0.5 mm at the tail of a 4 mm device (tail malapposition
/// in 25 % of 161 devices, Jilin 2023, doi 10.3389/fneur.2023.1301046). A tail seldom hangs in the
/// middle: it leans to a side by `lean`, given by its parts along the ring frames' normal and
/// binormal, priors 0.4. Key: deployment.incomplete_opening.
std::vector<EffectParameter> cone_parameters(const EffectSetting&)
{
    EffectParameter length = normal_parameter("length", "mm", 4e-3, 2e-3, 1e-3, 12e-3);
    length.step = 0.3e-3;
    return {normal_parameter("shrink", "1", 0.0, 0.2, 0.0, 0.7), length,
            normal_parameter("lean_normal", "1", 0.0, 0.4, -largest_lean, largest_lean),
            normal_parameter("lean_binormal", "1", 0.0, 0.4, -largest_lean, largest_lean)};
}

std::vector<std::vector<double>> cone_starts(const EffectSetting&)
{
    return {{0.1, 2.5e-3, 0.0, 0.0},
            {0.1, 5e-3, 0.0, 0.0},
            {0.25, 2.5e-3, 0.0, 0.0},
            {0.25, 5e-3, 0.0, 0.0}};
}

/// The base model with the cone. @throws ConfigError if the end has one already
Model with_cone(const EffectSetting& setting, DeviceEnd end, const std::vector<double>& x)
{
    Model model = setting.base;
    if (x[0] == 0.0) return model;
    model.schedule.incomplete_openings.push_back({.end = end,
                                                  .length = x[1],
                                                  .shrink = x[0],
                                                  .lean = std::hypot(x[2], x[3]),
                                                  .lean_angle = std::atan2(x[3], x[2])});
    validate(model.schedule);
    return model;
}

Effect incomplete_opening(DeviceEnd end, std::string name, std::string title)
{
    return {std::move(name),
            std::move(title),
            true,
            "the surface of the device's very end, or a view along the vessel",
            cone_parameters,
            cone_starts,
            [end](const EffectSetting& setting, const std::vector<double>& x) {
                return with_cone(setting, end, x);
            },
            3};
}

}  // namespace

/// The tail hangs on to its delivery wire, or did not open.
Effect incomplete_opening_proximal_effect()
{
    return incomplete_opening(DeviceEnd::proximal, "incomplete_opening_proximal",
                              "the proximal end did not open in full");
}

/// The tip did not open.
Effect incomplete_opening_distal_effect()
{
    return incomplete_opening(DeviceEnd::distal, "incomplete_opening_distal",
                              "the distal end did not open in full");
}

}  // namespace braidzone
