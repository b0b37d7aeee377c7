#include "deploy/neck.hpp"

#include "core/error.hpp"
#include "deploy/deployment_measures.hpp"
#include "deploy/node_patches.hpp"
#include "deploy/wall_profile.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace braidzone {

namespace {

/// How far it looks, over the device's nominal radius: beyond, all openings are alike.
constexpr double reach_ratio = 4.0;

std::size_t index(int i)
{
    return static_cast<std::size_t>(i);
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

/// For each node, 1 if the wall behind it lies outside the parent vessel.
std::vector<char> outside_nodes(const Deployment& deployment, const WallTree& wall,
                                const std::vector<WallProfile>& parents,
                                const std::vector<char>& open, double outside_ratio, double reach)
{
    const BraidLattice& lattice = deployment.lattice;
    std::vector<char> outside(deployment.nodes.size(), 0);
    for (int ring = 0; ring < lattice.num_rings; ++ring) {
        if (!open[index(ring)]) continue;
        const CrossSection& plane = deployment.rings[index(ring)];
        for (int column = 0; column < lattice.nodes_per_ring; ++column) {
            const int node = lattice.node(ring, column);
            const double angle = angle_about_hub(plane, deployment.nodes[index(node)]);
            const double parent = at_angle(parents[index(ring)], angle);
            outside[index(node)] = distance_to_wall(wall, plane.origin, direction_at(plane, angle),
                                                    reach) > outside_ratio * parent;
        }
    }
    return outside;
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
    std::vector<WallProfile> profiles;
    for (const CrossSection& ring : deployment.rings)
        profiles.push_back(wall_profile(wall, ring, reach));

    const std::vector<double> areas = node_areas(lattice, deployment.nodes);
    const std::vector<double>& places = deployment.ring_arc_length;
    const std::vector<char> open = open_sections(places, profiles, options.opening_ratio);
    std::vector<WallOpening> openings;
    std::vector<char> given(profiles.size(), 0);
    if (options.given) {
        given = rings_within(deployment, *options.given);
        const std::vector<char> outside =
            outside_nodes(deployment, wall, parent_profiles(places, profiles, given), given,
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
        outside_nodes(deployment, wall, parent_profiles(places, profiles, open), open,
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

const WallOpening* neck_of(const std::vector<WallOpening>& openings)
{
    return openings.empty() || openings.front().kind != OpeningKind::sac ? nullptr
                                                                         : &openings.front();
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
