#include "discrepancy/effect_parameter.hpp"

#include <cmath>
#include <numbers>
#include <utility>

namespace braidzone {

EffectParameter normal_parameter(std::string name, std::string unit, double mean, double sd,
                                 double lower, double upper)
{
    return {.name = std::move(name),
            .unit = std::move(unit),
            .prior_mean = mean,
            .prior_sd = sd,
            .lower = lower,
            .upper = upper,
            .step = 0.2 * sd};
}

EffectParameter uniform_parameter(std::string name, std::string unit, double lower, double upper,
                                  double step)
{
    return {.name = std::move(name),
            .unit = std::move(unit),
            .prior_mean = 0.5 * (lower + upper),
            .prior_sd = (upper - lower) / std::sqrt(12.0),
            .lower = lower,
            .upper = upper,
            .step = step,
            .is_uniform = true};
}

double reported_unit(const EffectParameter& parameter)
{
    if (parameter.unit == "mm") return 1e-3;
    if (parameter.unit == "deg") return std::numbers::pi / 180.0;
    return 1.0;
}

}  // namespace braidzone
