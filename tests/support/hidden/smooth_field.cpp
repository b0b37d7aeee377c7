#include "support/hidden/smooth_field.hpp"

#include <cmath>
#include <numbers>

namespace braidzone::hidden {

SmoothField::SmoothField(double sd, double length, std::mt19937& random)
{
    constexpr int num_waves = 60;
    std::normal_distribution<double> normal;
    std::uniform_real_distribution<double> phase(0.0, 2.0 * std::numbers::pi);
    for (int i = 0; i < num_waves; ++i) {
        const double x = normal(random), y = normal(random), z = normal(random);
        waves_.push_back(Vec3(x, y, z) / length);
        phases_.push_back(phase(random));
    }
    amplitude_ = sd * std::sqrt(2.0 / num_waves);
}

double SmoothField::operator()(const Vec3& point) const
{
    double sum = 0.0;
    for (std::size_t i = 0; i < waves_.size(); ++i)
        sum += std::cos(waves_[i].dot(point) + phases_[i]);
    return amplitude_ * sum;
}

}  // namespace braidzone::hidden
