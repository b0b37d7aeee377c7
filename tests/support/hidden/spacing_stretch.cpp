#include "support/hidden/spacing_stretch.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace braidzone::hidden {

double spacing_change(const SpacingStretch& stretch, double arc_length)
{
    constexpr double ripple_length = 1.3e-3;  // [m]
    const double u = arc_length - stretch.centre;
    const double proximal = 0.2 * stretch.half_width, distal = 0.3 * stretch.half_width;
    const double plateau = 0.5 * (std::tanh((u + stretch.half_width) / proximal) -
                                  std::tanh((u - stretch.half_width) / distal));
    const double ripple =
        1.0 + stretch.ripple * std::sin(2.0 * std::numbers::pi * u / ripple_length);
    const double behind = (u + 2.2 * stretch.half_width) / (0.6 * stretch.half_width);
    return stretch.change * (plateau * ripple - stretch.rebound * std::exp(-0.5 * behind * behind));
}

void add_stretch(HiddenScene& scene, const SpacingStretch& stretch)
{
    const auto before = scene.spacing;
    scene.spacing = [before, stretch](double arc_length) {
        return before(arc_length) * std::max(0.1, 1.0 + spacing_change(stretch, arc_length));
    };
}

}  // namespace braidzone::hidden
