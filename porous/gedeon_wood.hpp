#pragma once

#include "core/fluid.hpp"
#include "porous/range_check.hpp"
#include "porous/rhombus.hpp"
#include "porous/sheet_loss.hpp"

#include <vector>

namespace braidzone {

/// Gedeon and Wood's correlation of stacked woven screens (Gedeon and Wood 1996, NASA CR-198442),
/// applied to a layer of two wire diameters:
///
///     dp = f (L / d_h) rho u^2 / 2,   f = 129 / Re + 2.91 Re^-0.103
///     L = 2 d,  u = v / eps,  d_h = eps d / (1 - eps),  Re = rho u d_h / mu
///
/// with eps the void fraction of the layer. What the solvers get is the two-term law nearest to it
/// up to `fit_velocity`. Screens in a stack lie closer than one alone, and the thickness of a
/// single one is a matter of definition: 15 % below wire-resolved flow for a Pipeline's nominal
/// braid.
struct GedeonWoodLaw {
    static constexpr const char* name = "gedeon-wood";
    double fit_velocity = 0.1;  ///< [m/s]; > 0
};

/// Pressure drop by the correlation [Pa].
/// @param velocity  v, along the normal [m/s]; > 0
double gedeon_wood_pressure_drop(const Rhombus& rhombus, const Fluid& fluid, double velocity);

/// The two-term law nearest to the correlation, see `two_term_fit`.
SheetLoss sheet_loss(const GedeonWoodLaw& law, const Rhombus& rhombus, const Fluid& fluid);

/// The source covers void fractions of 0.62 to 0.78 and Re from 0.45 to 6000.
std::vector<RangeCheck> range_checks(const GedeonWoodLaw& law, const Rhombus& rhombus,
                                     const Fluid& fluid);

}  // namespace braidzone
