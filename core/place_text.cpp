#include "core/place_text.hpp"

#include <fmt/format.h>

#include <cmath>

namespace braidzone {

std::string place_text(const Vec3& point, const LengthUnit& unit)
{
    Vec3 p = point / unit.metres;
    const double negligible = 1e-9 * p.cwiseAbs().maxCoeff();
    for (double& coordinate : p) {
        if (std::abs(coordinate) < negligible) coordinate = 0.0;
    }
    return fmt::format("({:.6g}, {:.6g}, {:.6g}) {}", p.x(), p.y(), p.z(), unit.name);
}

}  // namespace braidzone
