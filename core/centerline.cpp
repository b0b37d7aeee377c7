#include "core/centerline.hpp"

#include "core/cubic_spline.hpp"
#include "core/error.hpp"

#include <Eigen/Cholesky>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace braidzone {

namespace {

void require_usable(const Polyline& polyline, const ResampleOptions& options)
{
    if (!(options.spacing > 0.0 && std::isfinite(options.spacing))) {
        throw InputError(fmt::format("centerline spacing = {:.6g} mm; it must be positive",
                                     1e3 * options.spacing));
    }
    if (!(options.smoothing >= 0.0 && std::isfinite(options.smoothing))) {
        throw InputError(fmt::format("centerline smoothing = {:.6g} radii; it must not be negative",
                                     options.smoothing));
    }
    if (polyline.inscribed_radii.size() != polyline.points.size()) {
        throw InputError(fmt::format("centerline has {} points and {} radii; each point needs one",
                                     polyline.points.size(), polyline.inscribed_radii.size()));
    }
    for (std::size_t i = 0; i < polyline.points.size(); ++i) {
        if (!polyline.points[i].allFinite()) {
            throw InputError(fmt::format("centerline point {} is not finite", i));
        }
        if (!(polyline.inscribed_radii[i] > 0.0 && std::isfinite(polyline.inscribed_radii[i]))) {
            throw InputError(fmt::format(
                "centerline point {} has radius {:.6g} mm; it must be positive and finite", i,
                1e3 * polyline.inscribed_radii[i]));
        }
    }
}

/// The polyline without points closer than `tolerance` to their predecessor; the end stays.
Polyline without_repeated_points(const Polyline& polyline, double tolerance)
{
    Polyline distinct;
    for (std::size_t i = 0; i < polyline.points.size(); ++i) {
        if (i > 0 && (polyline.points[i] - distinct.points.back()).norm() < tolerance) continue;
        distinct.points.push_back(polyline.points[i]);
        distinct.inscribed_radii.push_back(polyline.inscribed_radii[i]);
    }
    if (distinct.points.size() > 1) distinct.points.back() = polyline.points.back();
    return distinct;
}

/// Points of the curve at uniform arc length, with tangents and linearly interpolated radii.
struct UniformCurve {
    double spacing = 0.0;  ///< [m]
    std::vector<Vec3> points;
    std::vector<Vec3> tangents;
    std::vector<double> radii;
};

UniformCurve sample_uniformly(const Polyline& polyline, double wanted_spacing)
{
    const CubicSpline spline = fit_spline(polyline.points);
    const int intervals =
        std::max(1, static_cast<int>(std::lround(spline.length() / wanted_spacing)));
    UniformCurve curve;
    curve.spacing = spline.length() / intervals;
    for (int i = 0; i <= intervals; ++i) {
        const SplinePlace place = place_at(spline, i * curve.spacing);
        const auto piece = static_cast<std::size_t>(place.piece);
        curve.points.push_back(point_at(spline, place));
        curve.tangents.push_back(derivative_at(spline, place).normalized());
        curve.radii.push_back((1.0 - place.fraction) * polyline.inscribed_radii[piece] +
                              place.fraction * polyline.inscribed_radii[piece + 1]);
    }
    return curve;
}

/// Value at sample `centre` of the quadratic in arc length that fits the samples around it best,
/// with Gaussian weights (local polynomial regression; Fan and Gijbels 1996, section 3.1).
Vec3 local_quadratic(const std::vector<Vec3>& points, int centre, double deviation_in_samples)
{
    // Beyond four standard deviations a weight is below 4e-4.
    const int reach = static_cast<int>(std::ceil(4.0 * deviation_in_samples));
    const int first = std::max(0, centre - reach);
    const int last = std::min(static_cast<int>(points.size()) - 1, centre + reach);
    Mat3 moments = Mat3::Zero(), values = Mat3::Zero();
    for (int i = first; i <= last; ++i) {
        const double u = (i - centre) / deviation_in_samples;
        const Vec3 powers(1.0, u, u * u);
        const double weight = std::exp(-0.5 * u * u);
        moments += weight * powers * powers.transpose();
        values += weight * powers *
                  (points[static_cast<std::size_t>(i)] - points[static_cast<std::size_t>(centre)])
                      .transpose();
    }
    const Mat3 coefficients = moments.ldlt().solve(values);
    return points[static_cast<std::size_t>(centre)] + coefficients.row(0).transpose();
}

/// Smooths the points with a Gaussian of the given standard deviation [m]; the ends stay, and
/// their corrections fade inwards over the same length.
std::vector<Vec3> smoothed(const UniformCurve& curve, double deviation)
{
    const int n = static_cast<int>(curve.points.size());
    std::vector<Vec3> result;
    for (int i = 0; i < n; ++i) {
        result.push_back(local_quadratic(curve.points, i, deviation / curve.spacing));
    }
    const Vec3 first_correction = curve.points.front() - result.front();
    const Vec3 last_correction = curve.points.back() - result.back();
    const auto fading = [&](int samples) {
        const double u = samples * curve.spacing / deviation;
        return std::exp(-0.5 * u * u);
    };
    for (int i = 0; i < n; ++i) {
        result[static_cast<std::size_t>(i)] +=
            fading(i) * first_correction + fading(n - 1 - i) * last_correction;
    }
    result.front() = curve.points.front();
    result.back() = curve.points.back();
    return result;
}

/// A unit vector normal to `direction`: the coordinate axis least along it, made orthogonal.
Vec3 any_normal(const Vec3& direction)
{
    int axis = 0;
    direction.cwiseAbs().minCoeff(&axis);
    const Vec3 unit = Vec3::Unit(axis);
    return (unit - unit.dot(direction) * direction).normalized();
}

/// The reflection of `vector` in the plane normal to `mirror_normal`.
Vec3 reflected(const Vec3& vector, const Vec3& mirror_normal)
{
    return vector - 2.0 * mirror_normal.dot(vector) / mirror_normal.squaredNorm() * mirror_normal;
}

/// The normal carried from one section to the next: reflection in the plane between the two
/// points, then in the plane between the reflected and the new tangent (Wang et al. 2008, table I).
Vec3 carried_normal(const CrossSection& from, const Vec3& point, const Vec3& tangent)
{
    const Vec3 chord = point - from.origin;
    const Vec3 normal = reflected(from.normal, chord);
    return reflected(normal, tangent - reflected(from.tangent, chord));
}

Vec3 without_component(const Vec3& vector, const Vec3& unit)
{
    return (vector - vector.dot(unit) * unit).normalized();
}

}  // namespace

Centerline resample(const Polyline& polyline, const ResampleOptions& options)
{
    require_usable(polyline, options);
    if (polyline.points.size() < 2) {
        throw InputError(
            fmt::format("centerline has {} points; at least 2 are needed", polyline.points.size()));
    }
    Polyline line = without_repeated_points(polyline, 0.01 * options.spacing);
    if (line.points.size() < 2) {
        throw InputError(fmt::format("all {} points of the centerline are at one place",
                                     polyline.points.size()));
    }

    const double mean_radius =
        std::accumulate(line.inscribed_radii.begin(), line.inscribed_radii.end(), 0.0) /
        static_cast<double>(line.inscribed_radii.size());
    const double deviation = options.smoothing * mean_radius;
    if (deviation > 0.0) {
        // Fine enough for the sum over samples to stand for the integral over the Gaussian.
        const UniformCurve fine =
            sample_uniformly(line, std::min(options.spacing, 0.2 * deviation));
        if (fine.points.size() >= 5) line = {smoothed(fine, deviation), fine.radii};
    }

    const UniformCurve curve = sample_uniformly(line, options.spacing);
    Centerline centerline;
    centerline.spacing = curve.spacing;
    for (std::size_t i = 0; i < curve.points.size(); ++i) {
        CrossSection section;
        section.origin = curve.points[i];
        section.tangent = curve.tangents[i];
        section.normal = i == 0 ? any_normal(section.tangent)
                                : without_component(carried_normal(centerline.sections.back(),
                                                                   section.origin, section.tangent),
                                                    section.tangent);
        section.binormal = section.tangent.cross(section.normal);
        section.inscribed_radius = curve.radii[i];
        centerline.sections.push_back(section);
    }
    return centerline;
}

CrossSection section_at(const Centerline& centerline, double arc_length)
{
    // Sums of spacings may miss the end by rounding.
    const double length = centerline.length(), rounding = 1e-9 * length;
    if (!(arc_length >= -rounding && arc_length <= length + rounding)) {
        throw InputError(fmt::format("arc length = {:.6g} mm; the centerline has 0 to {:.6g} mm",
                                     1e3 * arc_length, 1e3 * length));
    }
    const double position = arc_length / centerline.spacing;
    const auto last_interval = static_cast<double>(centerline.sections.size() - 2);
    const double interval = std::clamp(std::floor(position), 0.0, last_interval);
    const double f = std::clamp(position - interval, 0.0, 1.0), g = 1.0 - f;
    const CrossSection& a = centerline.sections[static_cast<std::size_t>(interval)];
    const CrossSection& b = centerline.sections[static_cast<std::size_t>(interval) + 1];

    CrossSection section;
    // Cubic Hermite interpolation.
    section.origin = g * g * (1.0 + 2.0 * f) * a.origin + f * f * (1.0 + 2.0 * g) * b.origin +
                     centerline.spacing * f * g * (g * a.tangent - f * b.tangent);
    section.tangent = (g * a.tangent + f * b.tangent).normalized();
    section.normal = without_component(g * a.normal + f * b.normal, section.tangent);
    section.binormal = section.tangent.cross(section.normal);
    section.inscribed_radius = g * a.inscribed_radius + f * b.inscribed_radius;
    return section;
}

double nearest_arc_length(const Centerline& centerline, const Vec3& point)
{
    double nearest = std::numeric_limits<double>::infinity();
    double arc_length = 0.0;
    for (std::size_t i = 0; i + 1 < centerline.sections.size(); ++i) {
        const Vec3& start = centerline.sections[i].origin;
        const Vec3 chord = centerline.sections[i + 1].origin - start;
        const double fraction =
            std::clamp((point - start).dot(chord) / chord.squaredNorm(), 0.0, 1.0);
        const double distance = (start + fraction * chord - point).squaredNorm();
        if (distance < nearest) {
            nearest = distance;
            arc_length = (static_cast<double>(i) + fraction) * centerline.spacing;
        }
    }
    return arc_length;
}

}  // namespace braidzone
