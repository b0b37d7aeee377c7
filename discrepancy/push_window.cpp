#include "discrepancy/push_window.hpp"

#include <algorithm>
#include <cmath>

namespace braidzone {

std::vector<EffectParameter> window_parameters(const EffectSetting& setting, double sd,
                                               double lower, double upper)
{
    EffectParameter half_width = normal_parameter("half_width", "mm", 2e-3, 1e-3, 0.6e-3, 5e-3);
    half_width.step = 0.3e-3;
    return {normal_parameter("spacing_change", "1", 0.0, sd, lower, upper),
            uniform_parameter("centre", "mm", setting.from, setting.to, 0.3e-3), half_width};
}

std::vector<std::vector<double>> window_starts(const EffectSetting& setting,
                                               const std::vector<double>& changes)
{
    constexpr double half_width = 2e-3;
    constexpr double wanted_step = 2.5e-3;
    const double first = setting.from + half_width, last = setting.to - half_width;
    const int gaps = std::max(1, static_cast<int>(std::lround((last - first) / wanted_step)));
    std::vector<std::vector<double>> starts;
    for (const double change : changes) {
        for (int i = 0; i <= gaps; ++i)
            starts.push_back({change, first + (last - first) * i / gaps, half_width});
    }
    return starts;
}

Model with_window(const EffectSetting& setting, const std::vector<double>& parameters)
{
    Model model = setting.base;
    if (parameters[0] == 0.0) return model;
    model.schedule.windows.push_back({.from = parameters[1] - parameters[2],
                                      .to = parameters[1] + parameters[2],
                                      .spacing = 1.0 + parameters[0]});
    validate(model.schedule);
    return model;
}

}  // namespace braidzone
