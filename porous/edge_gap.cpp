#include "porous/edge_gap.hpp"

#include "core/error.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

namespace braidzone {
namespace {

/// Of a sharp-edged slit with free discharge (Kirchhoff).
constexpr double discharge_coefficient = std::numbers::pi / (std::numbers::pi + 2.0);

}  // namespace

SheetLoss slit_loss(double width, double length, const Fluid& fluid)
{
    if (!(width > 0.0)) {
        throw InputError(fmt::format("width of a gap = {:.6g} um is not positive", 1e6 * width));
    }
    const double thin = 32.0 / (std::numbers::pi * width);
    const double plates = 12.0 * length / (width * width);
    return {fluid.viscosity * (thin + plates),
            0.5 * fluid.density / (discharge_coefficient * discharge_coefficient)};
}

double velocity_at(const SheetLoss& loss, double pressure_drop)
{
    // The root in the form that holds for b = 0 too.
    return 2.0 * pressure_drop /
           (loss.linear +
            std::sqrt(loss.linear * loss.linear + 4.0 * loss.quadratic * pressure_drop));
}

double parallel_pressure_drop(const SheetLoss& sheet, const SheetLoss& gap, double gap_share,
                              double velocity)
{
    if (!(gap_share >= 0.0 && gap_share < 1.0)) {
        throw InputError(fmt::format(
            "a gap of {:.6g} of the channel's section is out of range; allowed is 0 to 1",
            gap_share));
    }
    if (gap_share == 0.0) return pressure_drop(sheet, velocity);
    const double speed = std::abs(velocity);
    double slowest = 0.0, fastest = speed / (1.0 - gap_share);
    for (double middle = 0.5 * fastest; middle > slowest && middle < fastest;
         middle = 0.5 * (slowest + fastest)) {
        const double drop = pressure_drop(sheet, middle);
        const double flow = (1.0 - gap_share) * middle + gap_share * velocity_at(gap, drop);
        (flow > speed ? fastest : slowest) = middle;
    }
    return std::copysign(pressure_drop(sheet, slowest), velocity);
}

}  // namespace braidzone
