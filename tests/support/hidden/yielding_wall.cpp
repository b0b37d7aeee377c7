#include "support/hidden/yielding_wall.hpp"

#include <cmath>

namespace braidzone::hidden {

WallEnergy wall_energy(const WallSprings& springs, double depth)
{
    const double root = std::hypot(depth, springs.rounding);
    // For depths far below zero the sum cancels; the other form does not.
    const double passed = depth > 0.0 ? 0.5 * (depth + root)
                                      : 0.5 * springs.rounding * springs.rounding / (root - depth);
    const double passed_slope = passed / root;
    const double passed_curvature = 0.5 * std::pow(springs.rounding, 2) / (root * root * root);
    const double square = passed * passed;
    const double force = (springs.stiffness + springs.stiffening * square) * passed;
    const double force_slope = springs.stiffness + 3.0 * springs.stiffening * square;
    return {0.5 * springs.stiffness * square + 0.25 * springs.stiffening * square * square,
            force * passed_slope,
            force_slope * passed_slope * passed_slope + force * passed_curvature};
}

}  // namespace braidzone::hidden
