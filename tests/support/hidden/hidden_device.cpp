#include "support/hidden/hidden_device.hpp"

#include "core/phantom_shape.hpp"
#include "support/hidden/sliding_rings.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace braidzone::hidden {
namespace {

constexpr double least_pressure = 10.0;  // at which the wall holds a point [Pa], real
constexpr int centring_rounds = 6;
constexpr double hub_smoothing = 1e-3;  // along the vessel, standard deviation [m]

std::size_t index(int i)
{
    return static_cast<std::size_t>(i);
}

class Placing {
public:
    Placing(const HiddenScene& scene, const SheetResolution& resolution)
        : scene_(scene), shape_(make_shape(scene.phantom)), sheet_(sheet_of(scene.device))
    {
        place_.rows = static_cast<int>(std::lround(sheet_.length / resolution.spacing)) + 1;
        place_.columns = resolution.columns;
        phase_ = resolution.phase;
        rows_ = released_rows(scene, sheet_.length, place_.rows);
        place_.springs = scene.springs;
        place_.springs.stiffness /= sheet_.force_scale;
        place_.springs.stiffening /= sheet_.force_scale;
        place_.wall = [this](int row, const Vec3& point) { return depth(row, point); };
        lay_out();
    }

    HiddenDevice settled()
    {
        SheetAtRest rest = at_rest(sheet_, place_, free_radii());
        if (std::isfinite(scene_.friction)) {
            rows_ = slid_rings(sheet_, rows_, rest.radii, forces(rest.pressure), scene_.friction);
            lay_out();
            rest = at_rest(sheet_, place_, free_radii());
        }
        if (scene_.hub_pull != 0.0) {
            move_hubs(scene_.hub_pull, free_sides(rest.pressure));
            rest = at_rest(sheet_, place_, free_radii());
        }
        return device_of(rest);
    }

private:
    /// Of the wires' middle beyond what holds it.
    double depth(int row, const Vec3& point) const
    {
        double deepest =
            level(shape_, point) - scene_.unevenness(point) + 0.5 * scene_.device.wire_diameter;
        const RowPoint at{point, axis_[index(row)], rows_[index(row)], from_distal(row)};
        for (const Obstacle& obstacle : scene_.obstacles)
            deepest = std::max(deepest, obstacle(at));
        return deepest;
    }

    double from_distal(int row) const { return sheet_.length * row / (place_.rows - 1); }

    void lay_out()
    {
        const double step = 2.0 * std::numbers::pi / place_.columns;
        axis_.clear();
        place_.angles.clear();
        place_.loads.clear();
        place_.pitch.clear();
        for (int row = 0; row < place_.rows; ++row) {
            const double s = rows_[index(row)];
            if (!(s > 0.0 && s < shape_.axis.length))
                throw std::runtime_error("the hidden device does not lie within its vessel");
            axis_.push_back(section_along(shape_.axis, s));
            place_.pitch.push_back(scene_.pitch(from_distal(row)));
            const double turn = scene_.turn(s);
            for (int column = 0; column < place_.columns; ++column) {
                const SheetPoint at{s, (column + phase_) * step + turn, from_distal(row)};
                place_.angles.push_back(at.angle);
                place_.loads.push_back(scene_.load(at) / sheet_.force_scale);
            }
        }
        place_.sections = axis_;
        centre_hubs();
    }

    /// How far a ray reaches from its hub: to the wall, or to `beyond`. The level of the wall is
    /// about a distance, so that steps by it come near the wall at once.
    double reach(int row, int column, double beyond) const
    {
        constexpr int steps = 6;
        const Vec3 ray = place_.ray(row, column);
        double radius = beyond;
        for (int i = 0; i < steps; ++i) {
            const double depth =
                place_.wall(row, place_.sections[index(row)].origin + radius * ray);
            if (i == 0 && depth < 0.0) break;
            radius -= depth;
        }
        return std::clamp(radius, 0.1 * sheet_.radius, beyond);
    }

    std::vector<double> reaches(double beyond) const
    {
        std::vector<double> all;
        for (int row = 0; row < place_.rows; ++row) {
            for (int column = 0; column < place_.columns; ++column)
                all.push_back(reach(row, column, beyond));
        }
        return all;
    }

    /// How far the springs of rings push: to the wall or to the rings' own radius.
    std::vector<double> free_radii() const { return reaches(sheet_.radius); }

    /// Twice the mean of each row's points from its hub: where the middle of the ring is.
    std::vector<Vec3> ring_means(const std::vector<double>& radii) const
    {
        std::vector<Vec3> means(index(place_.rows), Vec3::Zero());
        for (int row = 0; row < place_.rows; ++row) {
            for (int column = 0; column < place_.columns; ++column) {
                means[index(row)] +=
                    2.0 * radii[place_.at(row, column)] * place_.ray(row, column) / place_.columns;
            }
        }
        return means;
    }

    std::vector<Vec3> smoothed(const std::vector<Vec3>& values) const
    {
        std::vector<Vec3> smooth;
        for (int row = 0; row < place_.rows; ++row) {
            Vec3 sum = Vec3::Zero();
            double weights = 0.0;
            for (int other = 0; other < place_.rows; ++other) {
                const double u = (rows_[index(row)] - rows_[index(other)]) / hub_smoothing;
                const double weight = std::exp(-0.5 * u * u);
                sum += weight * values[index(other)];
                weights += weight;
            }
            smooth.push_back(sum / weights);
        }
        return smooth;
    }

    void move_hubs(double share, const std::vector<Vec3>& shifts)
    {
        for (std::size_t row = 0; row < shifts.size(); ++row)
            place_.sections[row].origin += share * shifts[row];
    }

    /// The middle of the lumen as the springs of a ring feel it, seen from the axis: moved by d
    /// they are in balance, d = 2 mean of min(reach, R0 + d . ray) ray.
    void centre_hubs()
    {
        const std::vector<double> furthest = reaches(1.2 * sheet_.radius);
        std::vector<Vec3> shifts(index(place_.rows), Vec3::Zero());
        for (int round = 0; round < centring_rounds; ++round) {
            std::vector<double> radii = furthest;
            for (int row = 0; row < place_.rows; ++row) {
                for (int column = 0; column < place_.columns; ++column) {
                    double& radius = radii[place_.at(row, column)];
                    radius = std::min(
                        radius, sheet_.radius + shifts[index(row)].dot(place_.ray(row, column)));
                }
            }
            shifts = ring_means(radii);
        }
        move_hubs(1.0, smoothed(shifts));
    }

    /// Mean ray of the points that no wall holds, of each row, over the largest of the device.
    std::vector<Vec3> free_sides(const std::vector<double>& pressure) const
    {
        std::vector<Vec3> sides(index(place_.rows), Vec3::Zero());
        for (int row = 0; row < place_.rows; ++row) {
            for (int column = 0; column < place_.columns; ++column) {
                const double held = sheet_.force_scale * pressure[place_.at(row, column)];
                if (held < least_pressure) sides[index(row)] += place_.ray(row, column);
            }
        }
        sides = smoothed(sides);
        double largest = 1e-9;
        for (const Vec3& side : sides)
            largest = std::max(largest, side.norm());
        for (Vec3& side : sides)
            side /= largest;
        return sides;
    }

    /// Of each row on the wall [N].
    std::vector<double> forces(const std::vector<double>& pressure) const
    {
        const double area = sheet_.length / (place_.rows - 1) * 2.0 * std::numbers::pi *
                            sheet_.radius / place_.columns;
        std::vector<double> sums(index(place_.rows), 0.0);
        for (std::size_t i = 0; i < pressure.size(); ++i)
            sums[i / index(place_.columns)] += area * pressure[i];
        return sums;
    }

    HiddenDevice device_of(const SheetAtRest& rest) const
    {
        HiddenDevice device{.rows = place_.rows,
                            .columns = place_.columns,
                            .row_step = sheet_.length / (place_.rows - 1),
                            .points = {},
                            .radii = rest.radii,
                            .pressure = rest.pressure,
                            .arc_length = rows_,
                            .iterations = rest.iterations};
        for (double& pressure : device.pressure)
            pressure *= sheet_.force_scale;
        for (int row = 0; row < place_.rows; ++row) {
            for (int column = 0; column < place_.columns; ++column) {
                device.points.push_back(scene_.frame * Vec3(place_.sections[index(row)].origin +
                                                            rest.radii[place_.at(row, column)] *
                                                                place_.ray(row, column)));
            }
        }
        return device;
    }

    const HiddenScene& scene_;
    PhantomShape shape_;
    BraidSheet sheet_;
    SheetPlace place_;
    std::vector<CrossSection> axis_;  // of each row
    double phase_ = 0.0;
    std::vector<double> rows_;
};

}  // namespace

std::vector<double> released_rows(const HiddenScene& scene, double length, int rows)
{
    constexpr int steps_per_row = 10;
    const double step = length / (rows - 1) / steps_per_row;
    std::vector<double> places = {scene.landing};
    double s = scene.landing;
    for (int row = 1; row < rows; ++row) {
        for (int i = 0; i < steps_per_row; ++i) {
            const double middle = s - 0.5 * step * scene.spacing(s);
            s -= step * scene.spacing(middle);
        }
        places.push_back(s);
    }
    return places;
}

HiddenDevice placed_device(const HiddenScene& scene, const SheetResolution& resolution)
{
    return Placing(scene, resolution).settled();
}

}  // namespace braidzone::hidden
