#pragma once

#include <string>

namespace braidzone {

/// A parameter of an effect. Its prior is normal, or uniform between the bounds.
struct EffectParameter {
    std::string name;
    std::string unit;         ///< in which it is reported: "mm", "deg" or "1"
    double prior_mean = 0.0;  ///< [SI]
    double prior_sd = 1.0;    ///< [SI]; of a uniform prior as well, for scaling
    double lower = 0.0;       ///< bounds [SI]
    double upper = 0.0;
    double step = 0.0;  ///< for derivatives, 0: a fifth of the prior's standard deviation [SI]
    bool is_uniform = false;
};

/// A parameter with a normal prior about `mean`.
EffectParameter normal_parameter(std::string name, std::string unit, double mean, double sd,
                                 double lower, double upper);

/// A parameter that may be anywhere between two bounds.
EffectParameter uniform_parameter(std::string name, std::string unit, double lower, double upper,
                                  double step);

/// SI value of one unit in which parameters are reported.
double reported_unit(const EffectParameter& parameter);

}  // namespace braidzone
