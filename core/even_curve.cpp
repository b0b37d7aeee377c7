#include "core/even_curve.hpp"

#include <algorithm>
#include <cstddef>

namespace braidzone {

double value_on_even_curve(const std::vector<double>& values, double step, double x)
{
    const int last = static_cast<int>(values.size()) - 1;
    const int i = std::clamp(static_cast<int>(x / step), 0, last - 1);
    const double t = x / step - i;
    const auto at = [&](int k) {
        if (k < 0) return 2.0 * values[0] - values[1];
        if (k > last)
            return 2.0 * values[static_cast<std::size_t>(last)] -
                   values[static_cast<std::size_t>(last - 1)];
        return values[static_cast<std::size_t>(k)];
    };
    const double a = at(i - 1), b = at(i), c = at(i + 1), d = at(i + 2);
    return b +
           0.5 * t * (c - a + t * (2.0 * a - 5.0 * b + 4.0 * c - d + t * (3.0 * (b - c) + d - a)));
}

}  // namespace braidzone
