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
    patch.median = median_of(distances);
    for (double& distance : distances)
        distance = std::abs(distance - patch.median);
    patch.point_sd = sd_of_mad * median_of(distances);
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
    return field;
}

Eigen::VectorXd patch_medians(const std::vector<Vec3>& points, const DiscrepancyField& field,
                              const Imaging& imaging, const DeviceSurface& surface,
                              const DeviceSurface& base)
{
    Eigen::VectorXd medians(static_cast<Eigen::Index>(field.patches.size()));
    std::vector<double> distances;
    for (std::size_t p = 0; p < field.patches.size(); ++p) {
        distances.clear();
        for (const int point : field.patches[p].points) {
            distances.push_back(
                distance_from(surface, base, in_vessel_frame(imaging, points[index(point)])) -
                imaging.blooming);
        }
        medians[static_cast<Eigen::Index>(p)] = median_of(distances);
    }
    return medians;
}

}  // namespace braidzone
