#include "export/colour_map.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace braidzone {

namespace {

/// viridis at 0, 1/9 ... 1 as 0xRRGGBB.
constexpr std::array<unsigned, 10> anchors{0x440154, 0x482878, 0x3e4a89, 0x31688e, 0x26828e,
                                           0x1f9e89, 0x35b779, 0x6dcd59, 0xb4de2c, 0xfde725};

double channel(unsigned anchor, std::size_t index)
{
    return static_cast<double>(anchor >> (16U - 8U * index) & 0xffU) / 255.0;
}

}  // namespace

Colour viridis(double fraction)
{
    const double position = std::clamp(fraction, 0.0, 1.0) * (anchors.size() - 1);
    const std::size_t below =
        std::min(static_cast<std::size_t>(position), std::size_t{anchors.size() - 2});
    Colour colour{};
    for (std::size_t i = 0; i < colour.size(); ++i) {
        colour[i] = std::lerp(channel(anchors[below], i), channel(anchors[below + 1], i),
                              position - static_cast<double>(below));
    }
    return colour;
}

}  // namespace braidzone
