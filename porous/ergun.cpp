#include "porous/ergun.hpp"

namespace braidzone {

SheetLoss sheet_loss(const ErgunLaw& /*law*/, const Rhombus& rhombus, const Fluid& fluid)
{
    require_pores(rhombus, ErgunLaw::name);
    const double voids = layer_void_fraction(rhombus);
    const double metal = 1.0 - voids;
    const double thickness = 2.0 * rhombus.wire_diameter;
    const double particle = 1.5 * rhombus.wire_diameter;
    const double per_voids = thickness / (voids * voids * voids * particle);
    return {150.0 * fluid.viscosity * metal * metal / particle * per_voids,
            1.75 * fluid.density * metal * per_voids};
}

std::vector<RangeCheck> range_checks(const ErgunLaw& /*law*/, const Rhombus& rhombus,
                                     const Fluid& /*fluid*/)
{
    return {{"void fraction of a layer of two wire diameters", layer_void_fraction(rhombus), 0.35,
             0.65}};
}

}  // namespace braidzone
