#include "deploy/equation_of_motion.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace braidzone {

namespace {

/// Error at time 10 of a damped oscillator m = 2, k = 0.3, c = 5 started at x = 1 at rest, against
/// x = exp(-g t) (cos w t + g / w sin w t), g = k / 2m, w^2 = c / m - g^2.
double oscillator_error(int num_steps)
{
    const double mass = 2.0, damping = 0.3, stiffness = 5.0, end = 10.0;
    const double g = damping / (2.0 * mass), w = std::sqrt(stiffness / mass - g * g);
    const auto exact = [&](double t) {
        return std::exp(-g * t) * (std::cos(w * t) + g / w * std::sin(w * t));
    };
    const double dt = end / num_steps;
    const VerletScheme scheme{.time_step = dt, .mass = mass, .damping = damping};
    double x = exact(dt), last = x - exact(0.0);
    for (int i = 1; i < num_steps; ++i) {
        last = next_displacement(scheme, last, -stiffness * x);
        x += last;
    }
    return std::abs(x - exact(end));
}

}  // namespace

TEST(NextDisplacement, IsOfSecondOrderInTheTimeStep)
{
    const double order = std::log2(oscillator_error(400) / oscillator_error(800));
    EXPECT_NEAR(order, 2.0, 0.1);
}

// Without damping and force a node keeps its displacement a step.
TEST(NextDisplacement, KeepsTheVelocityOfAFreeNode)
{
    const VerletScheme scheme{.time_step = 0.4, .mass = 1.0, .damping = 0.0};
    EXPECT_DOUBLE_EQ(next_displacement(scheme, 3e-6, 0.0), 3e-6);
}

}  // namespace braidzone
