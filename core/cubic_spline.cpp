#include "core/cubic_spline.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

namespace braidzone {

namespace {

// Gauss-Legendre nodes on [0, 1] and weights, exact to degree 9 (Abramowitz and Stegun 25.4.30).
constexpr std::array<double, 5> gauss_nodes = {0.046910077030668004, 0.23076534494715845, 0.5,
                                               0.7692346550528415, 0.953089922969332};
constexpr std::array<double, 5> gauss_weights = {0.11846344252809454, 0.23931433524968324,
                                                 0.28444444444444444, 0.23931433524968324,
                                                 0.11846344252809454};

double piece_width(const CubicSpline& spline, int piece)
{
    return spline.knots[static_cast<std::size_t>(piece) + 1] -
           spline.knots[static_cast<std::size_t>(piece)];
}

/// Arc length from the start of the piece to the place.
double arc_within_piece(const CubicSpline& spline, const SplinePlace& place)
{
    double sum = 0.0;
    for (std::size_t i = 0; i < gauss_nodes.size(); ++i) {
        const SplinePlace node{place.piece, place.fraction * gauss_nodes[i]};
        sum += gauss_weights[i] * derivative_at(spline, node).norm();
    }
    return sum * place.fraction * piece_width(spline, place.piece);
}

/// Second derivatives M from the continuity of the first,
///     h0 M0 + 2 (h0 + h1) M1 + h1 M2 = 6 ((p2 - p1) / h1 - (p1 - p0) / h0),
/// with M equal at both ends of the first and of the last piece. Thomas' algorithm.
std::vector<Vec3> solve_second_derivatives(const std::vector<double>& knots,
                                           const std::vector<Vec3>& points)
{
    const std::size_t n = points.size();
    std::vector<Vec3> second(n, Vec3::Zero());
    if (n < 3) return second;
    std::vector<double> upper(n, 0.0);
    for (std::size_t i = 1; i + 1 < n; ++i) {
        const double before = knots[i] - knots[i - 1];
        const double after = knots[i + 1] - knots[i];
        double lower = before;
        double diagonal = 2.0 * (before + after);
        upper[i] = after;
        if (i == 1) {
            diagonal += before;
            lower = 0.0;
        }
        if (i + 2 == n) {
            diagonal += after;
            upper[i] = 0.0;
        }
        const Vec3 right =
            6.0 * ((points[i + 1] - points[i]) / after - (points[i] - points[i - 1]) / before);
        const double pivot = diagonal - lower * upper[i - 1];
        upper[i] /= pivot;
        second[i] = (right - lower * second[i - 1]) / pivot;
    }
    for (std::size_t i = n - 2; i >= 2; --i)
        second[i - 1] -= upper[i - 1] * second[i];
    second[0] = second[1];
    second[n - 1] = second[n - 2];
    return second;
}

}  // namespace

CubicSpline fit_spline(const std::vector<Vec3>& points)
{
    assert(points.size() >= 2);
    CubicSpline spline;
    spline.points = points;
    spline.knots.assign(points.size(), 0.0);
    for (std::size_t i = 1; i < points.size(); ++i) {
        spline.knots[i] = spline.knots[i - 1] + (points[i] - points[i - 1]).norm();
    }
    spline.second_derivatives = solve_second_derivatives(spline.knots, points);
    spline.arc_lengths.assign(points.size(), 0.0);
    for (std::size_t i = 1; i < points.size(); ++i) {
        spline.arc_lengths[i] =
            spline.arc_lengths[i - 1] + arc_within_piece(spline, {static_cast<int>(i) - 1, 1.0});
    }
    return spline;
}

SplinePlace place_at(const CubicSpline& spline, double arc_length)
{
    const auto next =
        std::upper_bound(spline.arc_lengths.begin() + 1, spline.arc_lengths.end() - 1, arc_length);
    SplinePlace place;
    place.piece = static_cast<int>(next - spline.arc_lengths.begin()) - 1;
    const double start = *(next - 1), piece_length = *next - start;
    const double wanted = std::clamp(arc_length - start, 0.0, piece_length);

    // Newton's method, kept between bounds by bisection; arc length grows with the fraction.
    double low = 0.0, high = 1.0;
    place.fraction = wanted / piece_length;
    for (int step = 0; step < 60; ++step) {
        const double excess = arc_within_piece(spline, place) - wanted;
        if (std::abs(excess) <= 1e-14 * piece_length) break;
        (excess > 0.0 ? high : low) = place.fraction;
        const double slope = derivative_at(spline, place).norm() * piece_width(spline, place.piece);
        const double guess = place.fraction - excess / slope;
        place.fraction = guess > low && guess < high ? guess : 0.5 * (low + high);
    }
    return place;
}

Vec3 point_at(const CubicSpline& spline, const SplinePlace& place)
{
    const auto i = static_cast<std::size_t>(place.piece);
    const double b = place.fraction, a = 1.0 - b;
    const double width = piece_width(spline, place.piece);
    return a * spline.points[i] + b * spline.points[i + 1] +
           width * width / 6.0 *
               ((a * a * a - a) * spline.second_derivatives[i] +
                (b * b * b - b) * spline.second_derivatives[i + 1]);
}

Vec3 derivative_at(const CubicSpline& spline, const SplinePlace& place)
{
    const auto i = static_cast<std::size_t>(place.piece);
    const double b = place.fraction, a = 1.0 - b;
    const double width = piece_width(spline, place.piece);
    return (spline.points[i + 1] - spline.points[i]) / width +
           width / 6.0 *
               ((1.0 - 3.0 * a * a) * spline.second_derivatives[i] +
                (3.0 * b * b - 1.0) * spline.second_derivatives[i + 1]);
}

}  // namespace braidzone
