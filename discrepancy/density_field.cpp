#include "discrepancy/density_field.hpp"

#include "core/error.hpp"
#include "core/place_text.hpp"
#include "porous/braid_surface.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace braidzone {
namespace {

/// A picture's frame fits the vessel's to better than this, and so does a place's depth [m].
constexpr double farthest_place = 2e-3;
/// Where the kernel ends, in its standard deviations.
constexpr double kernel_reach = 3.0;

/// A quantity of a rhombus.
double density_of(const BraidSurface& surface, std::size_t rhombus, const DensityField& field)
{
    const Rhombus& cell = surface.rhombi[rhombus];
    switch (field.quantity) {
        case DensityQuantity::pore_density:
            return cell.pore_density;
        case DensityQuantity::metal_coverage:
            return cell.metal_coverage;
        case DensityQuantity::surface_density_increase:
            return field.force_free_area * cell.pore_density - 1.0;
    }
    return 0.0;
}

/// Mean about a foot, by area and kernel. The kernel is lowered to 0 at its reach.
double mean_about(const BraidSurface& surface, const DensityField& field, const Vec3& foot,
                  double window)
{
    const double cell = std::sqrt(surface.rhombi[surface.rhombi.size() / 2].area);
    const double width = std::max(window / std::sqrt(12.0), cell);
    const double lowest = std::exp(-0.5 * kernel_reach * kernel_reach);
    double sum = 0.0, weights = 0.0;
    for (std::size_t i = 0; i < surface.rhombi.size(); ++i) {
        const double square = (surface.centres[i] - foot).squaredNorm() / (width * width);
        if (square >= kernel_reach * kernel_reach) continue;
        const double weight = surface.rhombi[i].area * (std::exp(-0.5 * square) - lowest);
        sum += weight * density_of(surface, i, field);
        weights += weight;
    }
    return sum / weights;
}

double force_free_area_of(const BraidSurface& surface)
{
    return surface.rhombi.front().area * (surface.density_increase.front() + 1.0);
}

InputError far_place(const DensityPlace& place, const Vec3& point, double distance, double allowed)
{
    return InputError(fmt::format(
        "density map, line {}: the place {} lies {:.4g} mm from the simulated device; it must be "
        "in the frame of the measured surface, within {:.3g} mm of the device",
        place.line, place_text(point), 1e3 * distance, 1e3 * allowed));
}

}  // namespace

DensityField make_density_field(const DensityMap& map, const Imaging& imaging,
                                const Simulation& base)
{
    DensityField field;
    field.quantity = map.quantity;
    if (map.places.empty()) return field;
    field.force_free_area = force_free_area_of(make_braid_surface(base.deployment, base.device));
    // A real device may be longer than the simulated one, but not twice as long.
    const double device_length = distal_end(base.deployment) - proximal_end(base.deployment);
    for (const DensityPlace& place : map.places) {
        const Vec3 point = in_vessel_frame(imaging, place.point);
        const SurfaceFoot foot = base.surface.nearest(point);
        const double distance =
            foot.is_on_rim ? (point - foot.point).norm() : std::abs(foot.distance);
        const double allowed = foot.is_on_rim ? device_length : farthest_place;
        if (distance > allowed) throw far_place(place, point, distance, allowed);
        if (foot.is_on_rim) {
            ++field.num_beyond_ends;
            continue;
        }
        field.places.push_back(place);
        field.feet.push_back(foot.point);
    }
    if (field.places.empty()) {
        throw InputError(fmt::format(
            "none of the {} places of the density map lies over the simulated device, which "
            "reaches from {:.4g} to {:.4g} mm along the centerline; their frame must be that of "
            "the measured surface",
            map.places.size(), 1e3 * proximal_end(base.deployment),
            1e3 * distal_end(base.deployment)));
    }
    field.scale = simulated_density(field, imaging, base);
    if (field.quantity == DensityQuantity::surface_density_increase) field.scale.array() += 1.0;
    return field;
}

Eigen::VectorXd simulated_density(const DensityField& field, const Imaging& imaging,
                                  const Simulation& simulation)
{
    Eigen::VectorXd density(static_cast<Eigen::Index>(field.places.size()));
    if (field.places.empty()) return density;
    const BraidSurface surface = make_braid_surface(simulation.deployment, simulation.device);
    for (Eigen::Index i = 0; i < density.size(); ++i) {
        const DensityPlace& place = field.places[static_cast<std::size_t>(i)];
        const SurfaceFoot foot = simulation.surface.nearest(in_vessel_frame(imaging, place.point));
        density[i] = mean_about(surface, field, foot.point, place.window);
    }
    return density;
}

}  // namespace braidzone
