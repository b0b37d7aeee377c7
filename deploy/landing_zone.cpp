#include "deploy/landing_zone.hpp"

#include "core/error.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace braidzone {

namespace {

/// Largest nominal over mean vessel diameter. Labels allow a few tenths of a millimetre; at twice
/// the diameter a 4 mm device would have to lengthen 2.4 times to lie free of force.
constexpr double largest_oversize = 2.0;

}  // namespace

void require_device_on_centerline(const Centerline& centerline,
                                  const std::vector<double>& positions)
{
    const double proximal = positions.back(), distal = positions.front();
    if (!(proximal >= 0.0 && distal <= centerline.length())) {
        throw GeometryError(fmt::format(
            "the device would lie from {:.6g} to {:.6g} mm along the centerline, which runs from 0 "
            "to {:.6g} mm: move deployment.landing_distal, or take a shorter device",
            1e3 * proximal, 1e3 * distal, 1e3 * centerline.length()));
    }
}

void require_room_for_catheter(const CrimpedBraid& braid, const std::vector<double>& positions,
                               const WallTree& wall)
{
    for (std::size_t ring = 0; ring < braid.rings.size(); ++ring) {
        const Vec3& hub = braid.rings[ring].origin;
        const bool is_inside = wall.contains(hub);
        if (!is_inside || wall.comes_nearer(hub, braid.radius)) {
            const double room = is_inside ? wall.nearest(hub).distance : 0.0;
            throw GeometryError(fmt::format(
                "at {:.6g} mm along the centerline the wall is {:.6g} mm away; the catheter of "
                "{:.6g} mm diameter does not pass",
                1e3 * positions[ring], 1e3 * room, 2e3 * braid.radius));
        }
    }
}

void require_fitting_diameter(const FlowDiverter& device, const std::vector<CrossSection>& rings)
{
    double smallest = rings.front().inscribed_radius, sum = 0.0;
    for (const CrossSection& ring : rings) {
        smallest = std::min(smallest, ring.inscribed_radius);
        sum += ring.inscribed_radius;
    }
    const double mean = sum / static_cast<double>(rings.size());
    if (!(device.nominal_radius() > smallest)) {
        throw GeometryError(fmt::format(
            "device.diameter = {:.6g} mm is too small: the vessel is at least {:.6g} mm wide all "
            "along the device, so that nothing would hold it",
            1e3 * device.nominal_diameter, 2e3 * smallest));
    }
    if (!(device.nominal_radius() < largest_oversize * mean)) {
        throw GeometryError(fmt::format(
            "device.diameter = {:.6g} mm is too large: the vessel is {:.6g} mm wide on average "
            "along the device; allowed are {} times that",
            1e3 * device.nominal_diameter, 2e3 * mean, largest_oversize));
    }
}

}  // namespace braidzone
