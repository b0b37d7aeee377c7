#pragma once

#include "core/vector.hpp"

#include <random>
#include <vector>

namespace braidzone::hidden {

/// A smooth random function of place: a sum of 60 plane waves whose correlation is Gaussian,
/// exp(-d^2 / (2 length^2)).
class SmoothField {
public:
    /// @param sd      standard deviation of the values
    /// @param length  of the correlation [m]; > 0
    SmoothField(double sd, double length, std::mt19937& random);

    double operator()(const Vec3& point) const;

private:
    std::vector<Vec3> waves_;
    std::vector<double> phases_;
    double amplitude_ = 0.0;
};

}  // namespace braidzone::hidden
