#include "core/error.hpp"
#include "deploy/braid_kinematics.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace braidzone {

TEST(LengthRatio, IsOneAtNominalRadius)
{
    EXPECT_DOUBLE_EQ(length_ratio(0.40, 1.0), 1.0);
}

// sqrt(0.40^2 + 1 - (3.5/4)^2) / 0.40 = sqrt(0.394375) / 0.40 = 1.5700
TEST(LengthRatio, LengthensANarrowedDevice)
{
    EXPECT_NEAR(length_ratio(0.40, 3.5 / 4.0), 1.5700, 5e-5);
}

// A wire of the force-free device turns by the same angle and keeps its length at any radius: the
// length on a helix is sqrt(L^2 + (R phi)^2).
TEST(LengthRatio, KeepsTheLengthOfTheWires)
{
    const double t = 0.35;
    for (double radius : {0.1, 0.5, 0.9, 1.04}) {
        const double axial = t * length_ratio(t, radius);
        EXPECT_NEAR(std::hypot(axial, radius), std::hypot(t, 1.0), 1e-14) << radius;
    }
}

TEST(LengthRatio, RefusesARadiusThatTheBraidCannotReach)
{
    EXPECT_THROW(length_ratio(0.40, 1.08), InputError);
    EXPECT_THROW(length_ratio(0.40, std::numeric_limits<double>::quiet_NaN()), InputError);
    EXPECT_THROW(length_ratio(0.0, 1.0), InputError);
}

// Radius at the neck after a push of 66 %: 2.13 and 2.64 mm in Zavodszky et al. 2020, Table 3,
// printed with three digits.
TEST(RadiusRatio, ReproducesThePaperAfterAPush)
{
    EXPECT_NEAR(2.0 * radius_ratio(0.40, 0.34), 2.13, 0.01);
    EXPECT_NEAR(2.5 * radius_ratio(0.35, 0.34), 2.64, 0.01);
}

TEST(RadiusRatio, IsTheInverseOfTheLengthRatio)
{
    for (double lambda : {0.1, 0.34, 1.0, 1.8}) {
        EXPECT_NEAR(length_ratio(0.44, radius_ratio(0.44, lambda)), lambda, 1e-13);
    }
}

TEST(RadiusRatio, RefusesASpacingLongerThanTheWires)
{
    EXPECT_THROW(radius_ratio(0.40, 2.7), InputError);
    EXPECT_THROW(radius_ratio(0.40, -0.1), InputError);
}

}  // namespace braidzone
