#include "support/hidden/sheet_terms.hpp"

#include <cmath>
#include <numbers>

namespace braidzone::hidden {
namespace {

constexpr double wall_step = 1e-6;  // of the derivative along a ray [m]

}  // namespace

SheetTerms::SheetTerms(const BraidSheet& sheet, const SheetPlace& place)
    : sheet_(sheet), place_(place)
{
    row_step_ = sheet.length / (place.rows - 1);
    around_step_ = 2.0 * std::numbers::pi * sheet.radius / place.columns;
    // A chord of the grid is this much shorter than its arc.
    const double half = std::numbers::pi / place.columns;
    chord_ = half / std::sin(half);
    for (int row = 0; row < place.rows; ++row) {
        for (int column = 0; column < place.columns; ++column)
            rays_.push_back(place.ray(row, column));
    }
    for (int row = 1; row + 1 < place.rows; ++row) {
        for (int column = 0; column < place.columns; ++column) {
            for (const double family : {1.0, -1.0})
                bends_.push_back(bend(row, column, family));
        }
    }
}

Assembly SheetTerms::assemble(const Eigen::VectorXd& radii, bool with_hessian,
                              double sideways) const
{
    Assembly sum;
    sum.gradient = Eigen::VectorXd::Zero(radii.size());
    sum.with_hessian = with_hessian;
    sum.sideways = sideways;
    std::vector<Vec3> points;
    for (std::size_t i = 0; i < rays_.size(); ++i)
        points.push_back(origin(i) + radii[static_cast<Eigen::Index>(i)] * rays_[i]);
    add_wires(points, sum);
    for (const LinearTerm& term : bends_)
        add_bend(term, radii, sum);
    for (std::size_t i = 0; i < rays_.size(); ++i)
        add_node(i, radii[static_cast<Eigen::Index>(i)], points[i], sum);
    return sum;
}

std::vector<double> SheetTerms::wall_pressure(const Eigen::VectorXd& radii) const
{
    std::vector<double> pressure;
    for (std::size_t i = 0; i < rays_.size(); ++i) {
        const Vec3 point = origin(i) + radii[static_cast<Eigen::Index>(i)] * rays_[i];
        pressure.push_back(wall_energy(place_.springs, place_.wall(row(i), point)).pressure);
    }
    return pressure;
}

Vec3 SheetTerms::origin(std::size_t i) const
{
    return place_.sections[static_cast<std::size_t>(row(i))].origin;
}

/// Of the force-free tube, of a point.
double SheetTerms::area(std::size_t i) const
{
    const bool is_end = row(i) == 0 || row(i) + 1 == place_.rows;
    return (is_end ? 0.5 : 1.0) * row_step_ * around_step_;
}

SheetTerms::Angle SheetTerms::braid_angle(int row) const
{
    const double ratio = sheet_.braid_ratio * place_.pitch[static_cast<std::size_t>(row)];
    const double secant = std::sqrt(1.0 + ratio * ratio);
    return {ratio / secant, 1.0 / secant};
}

LinearTerm SheetTerms::bend(int row, int column, double family) const
{
    const Angle angle = braid_angle(row);
    const double along = std::pow(angle.sine / row_step_, 2);
    const double around = std::pow(angle.cosine / around_step_, 2);
    const double mixed = 0.5 * family * angle.sine * angle.cosine / (row_step_ * around_step_);
    LinearTerm term{};
    std::size_t k = 0;
    for (const int i : {-1, 0, 1}) {
        for (const int j : {-1, 0, 1}) {
            term.nodes[k] = place_.at(row + i, column + j);
            term.coefficients[k] = along * (j == 0 ? 1 - 3 * (i == 0) : 0) +
                                   around * (i == 0 ? 1 - 3 * (j == 0) : 0) + mixed * i * j;
            ++k;
        }
    }
    term.weight = sheet_.bending_stiffness * row_step_ * around_step_;
    return term;
}

void SheetTerms::add_bend(const LinearTerm& term, const Eigen::VectorXd& radii, Assembly& sum)
{
    double value = 0.0;
    for (std::size_t a = 0; a < 9; ++a)
        value += term.coefficients[a] * radii[static_cast<Eigen::Index>(term.nodes[a])];
    sum.energy += 0.5 * term.weight * value * value;
    for (std::size_t a = 0; a < 9; ++a) {
        const double part = term.weight * term.coefficients[a];
        sum.gradient[static_cast<Eigen::Index>(term.nodes[a])] += part * value;
        if (!sum.with_hessian) continue;
        for (std::size_t b = 0; b < 9; ++b)
            sum.add(term.nodes[a], term.nodes[b], part * term.coefficients[b]);
    }
}

/// Wires at the four corners of each cell, by the cell's two edges there: with the middle of
/// the cell instead, points could alternate at no cost.
void SheetTerms::add_wires(const std::vector<Vec3>& points, Assembly& sum) const
{
    for (int row = 0; row + 1 < place_.rows; ++row) {
        for (int column = 0; column < place_.columns; ++column) {
            for (const int up : {0, 1}) {
                for (const int right : {0, 1}) {
                    const std::size_t corner = place_.at(row + up, column + right);
                    add_corner(points,
                               {corner, place_.at(row + 1 - up, column + right),
                                place_.at(row + up, column + 1 - right)},
                               row + up, up == 0 ? 1.0 : -1.0, right == 0 ? 1.0 : -1.0, sum);
                }
            }
        }
    }
}

/// Both wires at a corner: nodes are the corner, its neighbour along and its neighbour around.
void SheetTerms::add_corner(const std::vector<Vec3>& points,
                            const std::array<std::size_t, 3>& nodes, int row, double along_sign,
                            double around_sign, Assembly& sum) const
{
    const Angle angle = braid_angle(row);
    const Vec3 along = along_sign * (points[nodes[1]] - points[nodes[0]]) / row_step_;
    const Vec3 around = around_sign * chord_ * (points[nodes[2]] - points[nodes[0]]) / around_step_;
    const double weight = 0.25 * sheet_.wire_stiffness * row_step_ * around_step_;
    for (const double family : {1.0, -1.0}) {
        const double a = angle.sine * along_sign / row_step_;
        const double b = family * angle.cosine * around_sign * chord_ / around_step_;
        const Vec3 wire = angle.sine * along + family * angle.cosine * around;
        add_wire(wire, nodes, {-a - b, a, b}, weight, sum);
    }
}

void SheetTerms::add_wire(const Vec3& wire, const std::array<std::size_t, 3>& nodes,
                          const std::array<double, 3>& coefficients, double weight,
                          Assembly& sum) const
{
    const double length = wire.norm();
    const double stretch = length - 1.0;
    sum.energy += 0.5 * weight * stretch * stretch;
    std::array<double, 3> slope{};
    for (std::size_t a = 0; a < 3; ++a) {
        slope[a] = coefficients[a] * wire.dot(rays_[nodes[a]]) / length;
        sum.gradient[static_cast<Eigen::Index>(nodes[a])] += weight * stretch * slope[a];
    }
    if (!sum.with_hessian) return;
    double sideways = stretch / length;
    if (sideways < 0.0) sideways *= sum.sideways;
    for (std::size_t a = 0; a < 3; ++a) {
        for (std::size_t b = 0; b < 3; ++b) {
            const double dot =
                coefficients[a] * coefficients[b] * rays_[nodes[a]].dot(rays_[nodes[b]]);
            sum.add(nodes[a], nodes[b],
                    weight * ((1.0 - sideways) * slope[a] * slope[b] + sideways * dot));
        }
    }
}

/// Radial spring, wall and load.
void SheetTerms::add_node(std::size_t i, double radius, const Vec3& point, Assembly& sum) const
{
    const double compression = sheet_.radius - radius;
    const double beyond = place_.wall(row(i), point + wall_step * rays_[i]);
    const double before = place_.wall(row(i), point - wall_step * rays_[i]);
    const WallEnergy wall = wall_energy(place_.springs, 0.5 * (beyond + before));
    const double wall_slope = 0.5 * (beyond - before) / wall_step;
    const double a = area(i);
    sum.energy += a * (0.5 * sheet_.radial_stiffness * compression * compression + wall.value -
                       place_.loads[i] * radius);
    sum.gradient[static_cast<Eigen::Index>(i)] +=
        a * (-sheet_.radial_stiffness * compression + wall.pressure * wall_slope - place_.loads[i]);
    if (sum.with_hessian) {
        sum.add(i, i, a * (sheet_.radial_stiffness + wall.slope * wall_slope * wall_slope));
    }
}

}  // namespace braidzone::hidden
