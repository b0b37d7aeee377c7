#include "porous/brundrett.hpp"

#include "porous/two_term_fit.hpp"

#include <cmath>

namespace braidzone {

namespace {

double wire_reynolds(const Rhombus& rhombus, const Fluid& fluid, double velocity)
{
    return fluid.density * velocity * rhombus.wire_diameter / fluid.viscosity;
}

}  // namespace

double brundrett_pressure_drop(const Rhombus& rhombus, const Fluid& fluid, double velocity)
{
    const double re = wire_reynolds(rhombus, fluid, velocity);
    const double of_reynolds = 7.125 / re + 0.88 / std::log10(re + 1.25) + 0.055 * std::log10(re);
    const double open = surface_porosity(rhombus);
    const double loss_coefficient = of_reynolds * (1.0 - open * open) / (open * open);
    return loss_coefficient * 0.5 * fluid.density * velocity * velocity;
}

SheetLoss sheet_loss(const BrundrettLaw& law, const Rhombus& rhombus, const Fluid& fluid)
{
    require_pores(rhombus, BrundrettLaw::name);
    return two_term_fit(sample_loss(
        [&](double velocity) { return brundrett_pressure_drop(rhombus, fluid, velocity); },
        law.fit_velocity));
}

std::vector<RangeCheck> range_checks(const BrundrettLaw& /*law*/, const Rhombus& rhombus,
                                     const Fluid& fluid)
{
    return {{"Reynolds number of the wire at 0.05 m/s",
             wire_reynolds(rhombus, fluid, neck_velocity), 1e-4, 1e4}};
}

}  // namespace braidzone
