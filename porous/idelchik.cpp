#include "porous/idelchik.hpp"

namespace braidzone {

SheetLoss sheet_loss(const IdelchikLaw& /*law*/, const Rhombus& rhombus, const Fluid& fluid)
{
    require_pores(rhombus, IdelchikLaw::name);
    const double open = surface_porosity(rhombus);
    const double narrowing = 1.0 / open - 1.0;
    return {11.0 * fluid.viscosity * open / rhombus.wire_diameter,
            0.5 * fluid.density * (1.3 * (1.0 - open) + narrowing * narrowing)};
}

std::vector<RangeCheck> range_checks(const IdelchikLaw& /*law*/, const Rhombus& rhombus,
                                     const Fluid& fluid)
{
    const double pore_velocity = neck_velocity / surface_porosity(rhombus);
    return {{"Reynolds number of the wire in the pore at 0.05 m/s",
             fluid.density * pore_velocity * rhombus.wire_diameter / fluid.viscosity, 0.0, 50.0}};
}

}  // namespace braidzone
