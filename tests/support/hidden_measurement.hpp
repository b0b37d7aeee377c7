#pragma once

#include "core/phantom.hpp"
#include "core/wall_offset.hpp"
#include "core/wall_tree.hpp"
#include "deploy/deployment.hpp"
#include "deploy/device_lining.hpp"
#include "discrepancy/lumen.hpp"
#include "discrepancy/measured_scalars.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <numbers>
#include <random>
#include <utility>
#include <vector>

// Measurements of a device with something hidden in them, made otherwise than the solver under test
// makes its own: a vessel mesh of other triangles with imperfections, a finer lattice with other
// coefficients, time step and order of release, a smooth table of ring spacing in place of windows,
// noise, correlated bias of the segmentation, outliers, occlusion, and a misplaced scan.

namespace braidzone::test {

/// A smooth random function of place: a sum of plane waves whose correlation is Gaussian.
class SmoothField {
public:
    SmoothField(double sd, double length, std::mt19937& random)
    {
        std::normal_distribution<double> normal;
        std::uniform_real_distribution<double> phase(0.0, 2.0 * std::numbers::pi);
        constexpr int num_waves = 60;
        for (int i = 0; i < num_waves; ++i) {
            waves_.push_back(Vec3(normal(random), normal(random), normal(random)) / length);
            phases_.push_back(phase(random));
        }
        amplitude_ = sd * std::sqrt(2.0 / num_waves);
    }

    double operator()(const Vec3& point) const
    {
        double sum = 0.0;
        for (std::size_t i = 0; i < waves_.size(); ++i)
            sum += std::cos(waves_[i].dot(point) + phases_[i]);
        return amplitude_ * sum;
    }

private:
    std::vector<Vec3> waves_;
    std::vector<double> phases_;
    double amplitude_ = 0.0;
};

/// What spoils every measurement, whether an effect is hidden in it or not.
struct Nuisances {
    double noise_sd = 0.07e-3;           ///< of a point [m]
    double bias_sd = 0.015e-3;           ///< of the segmentation, correlated [m]
    double wall_sd = 0.02e-3;            ///< of the true vessel's wall about the given one [m]
    double correlation_length = 2.2e-3;  ///< of both [m]
    double shift_sd = 0.07e-3;           ///< of the registration, along each axis [m]
    double angle_sd = 0.012;             ///< about each axis [rad]
    double landing_sd = 0.15e-3;         ///< [m]
    double spring_sd = 0.08;             ///< relative
    double outlier_share = 0.025;
    int num_points = 3000;
    int num_holes = 2;
    double end_sd = 0.3e-3;  ///< of the markers' positions [m]
};

/// What is hidden.
struct Hidden {
    std::vector<SpacingPoint> spacing = {};  ///< ring spacing along the vessel
    double centre = 0.0;                     ///< of the push or pull in it, for the scorer [m]
    double diameter_change = 0.0;            ///< [m]
    double ratio_change = 0.0;               ///< relative
    double landing_offset = 0.0;             ///< [m]
    double radius_change = 0.0;              ///< of the parent vessel [m]
    double wall_stiffness = rigid_wall;      ///< [Pa/m]
    double blooming = 0.0;                   ///< [m]
    Vec3 shift = Vec3::Zero();               ///< of the scan [m]
    Vec3 rotation = Vec3::Zero();            ///< of the scan [rad]
    /// Displacement of the surface along its normal that no deployment makes [m].
    std::function<double(const Vec3&)> dent = {};
};

struct HiddenMeasurement {
    std::vector<Vec3> points;
    MeasuredScalars ends;  ///< distal and proximal, with their standard deviations
    Deployment deployment;
};

/// Ring spacing with one smooth dip or rise: a plateau about the centre, whose distal flank is half
/// again as long as its proximal one; half as high a half-width from the centre on either side.
inline std::vector<SpacingPoint> smooth_spacing(double centre, double half_width, double change)
{
    std::vector<SpacingPoint> table = {{0.0, 1.0}};
    const double proximal = 0.8 * half_width, distal = 1.2 * half_width;  // lengths of the flanks
    constexpr int steps = 10;
    const auto add_flank = [&](double from, double to, double turned_round) {
        for (int i = 0; i <= steps; ++i) {
            const double x = std::abs(turned_round - static_cast<double>(i) / steps);
            table.push_back({from + (to - from) * i / steps,
                             1.0 + change * std::pow(std::sin(0.5 * std::numbers::pi * x), 2)});
        }
    };
    add_flank(centre - half_width - 0.5 * proximal, centre - half_width + 0.5 * proximal, 0.0);
    add_flank(centre + half_width - 0.5 * distal, centre + half_width + 0.5 * distal, 1.0);
    return table;
}

inline Vec3 turned(const Vec3& rotation, const Vec3& point)
{
    const double angle = rotation.norm();
    return angle > 0.0 ? Vec3(Eigen::AngleAxisd(angle, rotation / angle) * point) : point;
}

/// The lumen that a deployment really took place in: other triangles, an uneven wall.
inline Lumen true_lumen(Phantom phantom, const Hidden& hidden, const Nuisances& nuisances,
                        std::mt19937& random)
{
    phantom.edge_length *= 0.77;
    phantom.proximal_radius += hidden.radius_change;
    phantom.distal_radius += hidden.radius_change;
    PhantomVessel made = make_phantom(phantom);
    const SmoothField unevenness(nuisances.wall_sd, nuisances.correlation_length, random);
    const TriangleMesh outer = with_wall_offset(made.wall, 1e-3);
    for (std::size_t i = 0; i < made.wall.points.size(); ++i) {
        Vec3& point = made.wall.points[i];
        point += unevenness(point) * (outer.points[i] - point) / 1e-3;
    }
    Vessel vessel = make_vessel(made.wall, LengthUnit{});
    WallTree wall(vessel);
    return {std::move(vessel), std::move(wall), resample(made.centerline)};
}

/// Random points of a surface, each area alike.
inline std::vector<std::pair<Vec3, Vec3>> points_with_normals(const TriangleMesh& mesh, int count,
                                                              std::mt19937& random)
{
    std::vector<double> areas;
    for (int t = 0; t < static_cast<int>(mesh.triangles.size()); ++t)
        areas.push_back(area_vector(mesh, t).norm());
    std::discrete_distribution<int> triangle(areas.begin(), areas.end());
    std::uniform_real_distribution<double> uniform(0.0, 1.0);
    std::vector<std::pair<Vec3, Vec3>> points;
    for (int i = 0; i < count; ++i) {
        const int t = triangle(random);
        const auto& [a, b, c] = mesh.triangles[static_cast<std::size_t>(t)];
        double u = uniform(random), v = uniform(random);
        if (u + v > 1.0) {
            u = 1.0 - u;
            v = 1.0 - v;
        }
        const Vec3& p = mesh.points[static_cast<std::size_t>(a)];
        points.emplace_back(p + u * (mesh.points[static_cast<std::size_t>(b)] - p) +
                                v * (mesh.points[static_cast<std::size_t>(c)] - p),
                            area_vector(mesh, t).normalized());
    }
    return points;
}

/// Deploys a device with something hidden, and scans it.
/// @param phantom, device, landing  what the user believes
inline HiddenMeasurement hidden_measurement(const Phantom& phantom, FlowDiverter device,
                                            double landing, const Hidden& hidden,
                                            std::uint32_t seed, const Nuisances& nuisances = {})
{
    std::mt19937 random(seed);
    std::normal_distribution<double> normal;
    std::uniform_real_distribution<double> uniform(0.0, 1.0);
    const Lumen lumen = true_lumen(phantom, hidden, nuisances, random);
    device.num_wires = 64;
    device.nominal_diameter += hidden.diameter_change;
    device.braid_ratio *= (1.0 + hidden.ratio_change) * (1.0 + 0.01 * normal(random));
    device.radial_coefficient *= 1.0 + nuisances.spring_sd * normal(random);
    landing += hidden.landing_offset + nuisances.landing_sd * normal(random);
    HiddenMeasurement result;
    result.deployment = deploy(device, lumen.centerline, lumen.wall, landing,
                               {.windows = {}, .table = hidden.spacing},
                               {.release_order = ReleaseOrder::at_once,
                                .wall_stiffness = hidden.wall_stiffness,
                                .time_step_ratio = 0.45,
                                .damping = 0.15});

    const SmoothField bias(nuisances.bias_sd, nuisances.correlation_length, random);
    const TriangleMesh surface = inner_surface(result.deployment, 0.0);
    const auto samples = points_with_normals(surface, nuisances.num_points, random);
    Vec3 middle = Vec3::Zero();
    for (const auto& [point, normal_there] : samples)
        middle += point / static_cast<double>(samples.size());
    const auto random_vector = [&](double sd) {
        return Vec3(sd * normal(random), sd * normal(random), sd * normal(random));
    };
    const Vec3 shift = hidden.shift + random_vector(nuisances.shift_sd);
    const Vec3 rotation = hidden.rotation + random_vector(nuisances.angle_sd);
    std::vector<Vec3> holes;
    for (int i = 0; i < nuisances.num_holes; ++i) {
        const auto at = static_cast<std::size_t>(uniform(random) * (nuisances.num_points - 1));
        holes.push_back(samples[at].first);
    }
    for (const auto& [point, normal_there] : samples) {
        const double noise = nuisances.noise_sd * normal(random);
        const double wild = uniform(random), wild_size = 0.3e-3 + 1.2e-3 * uniform(random);
        const bool is_hidden = std::any_of(holes.begin(), holes.end(), [&](const Vec3& hole) {
            return (point - hole).norm() < 0.9e-3;
        });
        if (is_hidden) continue;
        double out = bias(point) + hidden.blooming + noise;
        if (hidden.dent) out += hidden.dent(point);
        if (wild < nuisances.outlier_share)
            out += wild < 0.5 * nuisances.outlier_share ? wild_size : -wild_size;
        result.points.push_back(turned(rotation, point + out * normal_there - middle) + middle +
                                shift);
    }
    result.ends.values[0] = {
        result.deployment.ring_arc_length.front() + nuisances.end_sd * normal(random),
        nuisances.end_sd};
    result.ends.values[1] = {
        result.deployment.ring_arc_length.back() + nuisances.end_sd * normal(random),
        nuisances.end_sd};
    return result;
}

}  // namespace braidzone::test
