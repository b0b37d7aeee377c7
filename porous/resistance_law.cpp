#include "porous/resistance_law.hpp"

#include "core/error.hpp"
#include "porous/braid_stokes.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace braidzone {

namespace {

/// From this solidity on the wires of a family touch somewhere and there is no pore to flow
/// through.
constexpr double jammed_solidity = 0.95;

/// Solidities for which braid-stokes was compared with wire-resolved flow.
constexpr double lowest_solidity = 0.10;
constexpr double highest_solidity = 0.40;

/// One overload for each law.
struct Loss {
    const Rhombus& rhombus;
    double wire_diameter;
    const Fluid& fluid;

    SheetLoss operator()(const BraidStokesLaw& law) const
    {
        const double densest = std::max(rhombus.solidity_a, rhombus.solidity_b);
        if (!(densest < jammed_solidity)) {
            throw InputError(fmt::format(
                "jammed braid: wires of {:.6g} m at a spacing of {:.6g} m, solidity {:.6g}; "
                "braid-stokes needs less than {:.6g}",
                wire_diameter, std::min(rhombus.spacing_a, rhombus.spacing_b), densest,
                jammed_solidity));
        }
        return {braid_stokes_linear(rhombus, fluid.viscosity),
                law.inertia ? braid_stokes_quadratic(rhombus, fluid.density) : 0.0};
    }

    SheetLoss operator()(const ConstantLaw& law) const { return law.loss; }
};

struct Name {
    std::string operator()(const BraidStokesLaw&) const { return "braid-stokes"; }
    std::string operator()(const ConstantLaw&) const { return "constant"; }
};

struct RangeWarnings {
    const std::vector<Rhombus>& rhombi;

    std::vector<std::string> operator()(const BraidStokesLaw&) const
    {
        std::size_t below = 0, above = 0;
        double lowest = lowest_solidity, highest = highest_solidity;
        for (const Rhombus& rhombus : rhombi) {
            const auto [low, high] = std::minmax(rhombus.solidity_a, rhombus.solidity_b);
            below += low < lowest_solidity;
            above += high > highest_solidity;
            lowest = std::min(lowest, low);
            highest = std::max(highest, high);
        }
        std::vector<std::string> warnings;
        if (below > 0) {
            warnings.push_back(fmt::format(
                "braid-stokes: {} of {} rhombi have a solidity (wire diameter over spacing) below "
                "{:.6g}, down to {:.6g}; the law is verified for {:.6g} to {:.6g}",
                below, rhombi.size(), lowest_solidity, lowest, lowest_solidity, highest_solidity));
        }
        if (above > 0) {
            warnings.push_back(fmt::format(
                "braid-stokes: {} of {} rhombi have a solidity (wire diameter over spacing) above "
                "{:.6g}, up to {:.6g}; the law is verified for {:.6g} to {:.6g}",
                above, rhombi.size(), highest_solidity, highest, lowest_solidity,
                highest_solidity));
        }
        return warnings;
    }

    std::vector<std::string> operator()(const ConstantLaw&) const { return {}; }
};

}  // namespace

std::string law_name(const ResistanceLaw& law)
{
    return std::visit(Name{}, law);
}

SheetLoss sheet_loss(const ResistanceLaw& law, const Rhombus& rhombus, double wire_diameter,
                     const Fluid& fluid)
{
    return std::visit(Loss{rhombus, wire_diameter, fluid}, law);
}

std::vector<std::string> range_warnings(const ResistanceLaw& law,
                                        const std::vector<Rhombus>& rhombi)
{
    return std::visit(RangeWarnings{rhombi}, law);
}

}  // namespace braidzone
