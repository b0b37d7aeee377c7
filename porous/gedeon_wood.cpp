#include "porous/gedeon_wood.hpp"

#include "porous/two_term_fit.hpp"

#include <cmath>

namespace braidzone {

namespace {

/// Flow within the layer.
struct LayerFlow {
    double velocity = 0.0;            ///< in the voids [m/s]
    double hydraulic_diameter = 0.0;  ///< 4 times the voids' volume over the wires' surface [m]
    double reynolds = 0.0;            ///< [-]
};

LayerFlow layer_flow(const Rhombus& rhombus, const Fluid& fluid, double velocity)
{
    const double voids = layer_void_fraction(rhombus);
    LayerFlow flow;
    flow.velocity = velocity / voids;
    flow.hydraulic_diameter = voids * rhombus.wire_diameter / (1.0 - voids);
    flow.reynolds = fluid.density * flow.velocity * flow.hydraulic_diameter / fluid.viscosity;
    return flow;
}

}  // namespace

double gedeon_wood_pressure_drop(const Rhombus& rhombus, const Fluid& fluid, double velocity)
{
    const LayerFlow flow = layer_flow(rhombus, fluid, velocity);
    const double friction = 129.0 / flow.reynolds + 2.91 * std::pow(flow.reynolds, -0.103);
    const double thickness = 2.0 * rhombus.wire_diameter;
    return friction * thickness / flow.hydraulic_diameter * 0.5 * fluid.density * flow.velocity *
           flow.velocity;
}

SheetLoss sheet_loss(const GedeonWoodLaw& law, const Rhombus& rhombus, const Fluid& fluid)
{
    require_pores(rhombus, GedeonWoodLaw::name);
    return two_term_fit(sample_loss(
        [&](double velocity) { return gedeon_wood_pressure_drop(rhombus, fluid, velocity); },
        law.fit_velocity));
}

std::vector<RangeCheck> range_checks(const GedeonWoodLaw& /*law*/, const Rhombus& rhombus,
                                     const Fluid& fluid)
{
    return {{"void fraction of a layer of two wire diameters", layer_void_fraction(rhombus), 0.62,
             0.78},
            {"Reynolds number of the layer at 0.05 m/s",
             layer_flow(rhombus, fluid, neck_velocity).reynolds, 0.45, 6000.0}};
}

}  // namespace braidzone
