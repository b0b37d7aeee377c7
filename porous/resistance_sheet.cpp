#include "porous/resistance_sheet.hpp"

#include "core/error.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace braidzone {

namespace {

/// The device counts as lying on the wall up to the first and as free from the second of these
/// distances, over the wire diameter. The mid-surface of two crossing wires in touch with the wall
/// is one diameter from it.
constexpr double on_wall_diameters = 1.0;
constexpr double free_diameters = 3.0;

/// Cubic step from 0 at `lower` to 1 at `upper` with zero slope at both.
double smooth_step(double value, double lower, double upper)
{
    const double t = std::clamp((value - lower) / (upper - lower), 0.0, 1.0);
    return t * t * (3.0 - 2.0 * t);
}

}  // namespace

ResistanceSheet make_resistance_sheet(const BraidSurface& surface, const ResistanceLaw& law,
                                      const Fluid& fluid, const SheetOptions& options)
{
    if (!(options.tangential_ratio >= 0.0)) {
        throw ConfigError(fmt::format("tangential over normal resistance {:.6g}: must be 0 or more",
                                      options.tangential_ratio));
    }
    if (!(fluid.viscosity > 0.0 && fluid.density > 0.0)) {
        throw ConfigError(
            fmt::format("fluid of viscosity {:.6g} Pa s and density {:.6g} kg/m^3: both must be "
                        "positive",
                        fluid.viscosity, fluid.density));
    }
    ResistanceSheet sheet;
    sheet.surface = surface;
    sheet.tangential_ratio = {
        options.tangential_ratio,
        options.quadratic == QuadraticDrag::normal_only ? 0.0 : options.tangential_ratio};
    sheet.fluid = fluid;
    sheet.losses.reserve(surface.rhombi.size());
    sheet.acting.reserve(surface.rhombi.size());
    for (std::size_t rhombus = 0; rhombus < surface.rhombi.size(); ++rhombus) {
        const double diameter = surface.rhombi[rhombus].wire_diameter;
        sheet.losses.push_back(sheet_loss(law, surface.rhombi[rhombus], fluid));
        const bool everywhere = options.region == ResistanceRegion::whole_device;
        sheet.acting.push_back(everywhere ? 1.0
                                          : smooth_step(surface.wall_distance[rhombus],
                                                        on_wall_diameters * diameter,
                                                        free_diameters * diameter));
    }
    return sheet;
}

ResistanceSheet joined(const ResistanceSheet& first, const ResistanceSheet& second)
{
    if (first.tangential_ratio != second.tangential_ratio ||
        first.fluid.viscosity != second.fluid.viscosity ||
        first.fluid.density != second.fluid.density) {
        throw InputError("two sheets with different fluids or tangential ratios cannot be joined");
    }
    ResistanceSheet both = first;
    both.surface = joined(first.surface, second.surface);
    both.losses.insert(both.losses.end(), second.losses.begin(), second.losses.end());
    both.acting.insert(both.acting.end(), second.acting.begin(), second.acting.end());
    return both;
}

double sheet_darcy(const ResistanceSheet& sheet, int rhombus)
{
    const auto i = static_cast<std::size_t>(rhombus);
    return sheet.acting[i] * sheet.losses[i].linear / sheet.fluid.viscosity;
}

double sheet_forchheimer(const ResistanceSheet& sheet, int rhombus)
{
    const auto i = static_cast<std::size_t>(rhombus);
    return sheet.acting[i] * 2.0 * sheet.losses[i].quadratic / sheet.fluid.density;
}

double resistance_integral(const ResistanceSheet& sheet)
{
    double integral = 0.0;
    for (std::size_t rhombus = 0; rhombus < sheet.surface.rhombi.size(); ++rhombus) {
        integral +=
            sheet_darcy(sheet, static_cast<int>(rhombus)) * sheet.surface.rhombi[rhombus].area;
    }
    return integral;
}

std::optional<SheetLoss> mean_acting_loss(const ResistanceSheet& sheet)
{
    double area = 0.0;
    SheetLoss mean;
    for (std::size_t rhombus = 0; rhombus < sheet.surface.rhombi.size(); ++rhombus) {
        const double acting_area = sheet.acting[rhombus] * sheet.surface.rhombi[rhombus].area;
        area += acting_area;
        mean.linear += acting_area * sheet.losses[rhombus].linear;
        mean.quadratic += acting_area * sheet.losses[rhombus].quadratic;
    }
    if (!(area > 0.0)) return std::nullopt;
    return SheetLoss{mean.linear / area, mean.quadratic / area};
}

}  // namespace braidzone
