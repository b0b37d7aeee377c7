#include "core/line_points.hpp"

#include <algorithm>

namespace braidzone {

Polyline reversed(Polyline line)
{
    std::reverse(line.points.begin(), line.points.end());
    std::reverse(line.inscribed_radii.begin(), line.inscribed_radii.end());
    return line;
}

double length_of(const Polyline& line)
{
    double length = 0.0;
    for (std::size_t i = 1; i < line.points.size(); ++i)
        length += (line.points[i] - line.points[i - 1]).norm();
    return length;
}

}  // namespace braidzone
