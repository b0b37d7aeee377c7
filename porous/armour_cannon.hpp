#pragma once

#include "core/fluid.hpp"
#include "porous/range_check.hpp"
#include "porous/rhombus.hpp"
#include "porous/sheet_loss.hpp"

#include <vector>

namespace braidzone {

/// Armour and Cannon's correlation of single woven screens (Armour and Cannon 1968, AIChE J.
/// 14:415, doi 10.1002/aic.690140315):
///
///     dp eps^2 D / (Q B rho v^2) = 8.61 / Re + 0.52,   Re = rho v / (mu a^2 D)
///
/// with the screen's thickness B = 2 d, its void fraction eps, the wires' surface per volume
/// a = pi d l / B for a wire length l per area, the pore's diameter D (its inscribed circle) and
/// the tortuosity Q = 1 of a plain weave, that is
///
///     a = 8.61 mu a^2 B / eps^2,   b = 0.52 rho B / (eps^2 D)
///
/// 50 % above wire-resolved flow for a Pipeline's nominal braid.
struct ArmourCannonLaw {
    static constexpr const char* name = "armour-cannon";
};

SheetLoss sheet_loss(const ArmourCannonLaw& law, const Rhombus& rhombus, const Fluid& fluid);

/// The source covers Re from 0.1 to 1000.
std::vector<RangeCheck> range_checks(const ArmourCannonLaw& law, const Rhombus& rhombus,
                                     const Fluid& fluid);

}  // namespace braidzone
