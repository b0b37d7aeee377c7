#include "core/even_curve.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace braidzone {

TEST(ValueOnEvenCurve, MeetsTheGivenValues)
{
    const std::vector<double> values = {1.0, 4.0, 2.0, 8.0};
    for (std::size_t i = 0; i < values.size(); ++i)
        EXPECT_NEAR(value_on_even_curve(values, 0.5, 0.5 * static_cast<double>(i)), values[i],
                    1e-14);
}

// Catmull and Rom's cubic takes slopes from central differences, which are exact for parabolas.
TEST(ValueOnEvenCurve, IsExactForAParabolaBetweenInnerPoints)
{
    std::vector<double> values;
    for (int i = 0; i < 6; ++i)
        values.push_back(0.25 * i * i);
    for (const double x : {1.1, 1.7, 2.4, 3.9})
        EXPECT_NEAR(value_on_even_curve(values, 1.0, x), 0.25 * x * x, 1e-14);
}

TEST(ValueOnEvenCurve, GoesOnBeyondTheLastPoint)
{
    EXPECT_NEAR(value_on_even_curve({0.0, 2.0, 4.0}, 1.0, 2.3), 4.6, 1e-14);
}

}  // namespace braidzone
