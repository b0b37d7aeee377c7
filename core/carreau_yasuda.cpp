#include "core/carreau_yasuda.hpp"

#include "core/error.hpp"

#include <fmt/format.h>

#include <cmath>

namespace braidzone {

double viscosity(const CarreauYasuda& blood, double shear_rate)
{
    const double a = blood.yasuda_exponent;
    const double thinning = std::pow(1.0 + std::pow(blood.relaxation_time * shear_rate, a),
                                     (blood.power_index - 1) / a);
    return blood.infinite_shear_viscosity +
           (blood.zero_shear_viscosity - blood.infinite_shear_viscosity) * thinning;
}

void validate(const CarreauYasuda& blood)
{
    const auto require = [](bool holds, const char* name, double value, const char* allowed) {
        if (!holds || !std::isfinite(value))
            throw InputError(
                fmt::format("{} {:.6g} is out of range; allowed: {}", name, value, allowed));
    };
    require(blood.infinite_shear_viscosity > 0.0, "infinite-shear viscosity [Pa s]",
            blood.infinite_shear_viscosity, "above 0");
    require(blood.zero_shear_viscosity > blood.infinite_shear_viscosity,
            "zero-shear viscosity [Pa s]", blood.zero_shear_viscosity,
            "above the infinite-shear viscosity");
    require(blood.relaxation_time > 0.0, "relaxation time [s]", blood.relaxation_time, "above 0");
    require(blood.power_index > 0.0 && blood.power_index < 1.0, "power index", blood.power_index,
            "between 0 and 1");
    require(blood.yasuda_exponent > 0.0, "Yasuda exponent", blood.yasuda_exponent, "above 0");
}

}  // namespace braidzone
