#pragma once

#include "core/fluid.hpp"
#include "porous/rhombus.hpp"

#include <string>
#include <variant>
#include <vector>

namespace braidzone {

/// Pressure drop of normal flow through a sheet: dp = a v + b v |v|.
struct SheetLoss {
    double linear = 0.0;     ///< a [Pa s/m]
    double quadratic = 0.0;  ///< b [Pa s^2/m^2]
};

/// Recommended law: drags of two rows of cylinders, superposed, times a crossing factor; see
/// `braid_stokes.hpp`.
struct BraidStokesLaw {
    bool inertia = true;  ///< with its quadratic part
};

/// The same given values for every rhombus.
struct ConstantLaw {
    SheetLoss loss;
};

/// A resistance law with its constants. Its name in the case file: `law_name`.
using ResistanceLaw = std::variant<BraidStokesLaw, ConstantLaw>;

/// "braid-stokes", "constant".
std::string law_name(const ResistanceLaw& law);

/// The law's loss for one rhombus of the braid.
/// @throws InputError for a jammed cell: solidity of a family 0.95 or more
SheetLoss sheet_loss(const ResistanceLaw& law, const Rhombus& rhombus, double wire_diameter,
                     const Fluid& fluid);

/// Sentences about rhombi outside the law's range of validity; empty if there are none.
std::vector<std::string> range_warnings(const ResistanceLaw& law,
                                        const std::vector<Rhombus>& rhombi);

}  // namespace braidzone
