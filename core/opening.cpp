#include "core/opening.hpp"

#include "core/mesh_topology.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace braidzone {

Opening measured_opening(const TriangleMesh& wall, std::vector<int> rim)
{
    const auto point = [&](std::size_t k) -> const Vec3& {
        return wall.points[static_cast<std::size_t>(rim[k % rim.size()])];
    };
    Vec3 mean = Vec3::Zero();
    for (std::size_t k = 0; k < rim.size(); ++k)
        mean += point(k) / static_cast<double>(rim.size());

    Vec3 vector_area = Vec3::Zero();
    for (std::size_t k = 0; k < rim.size(); ++k) {
        vector_area += 0.5 * (point(k) - mean).cross(point(k + 1) - mean);
    }
    Opening opening;
    opening.centre = mean;
    opening.area = vector_area.norm();
    opening.radius = std::sqrt(opening.area / std::numbers::pi);
    if (opening.area > 0.0) {  // else a slit, which has no more than a place
        opening.normal = vector_area / opening.area;
        for (std::size_t k = 0; k < rim.size(); ++k) {
            const Vec3 a = point(k) - mean, b = point(k + 1) - mean;
            const double share = 0.5 * a.cross(b).dot(opening.normal) / opening.area;
            opening.centre += share * (a + b) / 3.0;
        }
    }
    opening.rim = std::move(rim);
    return opening;
}

std::vector<Opening> measured_openings(const TriangleMesh& wall)
{
    std::vector<Opening> openings;
    for (std::vector<int>& rim : border_loops(wall)) {
        openings.push_back(measured_opening(wall, std::move(rim)));
    }
    std::stable_sort(openings.begin(), openings.end(),
                     [](const Opening& a, const Opening& b) { return a.area > b.area; });
    return openings;
}

}  // namespace braidzone
