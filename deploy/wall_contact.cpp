#include "deploy/wall_contact.hpp"

#include "deploy/deployment_measures.hpp"

#include <algorithm>

namespace braidzone {

namespace {

/// Where a ray grazes the wall, the offset along the normal would be a long way along the ray; it
/// is not drawn out beyond that of a wall at 11 degrees to the ray.
constexpr double smallest_incidence = 0.2;

}  // namespace

std::vector<double> wall_stops(const CrimpedBraid& braid, const WallTree& wall, double reach,
                               double offset)
{
    std::vector<double> stops;
    stops.reserve(braid.rays.size());
    for (int node = 0; node < braid.lattice.num_nodes(); ++node) {
        const Vec3 from = on_ray(braid, node, braid.radius);
        const std::optional<WallHit> hit = wall.first_hit(from, on_ray(braid, node, reach));
        if (!hit) {
            stops.push_back(reach);
            continue;
        }
        const double incidence = std::max(
            braid.rays[static_cast<std::size_t>(node)].dot(hit->normal), smallest_incidence);
        const double wall_radius = braid.radius + hit->fraction * (reach - braid.radius);
        stops.push_back(std::max(braid.radius, wall_radius - offset / incidence));
    }
    return stops;
}

std::vector<double> wall_stiffnesses(const CrimpedBraid& braid, const std::vector<double>& stops,
                                     double stiffness)
{
    std::vector<Vec3> nodes;
    nodes.reserve(stops.size());
    for (int node = 0; node < braid.lattice.num_nodes(); ++node) {
        nodes.push_back(
            on_ray(braid, node,
                   std::min(stops[static_cast<std::size_t>(node)], braid.lattice.nominal_radius)));
    }
    std::vector<double> stiffnesses = node_areas(braid.lattice, nodes);
    for (double& value : stiffnesses)
        value *= stiffness;
    return stiffnesses;
}

}  // namespace braidzone
