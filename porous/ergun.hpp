#pragma once

#include "core/fluid.hpp"
#include "porous/range_check.hpp"
#include "porous/rhombus.hpp"
#include "porous/sheet_loss.hpp"

#include <vector>

namespace braidzone {

/// Ergun's equation for packed beds (Ergun 1952, Chem. Eng. Prog. 48:89), an extension of Kozeny
/// and Carman's, applied to a layer of two wire diameters:
///
///     a = 150 mu (1 - eps)^2 L / (eps^3 D^2),   b = 1.75 rho (1 - eps) L / (eps^3 D)
///     L = 2 d,   D = 1.5 d
///
/// with eps the void fraction of the layer; D is the sphere with a wire's surface per volume. A
/// braid is no bed: the thickness is a matter of definition, and that the result comes within 15 %
/// of wire-resolved flow for a Pipeline's nominal braid is chance.
struct ErgunLaw {
    static constexpr const char* name = "ergun";
};

SheetLoss sheet_loss(const ErgunLaw& law, const Rhombus& rhombus, const Fluid& fluid);

/// Packed beds have void fractions of 0.35 to 0.65; a braid's layer has 0.8 and more.
std::vector<RangeCheck> range_checks(const ErgunLaw& law, const Rhombus& rhombus,
                                     const Fluid& fluid);

}  // namespace braidzone
