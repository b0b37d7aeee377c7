#pragma once

namespace braidzone {

/// Pressure drop of normal flow through a sheet: dp = a v + b v |v|.
struct SheetLoss {
    double linear = 0.0;     ///< a [Pa s/m]
    double quadratic = 0.0;  ///< b [Pa s^2/m^2]
};

/// Pressure drop over the sheet [Pa]; odd in the velocity.
/// @param velocity  v, superficial velocity along the normal [m/s]
inline double pressure_drop(const SheetLoss& loss, double velocity)
{
    return (loss.linear + loss.quadratic * (velocity < 0.0 ? -velocity : velocity)) * velocity;
}

}  // namespace braidzone
