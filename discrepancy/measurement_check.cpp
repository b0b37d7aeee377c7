#include "discrepancy/measurement_check.hpp"

#include "core/error.hpp"
#include "core/place_text.hpp"
#include "core/triangle_mesh.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace braidzone {
namespace {

constexpr std::size_t fewest_points = 50;
constexpr double smallest_share = 0.5;
/// Less than the radius of a device: points collapsed onto the axis are not near it [m].
constexpr double near_device = 1.5e-3;
/// Size of the measured points over that of the simulated device.
constexpr double smallest_size = 0.2, largest_size = 3.0;
/// Points on a device that lies in the vessel, on its wall or across a neck [m].
constexpr double near_wall = 1.5e-3;
/// A few hundred points tell where the rest is.
constexpr std::size_t num_samples = 400;

std::vector<Vec3> sampled(const std::vector<Vec3>& points, const Imaging& imaging)
{
    const std::size_t stride = std::max<std::size_t>(1, points.size() / num_samples);
    std::vector<Vec3> few;
    for (std::size_t i = 0; i < points.size(); i += stride)
        few.push_back(in_vessel_frame(imaging, points[i]));
    return few;
}

template <typename IsNear>
double share(const std::vector<Vec3>& points, const IsNear& is_near)
{
    const auto count = std::count_if(points.begin(), points.end(), is_near);
    return static_cast<double>(count) / static_cast<double>(points.size());
}

double size_of(const std::vector<Vec3>& points)
{
    const Box box = bounding_box({points, {}});
    return (box.upper - box.lower).norm();
}

/// Share of the points, multiplied by a factor, that lie near the device; 0 if they are far smaller
/// or larger than it.
double share_near_device(const std::vector<Vec3>& points, double factor,
                         const Simulation& simulation)
{
    const double size = factor * size_of(points) / size_of(simulation.deployment.nodes);
    if (!(size > smallest_size && size < largest_size)) return 0.0;
    return share(points, [&](const Vec3& p) {
        return std::abs(simulation.surface.nearest(factor * p).distance) < near_device;
    });
}

/// The factor on the coordinates with which they fit; 1 if none does.
double fitting_factor(const std::vector<Vec3>& points, const Simulation& simulation)
{
    for (const double factor : {1e3, 10.0, 0.1, 1e-3, 100.0, 1e4, 1e-2, 1e-4, 1e6, 1e-6}) {
        if (share_near_device(points, factor, simulation) >= smallest_share) return factor;
    }
    return 1.0;
}

}  // namespace

void require_comparable(const std::vector<Vec3>& points, const Imaging& imaging,
                        const Simulation& simulation, const Lumen& lumen)
{
    if (points.size() < fewest_points) {
        throw InputError(fmt::format("the measured surface has {} points; at least {} are needed",
                                     points.size(), fewest_points));
    }
    const std::vector<Vec3> few = sampled(points, imaging);
    const double near = share_near_device(few, 1.0, simulation);
    if (near >= smallest_share) return;

    const double factor = fitting_factor(few, simulation);
    if (factor != 1.0) {
        throw InputError(fmt::format(
            "{:.0f} % of the measured points lie within {:.3g} mm of the simulated device; with "
            "coordinates {:.6g} times as large most of them would: the length unit is wrong",
            100.0 * near, 1e3 * near_device, factor));
    }
    Vec3 middle = Vec3::Zero();
    for (const Vec3& p : few)
        middle += p / static_cast<double>(few.size());
    if (size_of(few) < smallest_size * size_of(simulation.deployment.nodes)) {
        throw InputError(fmt::format(
            "the measured surface is {:.4g} mm large about {}, less than {:.0f} % of the simulated "
            "device's {:.4g} mm, and no length unit makes it fit",
            1e3 * size_of(few), place_text(middle), 100.0 * smallest_size,
            1e3 * size_of(simulation.deployment.nodes)));
    }
    const double along_wall =
        share(few, [&](const Vec3& p) { return lumen.wall.nearest(p).distance < near_wall; });
    if (along_wall >= smallest_share) {
        double from = lumen.centerline.length(), to = 0.0;
        for (const Vec3& p : few) {
            const double s = nearest_arc_length(lumen.centerline, p);
            from = std::min(from, s);
            to = std::max(to, s);
        }
        throw InputError(
            fmt::format("the measured surface lies from {:.4g} to {:.4g} mm along the centerline, "
                        "the simulated "
                        "device from {:.4g} to {:.4g} mm; {:.0f} % of the points lie within {:.3g} "
                        "mm of it, at "
                        "least half must",
                        1e3 * from, 1e3 * to, 1e3 * proximal_end(simulation.deployment),
                        1e3 * distal_end(simulation.deployment), 100.0 * near, 1e3 * near_device));
    }
    throw InputError(fmt::format(
        "the measured surface lies about {}, {:.4g} mm from the vessel's wall; it must be in the "
        "vessel's frame up to a millimetre or two: register it first",
        place_text(middle), 1e3 * lumen.wall.nearest(middle).distance));
}

void require_force_on_device(const MeasuredScalars& scalars, const Deployment& deployment)
{
    const auto& force = scalars.contact_force;
    if (!force) return;
    const double from = proximal_end(deployment), to = distal_end(deployment);
    if (force->from < to && force->to > from) return;
    throw InputError(fmt::format(
        "the measured contact force acts from {:.4g} to {:.4g} mm along the centerline, the "
        "simulated device lies from {:.4g} to {:.4g} mm: the stretches must overlap",
        1e3 * force->from, 1e3 * force->to, 1e3 * from, 1e3 * to));
}

}  // namespace braidzone
