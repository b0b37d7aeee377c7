#include "discrepancy/fingerprint.hpp"

#include <algorithm>

namespace braidzone {

FingerprintGain fingerprint_gain(const Eigen::VectorXd& fingerprint, const Eigen::VectorXd& z)
{
    constexpr double largest_size = 2.0;
    const double square = fingerprint.squaredNorm();
    if (!(square > 0.0)) return {};
    const double along = fingerprint.dot(z);
    const double size = std::clamp(along / square, 0.0, largest_size);
    return {size, size * along - 0.5 * size * size * square};
}

}  // namespace braidzone
