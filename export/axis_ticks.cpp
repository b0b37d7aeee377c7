#include "export/axis_ticks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace braidzone {

namespace {

/// The smallest of 1, 2, 5 times a power of ten that is not below `step`.
double round_up_step(double step)
{
    const double power = std::pow(10.0, std::floor(std::log10(step)));
    // Round-off must not turn a step of exactly 2 into one of 5.
    constexpr double slack = 1.0 + 1e-9;
    for (const double factor : {1.0, 2.0, 5.0}) {
        if (step <= slack * factor * power) return factor * power;
    }
    return 10.0 * power;
}

}  // namespace

std::vector<Tick> axis_ticks(double lower, double upper, int most_ticks)
{
    const double step = round_up_step((upper - lower) / (most_ticks - 1));
    const int decimals = std::max(0, static_cast<int>(-std::floor(std::log10(step) + 1e-9)));
    // A tick at the very end of the axis stays in spite of round-off.
    const double slack = 1e-9 * step;
    std::vector<Tick> ticks;
    for (double index = std::ceil((lower - slack) / step); index * step <= upper + slack; ++index) {
        // Adding 0 turns -0 into 0.
        const double value = index * step + 0.0;
        ticks.push_back({value, fmt::format("{:.{}f}", value, decimals)});
    }
    return ticks;
}

}  // namespace braidzone
