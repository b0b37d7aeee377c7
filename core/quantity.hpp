#pragma once

#include <string>
#include <string_view>

namespace braidzone {

/// Physical dimension of a case-file value.
enum class Dimension {
    length,             ///< [m]
    area,               ///< [m^2]
    time,               ///< [s]
    velocity,           ///< [m/s]
    density,            ///< [kg/m^3]
    dynamic_viscosity,  ///< [Pa s]
    pressure,           ///< [Pa]
    force,              ///< [N]
    stiffness,          ///< [N/m]
    wall_stiffness,     ///< pressure over displacement [Pa/m]
    flow_rate,          ///< [m^3/s]
    angle,              ///< [rad]
    damping,            ///< force over velocity [kg/s]
    linear_loss,        ///< a in dp = a v + b v|v| [Pa s/m]
    quadratic_loss,     ///< b in dp = a v + b v|v| [Pa s^2/m^2]
};

/// SI value of a number with its unit, such as "30 um", "0.25 mm", "3.5 mPa s", "1056 kg/m^3".
///
/// One number, white space (or none), one unit out of the list of the dimension (`allowed_units`).
/// Decimal point and exponent as in C; surrounding white space is ignored.
///
/// @throws ConfigError saying what was found and which units are allowed: number missing, unit
///         missing, unit of another dimension, value not finite
double parse_quantity(std::string_view text, Dimension dimension);

/// The SI value with its SI unit, e.g. "3e-05 m": `parse_quantity` gives back the same double.
std::string format_quantity(double value, Dimension dimension);

/// The SI unit of a dimension, e.g. "Pa s".
std::string_view si_unit(Dimension dimension);

/// The units that `parse_quantity` accepts for this dimension, SI unit first, e.g. "m, cm, mm, um,
/// in" for a length.
std::string allowed_units(Dimension dimension);

/// Name of a dimension for messages, e.g. "length".
std::string_view dimension_name(Dimension dimension);

}  // namespace braidzone
