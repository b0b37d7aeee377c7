#include "porous/braid_stokes.hpp"

#include "core/error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace braidzone {

namespace {

using std::numbers::pi;

/// Between these solidities the series hands over to the lubrication limit.
constexpr double series_end = 0.5;
constexpr double lubrication_start = 0.6;

double series_drag(double solidity)
{
    const double tau = 0.5 * pi * solidity;
    const double t2 = tau * tau;
    const double polynomial =
        t2 * (2.0 / 3.0 + t2 * (-1.0 / 9.0 + t2 * (8.0 / 135.0 - t2 * 53.0 / 1350.0)));
    return 8.0 * pi / (1.0 - 2.0 * std::log(2.0 * tau) + polynomial);
}

double lubrication_drag(double solidity)
{
    return 9.0 * pi / (2.0 * std::numbers::sqrt2) * std::pow(1.0 - solidity, -2.5);
}

}  // namespace

double row_drag(double solidity)
{
    if (!(solidity > 0.0 && solidity < 1.0)) {
        throw InputError(fmt::format(
            "solidity {:.6g} of a row of wires (diameter over spacing): must lie between 0 and 1",
            solidity));
    }
    if (solidity <= series_end) {
        return series_drag(solidity);
    }
    if (solidity >= lubrication_start) {
        return lubrication_drag(solidity);
    }
    const double fraction = (solidity - series_end) / (lubrication_start - series_end);
    return std::exp(std::lerp(std::log(series_drag(series_end)),
                              std::log(lubrication_drag(lubrication_start)), fraction));
}

double crossing_factor(double mean_solidity)
{
    const double fit = 1.020 + mean_solidity * (1.07 - 1.28 * mean_solidity);
    return std::clamp(fit, 1.0, 1.25);
}

double braid_stokes_linear(const Rhombus& rhombus, double viscosity)
{
    const double rows = row_drag(rhombus.solidity_a) / rhombus.spacing_a +
                        row_drag(rhombus.solidity_b) / rhombus.spacing_b;
    return viscosity * crossing_factor(mean_solidity(rhombus)) * rows;
}

double braid_stokes_quadratic(const Rhombus& rhombus, double density)
{
    return 0.5 * density * (0.285 + 1.78 * mean_solidity(rhombus));
}

SheetLoss sheet_loss(const BraidStokesLaw& law, const Rhombus& rhombus, const Fluid& fluid)
{
    require_pores(rhombus, BraidStokesLaw::name);
    return {braid_stokes_linear(rhombus, fluid.viscosity),
            law.inertia ? braid_stokes_quadratic(rhombus, fluid.density) : 0.0};
}

std::vector<RangeCheck> range_checks(const BraidStokesLaw& /*law*/, const Rhombus& rhombus,
                                     const Fluid& fluid)
{
    const double reynolds = fluid.density * neck_velocity * rhombus.wire_diameter / fluid.viscosity;
    constexpr double lowest = 0.10, highest = 0.40;
    const double sparsest = std::min(rhombus.solidity_a, rhombus.solidity_b);
    return {{"solidity (wire diameter over spacing)",
             sparsest < lowest ? sparsest : densest_solidity(rhombus), lowest, highest},
            {"Reynolds number of the wire at 0.05 m/s", reynolds, 0.0, 4.0}};
}

}  // namespace braidzone
