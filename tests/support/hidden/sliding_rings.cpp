#include "support/hidden/sliding_rings.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace braidzone::hidden {
namespace {

constexpr double rounding = 5e-6;       // of the friction [m]
constexpr double largest_step = 30e-6;  // of a ring in one iteration [m]
constexpr double small_step = 0.05e-6;  // [m]
constexpr int most_iterations = 2000;

/// Of the wires in a gap, by the gap: force that closes it [N], and its slope [N/m].
struct GapForce {
    double force = 0.0, slope = 0.0;
};

/// @param hoop  of each column: (cos b r / R0)^2 at the gap
GapForce gap_force(const BraidSheet& sheet, double step, const std::vector<double>& hoop,
                   double gap)
{
    const double square_sine =
        sheet.braid_ratio * sheet.braid_ratio / (1.0 + sheet.braid_ratio * sheet.braid_ratio);
    const double spacing = gap / step;
    const double circumference = 2.0 * std::numbers::pi * sheet.radius;
    GapForce sum;
    for (const double around : hoop) {
        const double length = std::sqrt(square_sine * spacing * spacing + around);
        const double rise = square_sine * spacing / length;
        const double curvature = (square_sine - rise * rise) / length;
        const double share =
            2.0 * sheet.wire_stiffness * circumference / static_cast<double>(hoop.size());
        sum.force += share * (length - 1.0) * rise;
        sum.slope +=
            share / step * std::max(0.2 * rise * rise, rise * rise + (length - 1.0) * curvature);
    }
    return sum;
}

/// Solves the symmetric tridiagonal system in place.
std::vector<double> solved(std::vector<double> diagonal, const std::vector<double>& beside,
                           std::vector<double> right)
{
    const std::size_t n = diagonal.size();
    for (std::size_t i = 1; i < n; ++i) {
        const double factor = beside[i - 1] / diagonal[i - 1];
        diagonal[i] -= factor * beside[i - 1];
        right[i] -= factor * right[i - 1];
    }
    for (std::size_t i = n; i-- > 0;) {
        if (i + 1 < n) right[i] -= beside[i] * right[i + 1];
        right[i] /= diagonal[i];
    }
    return right;
}

std::vector<std::vector<double>> hoops_of(const BraidSheet& sheet, const std::vector<double>& radii,
                                          std::size_t rows)
{
    const std::size_t columns = radii.size() / rows;
    const double square_cosine = 1.0 / (1.0 + sheet.braid_ratio * sheet.braid_ratio);
    std::vector<std::vector<double>> hoops(rows - 1);
    for (std::size_t i = 0; i + 1 < rows; ++i) {
        for (std::size_t j = 0; j < columns; ++j) {
            const double r = 0.5 * (radii[i * columns + j] + radii[(i + 1) * columns + j]);
            hoops[i].push_back(square_cosine * std::pow(r / sheet.radius, 2));
        }
    }
    return hoops;
}

}  // namespace

std::vector<double> slid_rings(const BraidSheet& sheet, const std::vector<double>& released,
                               const std::vector<double>& radii, const std::vector<double>& force,
                               double friction)
{
    const std::size_t rows = released.size();
    const double step = sheet.length / static_cast<double>(rows - 1);
    const std::vector<std::vector<double>> hoops = hoops_of(sheet, radii, rows);
    std::vector<double> rings = released;
    for (int iteration = 0; iteration < most_iterations; ++iteration) {
        std::vector<double> gradient(rows), diagonal(rows), beside(rows - 1);
        for (std::size_t i = 0; i < rows; ++i) {
            const double slid = rings[i] - released[i];
            const double root = std::hypot(slid, rounding);
            gradient[i] = friction * force[i] * slid / root;
            // The curvature of a secant rather than a tangent: it does not overshoot.
            diagonal[i] = friction * force[i] / root + 1e-9 * sheet.wire_stiffness;
        }
        for (std::size_t i = 0; i + 1 < rows; ++i) {
            const GapForce wires = gap_force(sheet, step, hoops[i], rings[i] - rings[i + 1]);
            gradient[i] += wires.force;
            gradient[i + 1] -= wires.force;
            diagonal[i] += wires.slope;
            diagonal[i + 1] += wires.slope;
            beside[i] = -wires.slope;
        }
        const std::vector<double> change = solved(diagonal, beside, gradient);
        double largest = 0.0;
        for (const double one : change)
            largest = std::max(largest, std::abs(one));
        const double damping = std::min(1.0, largest_step / largest);
        for (std::size_t i = 0; i < rows; ++i)
            rings[i] -= damping * change[i];
        if (largest < small_step) break;
    }
    return rings;
}

}  // namespace braidzone::hidden
