#include "deploy/braid_kinematics.hpp"

#include "core/error.hpp"

#include <fmt/format.h>

#include <cmath>

namespace braidzone {

namespace {

void require_positive_ratio(double braid_ratio)
{
    if (!(braid_ratio > 0.0)) {
        throw InputError(fmt::format("braid_ratio = {:.6g}; it must be positive", braid_ratio));
    }
}

}  // namespace

double length_ratio(double braid_ratio, double radius_ratio)
{
    require_positive_ratio(braid_ratio);
    const double largest = std::sqrt(1.0 + braid_ratio * braid_ratio);
    if (!(radius_ratio >= 0.0 && radius_ratio <= largest)) {
        throw InputError(
            fmt::format("radius / nominal radius = {:.6g}; a braid of ratio {:.6g} "
                        "allows 0 to {:.6g}",
                        radius_ratio, braid_ratio, largest));
    }
    return std::sqrt(braid_ratio * braid_ratio + 1.0 - radius_ratio * radius_ratio) / braid_ratio;
}

double radius_ratio(double braid_ratio, double spacing_ratio)
{
    require_positive_ratio(braid_ratio);
    const double largest = std::sqrt(1.0 + braid_ratio * braid_ratio) / braid_ratio;
    if (!(spacing_ratio >= 0.0 && spacing_ratio <= largest)) {
        throw InputError(
            fmt::format("ring spacing / nominal spacing = {:.6g}; a braid of ratio "
                        "{:.6g} allows 0 to {:.6g}",
                        spacing_ratio, braid_ratio, largest));
    }
    return std::sqrt(1.0 + braid_ratio * braid_ratio * (1.0 - spacing_ratio * spacing_ratio));
}

}  // namespace braidzone
