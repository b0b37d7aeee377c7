#include "deploy/neck.hpp"

#include "core/error.hpp"
#include "deploy/deployment_measures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace braidzone {

namespace {

/// Directions in which each ring looks for the wall.
constexpr int num_directions = 48;

/// How far it looks, over the device's nominal radius: beyond, all openings are alike.
constexpr double reach_ratio = 4.0;

std::size_t index(int i)
{
    return static_cast<std::size_t>(i);
}

/// Distances from the hub of a ring to the wall, one a direction [m].
using Profile = std::vector<double>;

double distance_to_wall(const WallTree& wall, const Vec3& hub, const Vec3& direction, double reach)
{
    const std::optional<WallHit> hit = wall.first_hit(hub, hub + reach * direction);
    return hit ? hit->fraction * reach : reach;
}

Profile wall_profile(const WallTree& wall, const CrossSection& ring, double reach)
{
    Profile profile;
    for (int i = 0; i < num_directions; ++i) {
        const double angle = 2.0 * std::numbers::pi * i / num_directions;
        profile.push_back(distance_to_wall(
            wall, ring.origin, std::cos(angle) * ring.normal + std::sin(angle) * ring.binormal,
            reach));
    }
    return profile;
}

double lower_quartile(Profile profile)
{
    const auto quartile = profile.begin() + num_directions / 4;
    std::nth_element(profile.begin(), quartile, profile.end());
    return *quartile;
}

/// The value of a profile in any direction, linear between two of its directions.
double at_angle(const Profile& profile, double angle)
{
    const double place = angle / (2.0 * std::numbers::pi) * num_directions;
    const double before = std::floor(place);
    const int first = (static_cast<int>(before) % num_directions + num_directions) % num_directions;
    const double share = place - before;
    return (1.0 - share) * profile[index(first)] +
           share * profile[index((first + 1) % num_directions)];
}

/// Rings within a stretch of the centerline.
std::vector<char> rings_within(const Deployment& deployment, const ArcRange& stretch)
{
    const std::vector<double>& places = deployment.ring_arc_length;
    std::vector<char> within;
    for (const double place : places)
        within.push_back(place >= stretch.from && place <= stretch.to);
    if (std::find(within.begin(), within.end(), 1) == within.end()) {
        throw GeometryError(fmt::format(
            "deployment.neck = {:.6g} to {:.6g} mm along the centerline holds no ring of the "
            "device, which lies from {:.6g} to {:.6g} mm",
            1e3 * stretch.from, 1e3 * stretch.to, 1e3 * places.back(), 1e3 * places.front()));
    }
    return within;
}

/// Rings that look into an opening, with those next to them.
std::vector<char> open_rings(const Deployment& deployment, const std::vector<Profile>& profiles,
                             double opening_ratio)
{
    const std::vector<double>& places = deployment.ring_arc_length;
    std::vector<char> open(profiles.size(), 0);
    for (std::size_t ring = 0; ring < profiles.size(); ++ring) {
        const double tube = lower_quartile(profiles[ring]);
        const double furthest = *std::max_element(profiles[ring].begin(), profiles[ring].end());
        if (!(furthest > opening_ratio * tube)) continue;
        for (std::size_t other = 0; other < profiles.size(); ++other) {
            if (std::abs(places[other] - places[ring]) <= tube) open[other] = 1;
        }
    }
    return open;
}

/// The parent vessel's wall as each ring would see it without the openings.
std::vector<Profile> parent_profiles(const Deployment& deployment,
                                     const std::vector<Profile>& profiles,
                                     const std::vector<char>& open)
{
    const int num_rings = static_cast<int>(profiles.size());
    std::vector<Profile> parents = profiles;
    for (int ring = 0; ring < num_rings; ++ring) {
        if (!open[index(ring)]) continue;
        int distal = ring, proximal = ring;
        while (distal >= 0 && open[index(distal)])
            --distal;
        while (proximal < num_rings && open[index(proximal)])
            ++proximal;
        Profile& parent = parents[index(ring)];
        if (distal < 0 && proximal == num_rings) {
            parent.assign(num_directions, lower_quartile(profiles[index(ring)]));
        } else if (distal < 0) {
            parent = profiles[index(proximal)];
        } else if (proximal == num_rings) {
            parent = profiles[index(distal)];
        } else {
            const std::vector<double>& places = deployment.ring_arc_length;
            const double share = (places[index(distal)] - places[index(ring)]) /
                                 (places[index(distal)] - places[index(proximal)]);
            for (int i = 0; i < num_directions; ++i) {
                parent[index(i)] = (1.0 - share) * profiles[index(distal)][index(i)] +
                                   share * profiles[index(proximal)][index(i)];
            }
        }
    }
    return parents;
}

/// For each node, 1 if the wall behind it lies outside the parent vessel.
std::vector<char> outside_nodes(const Deployment& deployment, const WallTree& wall,
                                const std::vector<Profile>& parents, const std::vector<char>& open,
                                double outside_ratio, double reach)
{
    const BraidLattice& lattice = deployment.lattice;
    std::vector<char> outside(deployment.nodes.size(), 0);
    for (int ring = 0; ring < lattice.num_rings; ++ring) {
        if (!open[index(ring)]) continue;
        const CrossSection& plane = deployment.rings[index(ring)];
        for (int column = 0; column < lattice.nodes_per_ring; ++column) {
            const int node = lattice.node(ring, column);
            const Vec3 from_hub = deployment.nodes[index(node)] - plane.origin;
            const double angle =
                std::atan2(from_hub.dot(plane.binormal), from_hub.dot(plane.normal));
            const Vec3 direction =
                std::cos(angle) * plane.normal + std::sin(angle) * plane.binormal;
            const double parent = at_angle(parents[index(ring)], angle);
            outside[index(node)] =
                distance_to_wall(wall, plane.origin, direction, reach) > outside_ratio * parent;
        }
    }
    return outside;
}

/// For each flagged node, the lowest node of its connected patch; -1 elsewhere. Nodes of one
/// rhombus are connected.
std::vector<int> connected_patches(const BraidLattice& lattice, const std::vector<char>& flagged)
{
    std::vector<int> parent(flagged.size());
    std::iota(parent.begin(), parent.end(), 0);
    const auto root = [&](int node) {
        while (parent[index(node)] != node)
            node = parent[index(node)];
        return node;
    };
    for (int ring = 0; ring + 2 < lattice.num_rings; ++ring) {
        for (int column = 0; column < lattice.nodes_per_ring; ++column) {
            int lowest = -1;
            for (const int corner : rhombus_corners(lattice, ring, column)) {
                if (!flagged[index(corner)]) continue;
                const int own = root(corner);
                if (lowest < 0) lowest = own;
                parent[index(std::max(own, lowest))] = std::min(own, lowest);
                lowest = std::min(own, lowest);
            }
        }
    }
    std::vector<int> patch(flagged.size(), -1);
    for (int node = 0; node < lattice.num_nodes(); ++node) {
        if (flagged[index(node)]) patch[index(node)] = root(node);
    }
    return patch;
}

WallOpening make_opening(const std::vector<double>& areas, std::vector<int> nodes)
{
    WallOpening opening;
    opening.nodes = std::move(nodes);
    for (const int node : opening.nodes)
        opening.area += areas[index(node)];
    return opening;
}

}  // namespace

std::vector<WallOpening> find_openings(const Deployment& deployment, const WallTree& wall,
                                       const NeckOptions& options)
{
    const BraidLattice& lattice = deployment.lattice;
    const double reach = reach_ratio * lattice.nominal_radius;
    std::vector<Profile> profiles;
    for (const CrossSection& ring : deployment.rings)
        profiles.push_back(wall_profile(wall, ring, reach));

    const std::vector<double> areas = node_areas(lattice, deployment.nodes);
    const std::vector<char> open = open_rings(deployment, profiles, options.opening_ratio);
    std::vector<WallOpening> openings;
    std::vector<char> given(profiles.size(), 0);
    if (options.given) {
        given = rings_within(deployment, *options.given);
        const std::vector<char> outside =
            outside_nodes(deployment, wall, parent_profiles(deployment, profiles, given), given,
                          options.outside_ratio, reach);
        std::vector<int> nodes;
        for (int node = 0; node < lattice.num_nodes(); ++node) {
            if (outside[index(node)]) nodes.push_back(node);
        }
        openings.push_back(make_opening(areas, std::move(nodes)));
        const auto first = std::find(given.begin(), given.end(), 1);
        openings.front().distal_ring = static_cast<int>(first - given.begin());
        openings.front().proximal_ring =
            static_cast<int>(std::find(first, given.end(), 0) - given.begin()) - 1;
    }

    std::vector<char> outside =
        outside_nodes(deployment, wall, parent_profiles(deployment, profiles, open), open,
                      options.outside_ratio, reach);
    for (int node = 0; node < lattice.num_nodes(); ++node) {
        if (given[index(node / lattice.nodes_per_ring)]) outside[index(node)] = 0;
    }
    const std::vector<int> patch = connected_patches(lattice, outside);
    std::vector<std::vector<int>> members(outside.size());
    for (int node = 0; node < lattice.num_nodes(); ++node) {
        if (patch[index(node)] >= 0) members[index(patch[index(node)])].push_back(node);
    }
    const std::size_t num_given = openings.size();
    for (std::vector<int>& nodes : members) {
        if (nodes.empty() || static_cast<int>(nodes.size()) < options.fewest_nodes) continue;
        const int distal = nodes.front() / lattice.nodes_per_ring;
        const int proximal = nodes.back() / lattice.nodes_per_ring;
        openings.push_back(make_opening(areas, std::move(nodes)));
        openings.back().distal_ring = distal;
        openings.back().proximal_ring = proximal;
    }
    std::stable_sort(openings.begin() + static_cast<std::ptrdiff_t>(num_given), openings.end(),
                     [](const WallOpening& a, const WallOpening& b) { return a.area > b.area; });
    return openings;
}

std::vector<char> nodes_of(const std::vector<WallOpening>& openings, int num_nodes)
{
    std::vector<char> flags(index(num_nodes), 0);
    for (const WallOpening& opening : openings) {
        for (const int node : opening.nodes)
            flags[index(node)] = 1;
    }
    return flags;
}

}  // namespace braidzone
