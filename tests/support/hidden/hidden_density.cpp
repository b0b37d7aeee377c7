#include "support/hidden/hidden_density.hpp"

#include <cmath>
#include <numbers>

namespace braidzone::hidden {
namespace {

constexpr double from_ends = 1.5e-3;  // [m]

/// A cell between two rows and two columns.
struct SheetCell {
    Vec3 middle;
    double area = 0.0;
};

SheetCell cell_of(const HiddenDevice& device, int row, int column)
{
    const auto at = [&](int i, int j) -> const Vec3& {
        return device.points[static_cast<std::size_t>(i * device.columns + j % device.columns)];
    };
    const Vec3 &a = at(row, column), &b = at(row, column + 1), &c = at(row + 1, column + 1),
               &d = at(row + 1, column);
    return {0.25 * (a + b + c + d), 0.5 * (c - a).cross(d - b).norm()};
}

}  // namespace

DensityMap counted_pores(const HiddenDevice& device, const FlowDiverter& braid,
                         const DensityPicture& picture, std::mt19937& random)
{
    const double radius = 0.5 * braid.nominal_diameter;
    const double wires = 0.5 * braid.num_wires;
    const double force_free_density =
        wires * wires / (2.0 * std::pow(std::numbers::pi * radius, 2) * braid.braid_ratio);
    const double force_free_area =
        device.row_step * 2.0 * std::numbers::pi * radius / device.columns;
    std::normal_distribution<double> normal;
    std::uniform_real_distribution<double> uniform;
    const double scale = 1.0 + picture.scale_sd * normal(random);
    const double first = device.arc_length.front() - from_ends;
    const double last = device.arc_length.back() + from_ends;
    DensityMap map;
    for (int i = 0; i < picture.rows; ++i) {
        const double s = std::lerp(first, last, (i + 0.5) / picture.rows);
        int row = 0;
        while (device.arc_length[static_cast<std::size_t>(row) + 1] > s)
            ++row;
        for (int j = 0; j < picture.columns; ++j) {
            if (uniform(random) < picture.unseen_share) continue;
            const Vec3 middle = cell_of(device, row, j * device.columns / picture.columns).middle;
            double area = 0.0, pores = 0.0;
            for (int r = 0; r + 1 < device.rows; ++r) {
                for (int c = 0; c < device.columns; ++c) {
                    const SheetCell cell = cell_of(device, r, c);
                    if ((cell.middle - middle).cwiseAbs().maxCoeff() > 0.5 * picture.window)
                        continue;
                    area += cell.area;
                    pores += force_free_density * force_free_area;
                }
            }
            const double density = pores / area;
            map.places.push_back(
                {.point = middle,
                 .value = scale * density * (1.0 + picture.relative_sd * normal(random)),
                 .sd = picture.relative_sd * density,
                 .window = picture.window});
        }
    }
    return map;
}

double wall_force(const HiddenDevice& device, double from, double to)
{
    double force = 0.0;
    for (int row = 0; row + 1 < device.rows; ++row) {
        const double s = 0.5 * (device.arc_length[static_cast<std::size_t>(row)] +
                                device.arc_length[static_cast<std::size_t>(row) + 1]);
        if (s < from || s > to) continue;
        for (int column = 0; column < device.columns; ++column) {
            const auto at = [&](int i, int j) {
                return device
                    .pressure[static_cast<std::size_t>(i * device.columns + j % device.columns)];
            };
            const double pressure = 0.25 * (at(row, column) + at(row, column + 1) +
                                            at(row + 1, column) + at(row + 1, column + 1));
            force += pressure * cell_of(device, row, column).area;
        }
    }
    return force;
}

}  // namespace braidzone::hidden
