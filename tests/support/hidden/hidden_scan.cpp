#include "support/hidden/hidden_scan.hpp"

#include "support/hidden/smooth_field.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace braidzone::hidden {
namespace {

/// A point of the device's surface.
struct Sample {
    Vec3 point, normal;
    double radius = 0.0;  ///< of the device there [m]
    double row = 0.0;     ///< from the distal end, 0 to rows - 1
};

double uniform(double low, double high, std::mt19937& random)
{
    return std::uniform_real_distribution<double>(low, high)(random);
}

double normal(double sd, std::mt19937& random)
{
    return sd * std::normal_distribution<double>()(random);
}

Vec3 random_vector(double sd, std::mt19937& random)
{
    const double x = normal(sd, random), y = normal(sd, random), z = normal(sd, random);
    return {x, y, z};
}

/// A nuisance of 2.5 standard deviations at most in each: beyond that it would be an effect.
Vec3 ordinary_vector(double sd, std::mt19937& random)
{
    return random_vector(sd, random).cwiseMax(-2.5 * sd).cwiseMin(2.5 * sd);
}

Vec3 random_direction(std::mt19937& random)
{
    return random_vector(1.0, random).normalized();
}

/// The four corners of a cell.
struct Cell {
    std::size_t a, b, c, d;  ///< b is next to a along the device, c around, d both
    int row;
};

std::vector<Cell> cells_of(const HiddenDevice& device)
{
    std::vector<Cell> cells;
    const auto at = [&](int row, int column) {
        return static_cast<std::size_t>(row * device.columns + column % device.columns);
    };
    for (int row = 0; row + 1 < device.rows; ++row) {
        for (int column = 0; column < device.columns; ++column) {
            cells.push_back({at(row, column), at(row + 1, column), at(row, column + 1),
                             at(row + 1, column + 1), row});
        }
    }
    return cells;
}

/// Random points, denser where the weight of a cell is larger.
std::vector<Sample> samples_of(const HiddenDevice& device, int count, double unevenness,
                               std::mt19937& random)
{
    const std::vector<Cell> cells = cells_of(device);
    const Vec3 bright = random_direction(random);
    std::vector<Vec3> areas;
    std::vector<double> weights;
    const std::vector<Vec3>& p = device.points;
    for (const Cell& cell : cells) {
        // Rows run upstream and columns around the axis' tangent: this points outwards.
        areas.push_back(0.5 * (p[cell.d] - p[cell.a]).cross(p[cell.c] - p[cell.b]));
        const double side = areas.back().normalized().dot(bright);
        weights.push_back(areas.back().norm() * std::max(0.1, 1.0 + unevenness * side));
    }
    std::discrete_distribution<std::size_t> pick(weights.begin(), weights.end());
    std::vector<Sample> samples;
    for (int i = 0; i < count; ++i) {
        const std::size_t k = pick(random);
        const Cell& cell = cells[k];
        const double u = uniform(0.0, 1.0, random), v = uniform(0.0, 1.0, random);
        samples.push_back({(1.0 - v) * ((1.0 - u) * p[cell.a] + u * p[cell.b]) +
                               v * ((1.0 - u) * p[cell.c] + u * p[cell.d]),
                           areas[k].normalized(), device.radii[cell.a], cell.row + u});
    }
    return samples;
}

/// Takes out what the scan does not show: holes, half of a slab, a piece of one end.
std::vector<Sample> seen_of(std::vector<Sample> samples, const HiddenDevice& device,
                            double nominal_step, const ScanErrors& errors, std::mt19937& random)
{
    const auto any = [&] {
        return samples[std::uniform_int_distribution<std::size_t>(0, samples.size() - 1)(random)]
            .point;
    };
    std::vector<std::pair<Vec3, double>> holes;
    for (int i = 0; i < errors.num_holes; ++i)
        holes.emplace_back(any(), uniform(0.6e-3, 1.1e-3, random));
    const Vec3 streak = any(), across = random_direction(random);
    const bool misses_distal = uniform(0.0, 1.0, random) < 0.5;
    std::erase_if(samples, [&](const Sample& sample) {
        for (const auto& [hole, radius] : holes) {
            if ((sample.point - hole).norm() < radius) return true;
        }
        const double from_end =
            nominal_step * (misses_distal ? sample.row : device.rows - 1 - sample.row);
        if (from_end < errors.missing_end) return true;
        const bool in_streak =
            std::abs((sample.point - streak).dot(across)) < 0.5 * errors.streak_width;
        return in_streak && uniform(0.0, 1.0, random) < 0.5;
    });
    return samples;
}

/// Distances along the normal by which the points are off, apart from what is hidden.
std::vector<double> point_errors(const std::vector<Sample>& samples, const ScanErrors& errors,
                                 std::mt19937& random)
{
    const SmoothField bias(errors.bias_sd, errors.correlation_length, random);
    const Vec3 artefact =
        samples[std::uniform_int_distribution<std::size_t>(0, samples.size() - 1)(random)].point;
    const double artefact_size =
        uniform(0.3e-3, 0.8e-3, random) * (uniform(0.0, 1.0, random) < 0.5 ? -1.0 : 1.0);
    std::vector<double> offsets;
    for (const Sample& sample : samples) {
        double off = bias(sample.point) + normal(errors.noise_sd, random);
        for (int axis = 0; axis < 3; ++axis) {
            off += errors.voxel_pull * sample.normal[axis] *
                   std::sin(2.0 * std::numbers::pi * sample.point[axis] / errors.voxel);
        }
        const double wild = uniform(0.0, 1.0, random), size = uniform(0.3e-3, 1.5e-3, random);
        if (wild < errors.outlier_share) off += wild < 0.5 * errors.outlier_share ? size : -size;
        const bool in_artefact = uniform(0.0, 1.0, random) < errors.artefact_share &&
                                 (sample.point - artefact).norm() < errors.artefact_radius;
        if (in_artefact) off += artefact_size;
        offsets.push_back(off);
    }
    return offsets;
}

Vec3 turned(const Vec3& rotation, const Vec3& point)
{
    const double angle = rotation.norm();
    return angle > 0.0 ? Vec3(Eigen::AngleAxisd(angle, rotation / angle) * point) : point;
}

Vec3 middle_of(const std::vector<Vec3>& points)
{
    Vec3 middle = Vec3::Zero();
    for (const Vec3& point : points)
        middle += point / static_cast<double>(points.size());
    return middle;
}

/// About the middle of the points before.
Vec3 moved(const ScannedDevice& scan, const Vec3& middle, const Vec3& point)
{
    return turned(scan.rotation, point - middle) + middle + scan.shift;
}

void misplace(ScannedDevice& scan)
{
    const Vec3 middle = middle_of(scan.points);
    for (Vec3& point : scan.points)
        point = moved(scan, middle, point);
}

}  // namespace

ScanErrors random_scan_errors(std::mt19937& random)
{
    ScanErrors errors;
    errors.noise_sd = uniform(0.05e-3, 0.10e-3, random);
    errors.blur = uniform(0.12e-3, 0.18e-3, random);
    errors.voxel = uniform(0.15e-3, 0.25e-3, random);
    errors.num_points = std::uniform_int_distribution<int>(2200, 3800)(random);
    errors.num_holes = std::uniform_int_distribution<int>(1, 3)(random);
    errors.artefact_share = uniform(0.15, 0.35, random);
    errors.streak_width = uniform(0.2e-3, 0.6e-3, random);
    errors.missing_end = uniform(0.0, 1.2e-3, random);
    errors.unevenness = uniform(0.2, 0.7, random);
    return errors;
}

double segmented_offset(double blur, double nominal_blur, double threshold_shift, double radius)
{
    const double half_height = std::sqrt(2.0 * std::numbers::ln2);
    // sqrt(2 ln(1 / f)) of the threshold at which a sheet of nominal blur is off by the shift
    const double cut = std::max(0.0, half_height + threshold_shift / nominal_blur);
    return blur * cut - nominal_blur * half_height - blur * blur / (2.0 * radius);
}

Vec3 as_scanned(const ScannedDevice& scan, const Vec3& point)
{
    return moved(scan, middle_of(scan.points) - scan.shift, point);
}

ScannedDevice scanned(const HiddenDevice& device, const HiddenScan& hidden,
                      const ScanErrors& errors, std::mt19937& random)
{
    const std::vector<Sample> samples =
        seen_of(samples_of(device, errors.num_points, errors.unevenness, random), device,
                device.row_step, errors, random);
    const std::vector<double> offsets = point_errors(samples, errors, random);
    const Vec3 long_side = random_direction(random);
    ScannedDevice scan;
    for (std::size_t i = 0; i < samples.size(); ++i) {
        const double along = samples[i].normal.dot(long_side);
        const double blur =
            errors.blur * std::sqrt(1.0 + 2.0 * errors.anisotropy * (along * along - 1.0 / 3.0));
        const double out =
            offsets[i] + segmented_offset(blur, errors.blur, hidden.blooming, samples[i].radius);
        scan.points.push_back(samples[i].point + out * samples[i].normal);
    }
    scan.shift = hidden.shift + ordinary_vector(errors.shift_sd, random);
    scan.rotation = hidden.rotation + ordinary_vector(errors.angle_sd, random);
    misplace(scan);
    for (const std::size_t end : {std::size_t{0}, std::size_t{1}}) {
        const double place = end == 0 ? device.arc_length.front() : device.arc_length.back();
        scan.ends.values[end] = {place + normal(errors.end_sd, random), errors.end_sd};
    }
    return scan;
}

}  // namespace braidzone::hidden
