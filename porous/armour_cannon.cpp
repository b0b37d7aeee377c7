#include "porous/armour_cannon.hpp"

#include <numbers>

namespace braidzone {

namespace {

/// Surface of the wires per volume of the screen, a [1/m].
double surface_per_volume(const Rhombus& rhombus)
{
    return 0.5 * std::numbers::pi * wire_length_per_area(rhombus);
}

}  // namespace

SheetLoss sheet_loss(const ArmourCannonLaw& /*law*/, const Rhombus& rhombus, const Fluid& fluid)
{
    require_pores(rhombus, ArmourCannonLaw::name);
    const double voids = layer_void_fraction(rhombus);
    const double thickness = 2.0 * rhombus.wire_diameter;
    const double surface = surface_per_volume(rhombus);
    return {8.61 * fluid.viscosity * surface * surface * thickness / (voids * voids),
            0.52 * fluid.density * thickness / (voids * voids * rhombus.inscribed_diameter)};
}

std::vector<RangeCheck> range_checks(const ArmourCannonLaw& /*law*/, const Rhombus& rhombus,
                                     const Fluid& fluid)
{
    const double surface = surface_per_volume(rhombus);
    return {{"Reynolds number of the screen at 0.05 m/s",
             fluid.density * neck_velocity /
                 (fluid.viscosity * surface * surface * rhombus.inscribed_diameter),
             0.1, 1000.0}};
}

}  // namespace braidzone
