#include "porous/deposit_kernel.hpp"

#include "core/error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace braidzone {

std::vector<SheetPiece> cut_into_pieces(const BraidSurface& surface, std::size_t rhombus,
                                        double longest_edge)
{
    if (!(longest_edge > 0.0)) {
        throw InputError(fmt::format("pieces of the sheet with edges of {:.6g} m: must be positive",
                                     longest_edge));
    }
    const auto corner = [&](std::size_t i) -> const Vec3& {
        return surface.points[static_cast<std::size_t>(surface.corners[rhombus][i])];
    };
    double longest_side = 0.0;
    for (std::size_t i = 0; i < 4; ++i)
        longest_side = std::max(longest_side, (corner((i + 1) % 4) - corner(i)).norm());
    const int m = std::max(1, static_cast<int>(std::ceil(longest_side / longest_edge)));
    const double area = surface.rhombi[rhombus].area / (static_cast<double>(m) * m);
    std::vector<SheetPiece> pieces;
    pieces.reserve(static_cast<std::size_t>(m) * static_cast<std::size_t>(m));
    for (int row = 0; row < m; ++row) {
        for (int column = 0; column < m; ++column) {
            const double u = (row + 0.5) / m;
            const double v = (column + 0.5) / m;
            const Vec3 near_side = (1.0 - u) * corner(0) + u * corner(1);
            const Vec3 far_side = (1.0 - u) * corner(3) + u * corner(2);
            pieces.push_back(
                {(1.0 - v) * near_side + v * far_side, static_cast<int>(rhombus), area});
        }
    }
    return pieces;
}

double cosine_kernel(double distance, double half_width)
{
    if (!(std::abs(distance) < half_width)) {
        return 0.0;
    }
    return (1.0 + std::cos(std::numbers::pi * distance / half_width)) / (2.0 * half_width);
}

CosineWeights::CosineWeights(int half_width)
    : half_width_(half_width), values_(static_cast<std::size_t>(2 * half_width))
{
    for (std::size_t i = 0; i < values_.size(); ++i) {
        const double angle = std::numbers::pi * static_cast<double>(i) / half_width;
        turns_.emplace_back(std::cos(angle), std::sin(angle));
    }
}

void CosineWeights::evaluate(double position)
{
    first_ = static_cast<int>(std::floor(position)) - half_width_ + 1;
    const double angle = std::numbers::pi * (position - first_) / half_width_;
    const double cosine = std::cos(angle), sine = std::sin(angle);
    for (std::size_t i = 0; i < values_.size(); ++i) {
        const double turned = cosine * turns_[i][0] + sine * turns_[i][1];
        values_[i] = std::max(0.0, (1.0 + turned) / (2.0 * half_width_));
    }
}

}  // namespace braidzone
