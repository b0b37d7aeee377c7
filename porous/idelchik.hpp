#pragma once

#include "core/fluid.hpp"
#include "porous/range_check.hpp"
#include "porous/rhombus.hpp"
#include "porous/sheet_loss.hpp"

#include <vector>

namespace braidzone {

/// Idelchik's screen at low Reynolds number (Idelchik, Handbook of Hydraulic Resistance, diagram
/// 8-6):
///
///     dp = zeta rho v^2 / 2,   zeta = 22 / Re + 1.3 (1 - beta) + (1 / beta - 1)^2
///
/// with Re = rho (v / beta) d / mu and beta the surface porosity, that is
///
///     a = 11 mu beta / d,   b = rho / 2 (1.3 (1 - beta) + (1 / beta - 1)^2)
///
/// The linear part hardly depends on the coverage, and even falls with it: 60 % above wire-resolved
/// flow for a Pipeline's nominal braid, more for a sparser one.
struct IdelchikLaw {
    static constexpr const char* name = "idelchik";
};

SheetLoss sheet_loss(const IdelchikLaw& law, const Rhombus& rhombus, const Fluid& fluid);

/// This form is for Re below 50.
std::vector<RangeCheck> range_checks(const IdelchikLaw& law, const Rhombus& rhombus,
                                     const Fluid& fluid);

}  // namespace braidzone
