#include "discrepancy/discrepancy_field.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace braidzone {
namespace {

constexpr double turn = 2.0 * std::numbers::pi;
/// From the median absolute deviation of normal values to their standard deviation.
constexpr double sd_of_mad = 1.4826;
/// The deployment's own roughness, and the finest scatter that a few points can tell [m].
constexpr double smallest_point_sd = 0.01e-3;
/// Points that the scatter common to all patches counts for.
constexpr double pooled_points = 10.0;
/// Of Tukey's bisquare, for 95 % efficiency with normal values.
constexpr double bisquare_cut = 4.685;
constexpr int bisquare_rounds = 20;
/// How far beyond its rim a surface is continued by the plane that touches it there [m]: in a bend
/// of 15 mm it has left the wall by 5 um then.
constexpr double rim_reach = 0.4e-3;

std::size_t index(int i)
{
    return static_cast<std::size_t>(i);
}

/// What the patches collect of a point.
struct Collected {
    std::vector<int> points;
    std::vector<SurfaceFoot> feet;
};

Patch make_patch(int row, int column, const Collected& collected, const Deployment& deployment,
                 const PatchOptions& options)
{
    Patch patch{.row = row, .column = column, .points = collected.points};
    std::vector<double> distances;
    Vec3 normal = Vec3::Zero();
    double in_contact = 0.0, radius = 0.0;
    for (const SurfaceFoot& foot : collected.feet) {
        distances.push_back(foot.distance);
        patch.centre += foot.point;
        normal += foot.normal;
        in_contact += deployment.in_contact[index(foot.node)] != 0 ? 1.0 : 0.0;
        const int ring = foot.node / deployment.lattice.nodes_per_ring;
        radius += (foot.point - deployment.rings[index(ring)].origin).norm();
        patch.nodes.push_back(foot.node);
    }
    const auto count = static_cast<double>(distances.size());
    patch.centre /= count;
    patch.normal = normal.normalized();
    patch.contact_share = in_contact / count;
    std::sort(patch.nodes.begin(), patch.nodes.end());
    patch.nodes.erase(std::unique(patch.nodes.begin(), patch.nodes.end()), patch.nodes.end());
    patch.gap = median_of(distances);
    for (double& distance : distances)
        distance = std::abs(distance - patch.gap);
    patch.point_sd = std::max(sd_of_mad * median_of(distances), smallest_point_sd);
    patch.arc_length = (row + 0.5) * options.length;
    patch.angle = (column + 0.5) * turn / options.around;
    patch.area = options.length * turn / options.around * radius / count;
    return patch;
}

/// Distance of a point from the plane that touches the surface's middle at its foot [m].
double distance_along_normal(const SurfaceFoot& foot, const Vec3& point)
{
    return (point - foot.point).dot(foot.normal);
}

/// Signed distance of a point from an altered device's surface, which goes over to that from the
/// base device's where the altered one has ended.
double distance_from(const DeviceSurface& surface, const DeviceSurface& base, const Vec3& point)
{
    const SurfaceFoot foot = surface.nearest(point);
    if (!foot.is_on_rim) return foot.distance;
    const double along = distance_along_normal(foot, point);
    const double beyond = (point - foot.point - along * foot.normal).norm();
    const SurfaceFoot on_base = base.nearest(point);
    const double from_base = on_base.is_on_rim
                                 ? distance_along_normal(on_base, point) - base.half_thickness()
                                 : on_base.distance;
    return std::lerp(along - surface.half_thickness(), from_base,
                     std::min(1.0, beyond / rim_reach));
}

/// Draws the scatter of each patch towards the median of all.
void pool_scatter(std::vector<Patch>& patches)
{
    std::vector<double> sds;
    for (const Patch& patch : patches)
        sds.push_back(patch.point_sd);
    if (sds.empty()) return;
    const double common = median_of(sds);
    for (Patch& patch : patches) {
        const auto count = static_cast<double>(patch.points.size());
        patch.point_sd =
            std::sqrt((count * patch.point_sd * patch.point_sd + pooled_points * common * common) /
                      (count + pooled_points));
    }
}

/// Bisquare weights about the gap, and the gap with them, until both fit.
void weigh_points(Patch& patch, const std::vector<double>& distances)
{
    for (int round = 0; round < bisquare_rounds; ++round) {
        patch.weights.clear();
        double sum = 0.0, mean = 0.0;
        for (const double distance : distances) {
            const double u = (distance - patch.gap) / (bisquare_cut * patch.point_sd);
            const double inside = std::max(0.0, 1.0 - u * u);
            patch.weights.push_back(inside * inside);
            sum += inside * inside;
            mean += inside * inside * distance;
        }
        for (double& weight : patch.weights)
            weight /= sum;
        patch.gap = mean / sum;
    }
}

}  // namespace

PatchPlace patch_place(double arc_length, double angle, const PatchOptions& options)
{
    const double positive = angle < 0.0 ? angle + turn : angle;
    return {static_cast<int>(std::floor(arc_length / options.length)),
            std::min(static_cast<int>(positive / turn * options.around), options.around - 1)};
}

double median_of(std::vector<double>& values)
{
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    if (values.size() % 2 == 1) return *middle;
    return 0.5 * (*middle + *std::max_element(values.begin(), middle));
}

DiscrepancyField make_discrepancy_field(const std::vector<Vec3>& points, const Imaging& imaging,
                                        const Simulation& base, const PatchOptions& options)
{
    DiscrepancyField field;
    field.options = options;
    field.num_points = static_cast<int>(points.size());
    std::map<std::pair<int, int>, Collected> collected;
    for (int i = 0; i < field.num_points; ++i) {
        SurfaceFoot foot = base.surface.nearest(in_vessel_frame(imaging, points[index(i)]));
        const bool is_far = std::abs(foot.distance) > options.farthest;
        foot.distance -= imaging.blooming;
        if (is_far) {
            ++field.num_far;
        } else if (foot.is_on_rim) {
            ++field.num_on_rim;
        } else {
            const auto [row, column] = patch_place(foot.arc_length, foot.angle, options);
            Collected& patch = collected[{row, column}];
            patch.points.push_back(i);
            patch.feet.push_back(foot);
        }
    }
    for (const auto& [place, content] : collected) {
        if (static_cast<int>(content.points.size()) < options.fewest_points) {
            field.num_in_sparse += static_cast<int>(content.points.size());
            continue;
        }
        field.patches.push_back(
            make_patch(place.first, place.second, content, base.deployment, options));
    }
    pool_scatter(field.patches);
    for (Patch& patch : field.patches) {
        std::vector<double> distances;
        for (const SurfaceFoot& foot : collected.at({patch.row, patch.column}).feet)
            distances.push_back(foot.distance);
        weigh_points(patch, distances);
    }
    return field;
}

Eigen::VectorXd patch_gaps(const std::vector<Vec3>& points, const DiscrepancyField& field,
                           const Imaging& imaging, const DeviceSurface& surface,
                           const DeviceSurface& base)
{
    Eigen::VectorXd gaps =
        Eigen::VectorXd::Constant(static_cast<Eigen::Index>(field.patches.size()), 0.0);
    for (std::size_t p = 0; p < field.patches.size(); ++p) {
        const Patch& patch = field.patches[p];
        for (std::size_t i = 0; i < patch.points.size(); ++i) {
            if (patch.weights[i] == 0.0) continue;
            const Vec3 point = in_vessel_frame(imaging, points[index(patch.points[i])]);
            gaps[static_cast<Eigen::Index>(p)] +=
                patch.weights[i] * (distance_from(surface, base, point) - imaging.blooming);
        }
    }
    return gaps;
}

}  // namespace braidzone
