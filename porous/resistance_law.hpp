#pragma once

#include "core/fluid.hpp"
#include "porous/armour_cannon.hpp"
#include "porous/braid_stokes.hpp"
#include "porous/brundrett.hpp"
#include "porous/constant_loss.hpp"
#include "porous/ergun.hpp"
#include "porous/gedeon_wood.hpp"
#include "porous/idelchik.hpp"
#include "porous/measured_loss.hpp"
#include "porous/rhombus.hpp"

#include <string>
#include <variant>
#include <vector>

namespace braidzone {

/// A resistance law with its constants: each in a file of its own, with its source and its range.
using ResistanceLaw = std::variant<BraidStokesLaw, BrundrettLaw, GedeonWoodLaw, ErgunLaw,
                                   IdelchikLaw, ArmourCannonLaw, MeasuredLaw, ConstantLaw>;

/// Its name in the case file.
std::string law_name(const ResistanceLaw& law);

/// The names of all laws, the recommended one first.
std::vector<std::string> law_names();

/// The laws that need nothing but the braid and the fluid, with their defaults; the recommended one
/// first.
std::vector<ResistanceLaw> laws_without_data();

/// The law's loss for one rhombus of the braid; a jammed one gets that of the nearest cell which is
/// not (`opened_to_limit`). Beyond the range that its source covers the law is extrapolated up to
/// there, and `range_warnings` says so.
SheetLoss sheet_loss(const ResistanceLaw& law, const Rhombus& rhombus, const Fluid& fluid);

/// Sentences about rhombi outside the law's range of validity; empty if there are none.
std::vector<std::string> range_warnings(const ResistanceLaw& law,
                                        const std::vector<Rhombus>& rhombi, const Fluid& fluid);

}  // namespace braidzone
