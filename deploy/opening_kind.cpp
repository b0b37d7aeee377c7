#include "deploy/opening_kind.hpp"

#include "deploy/deployment_measures.hpp"
#include "deploy/lumen_tube.hpp"
#include "deploy/node_patches.hpp"
#include "deploy/wall_regions.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <map>
#include <optional>
#include <set>

namespace braidzone {

namespace {

/// As in `find_openings`.
constexpr double reach_ratio = 4.0;
constexpr double outside_ratio = NeckOptions{}.outside_ratio;

/// What a node looks into; regions of the wall count from 0.
constexpr int nothing_outside = WallRegions::none;  ///< the parent vessel's wall
constexpr int through_vessel = -2;                  ///< the vessel's own inlet or outlet

std::size_t index(int i)
{
    return static_cast<std::size_t>(i);
}

int opening_nearest(const Vessel& vessel, const Vec3& point)
{
    const auto nearer = [&](const Opening& first, const Opening& second) {
        return (first.centre - point).squaredNorm() < (second.centre - point).squaredNorm();
    };
    return static_cast<int>(
        std::min_element(vessel.openings.begin(), vessel.openings.end(), nearer) -
        vessel.openings.begin());
}

/// All that says what lies behind a node.
class Surroundings {
public:
    Surroundings(const VesselAround& around, double reach)
        : vessel_(around.vessel),
          wall_(around.wall),
          ends_{opening_nearest(vessel_, around.centerline.sections.front().origin),
                opening_nearest(vessel_, around.centerline.sections.back().origin)},
          parent_(tube_along(wall_, around.centerline, reach)),
          reach_(reach),
          regions_(wall_regions(vessel_, parent_, ends_))
    {
        const Box box = bounding_box(vessel_.wall);
        across_ = (box.upper - box.lower).norm();
    }

    /// Parts sacs from the branches that openings of a device look into.
    void part_sacs_behind(const std::vector<WallOpening>& openings, const Deployment& deployment)
    {
        std::set<int> with_branches;
        for (const WallOpening& opening : openings) {
            for (const int node : opening.nodes) {
                const int region =
                    behind(deployment.rings[index(node / deployment.lattice.nodes_per_ring)],
                           deployment.nodes[index(node)]);
                if (!branches_of(region).empty()) with_branches.insert(region);
            }
        }
        for (const int region : with_branches)
            part_sacs_from_branches(regions_, region, vessel_, wall_, parent_, reach_);
    }

    /// The region behind a node of a ring, `nothing_outside` or `through_vessel`.
    int behind(const CrossSection& ring, const Vec3& node) const
    {
        const Vec3 direction = direction_at(ring, angle_about_hub(ring, node));
        const auto hit = wall_.first_hit(ring.origin, ring.origin + across_ * direction);
        if (hit) return regions_.of_triangle[index(hit->triangle)];
        const int opening = opening_on_ray(ring.origin, direction);
        if (opening < 0) return nothing_outside;
        if (is_at_end(opening)) return through_vessel;
        for (std::size_t region = 0; region < regions_.branches.size(); ++region) {
            const std::vector<int>& reached = regions_.branches[region];
            if (std::find(reached.begin(), reached.end(), opening) != reached.end())
                return static_cast<int>(region);
        }
        return nothing_outside;
    }

    /// Openings of the vessel that a region reaches, without the parent vessel's own.
    std::vector<int> branches_of(int region) const
    {
        if (region < 0) return {};
        return regions_.branches[index(region)];
    }

private:
    bool is_at_end(int opening) const
    {
        return std::find(ends_.begin(), ends_.end(), opening) != ends_.end();
    }

    /// The opening through whose plane a ray passes nearest to its centre, by the opening's radius.
    int opening_on_ray(const Vec3& from, const Vec3& direction) const
    {
        int found = -1;
        double least = std::numeric_limits<double>::infinity();
        for (std::size_t i = 0; i < vessel_.openings.size(); ++i) {
            const Opening& opening = vessel_.openings[i];
            const double along = direction.dot(opening.normal);
            if (!(along > 0.0)) continue;
            const double way = (opening.centre - from).dot(opening.normal) / along;
            const double off = (from + way * direction - opening.centre).norm() / opening.radius;
            if (!(way > 0.0) || !(off < least)) continue;
            least = off;
            found = static_cast<int>(i);
        }
        return found;
    }

    const Vessel& vessel_;
    const WallTree& wall_;
    std::array<int, 2> ends_;
    LumenTube parent_;
    double reach_;
    WallRegions regions_;
    double across_ = 0.0;
};

/// An opening of the given nodes, in order.
WallOpening opening_of(const Deployment& deployment, const std::vector<double>& areas,
                       std::vector<int> nodes)
{
    std::sort(nodes.begin(), nodes.end());
    WallOpening opening;
    opening.distal_ring = nodes.front() / deployment.lattice.nodes_per_ring;
    opening.proximal_ring = nodes.back() / deployment.lattice.nodes_per_ring;
    for (const int node : nodes)
        opening.area += areas[index(node)];
    opening.nodes = std::move(nodes);
    return opening;
}

/// The nodes of an opening by the region behind them; those of a few nodes count with the most.
std::map<int, std::vector<int>> by_region(const WallOpening& opening, const Deployment& deployment,
                                          const Surroundings& surroundings)
{
    std::map<int, std::vector<int>> groups;
    for (const int node : opening.nodes) {
        const CrossSection& ring =
            deployment.rings[index(node / deployment.lattice.nodes_per_ring)];
        groups[surroundings.behind(ring, deployment.nodes[index(node)])].push_back(node);
    }
    // Nodes that see the parent's wall at the rim of a mouth belong to it.
    const auto most =
        std::max_element(groups.begin(), groups.end(), [](const auto& first, const auto& second) {
            if ((first.first == nothing_outside) != (second.first == nothing_outside))
                return first.first == nothing_outside;
            return first.second.size() < second.second.size();
        });
    const int main = most->first;
    std::vector<int> rest;
    std::erase_if(groups, [&](const auto& group) {
        const bool is_own = group.first != nothing_outside &&
                            static_cast<int>(group.second.size()) >= NeckOptions{}.fewest_nodes;
        if (group.first == main || is_own) return false;
        rest.insert(rest.end(), group.second.begin(), group.second.end());
        return true;
    });
    std::vector<int>& largest = groups[main];
    largest.insert(largest.end(), rest.begin(), rest.end());
    return groups;
}

bool takes_an_end(const WallOpening& opening, const BraidLattice& lattice)
{
    const OpeningEnds ends = ends_of(opening, lattice);
    return ends.distal || ends.proximal;
}

/// The parts of the openings, told apart; one for each kind and region.
std::vector<WallOpening> parts_of(const std::vector<WallOpening>& openings,
                                  const Deployment& deployment, const std::vector<double>& areas,
                                  const Surroundings& surroundings)
{
    std::map<std::pair<OpeningKind, int>, std::vector<int>> members;
    int unknown = std::numeric_limits<int>::min();
    for (const WallOpening& opening : openings) {
        for (const auto& [region, nodes] : by_region(opening, deployment, surroundings)) {
            if (region == nothing_outside) continue;
            const WallOpening part = opening_of(deployment, areas, nodes);
            OpeningKind kind = OpeningKind::sac;
            if (!surroundings.branches_of(region).empty()) {
                kind = OpeningKind::branch;
            } else if (region == through_vessel || takes_an_end(part, deployment.lattice)) {
                kind = OpeningKind::end;
            }
            // What is behind no region of its own is not joined with anything.
            const int key = region >= 0 ? region : unknown++;
            std::vector<int>& all = members[{kind, key}];
            all.insert(all.end(), nodes.begin(), nodes.end());
        }
    }
    std::vector<WallOpening> parts;
    for (const auto& [key, nodes] : members) {
        parts.push_back(opening_of(deployment, areas, nodes));
        parts.back().kind = key.first;
        parts.back().vessel_openings = surroundings.branches_of(key.second);
        parts.back().in_sac = key.first == OpeningKind::end && key.second >= 0;
    }
    return parts;
}

/// For each node, 1 if the wall behind it is further off than `outside_ratio` times the node.
std::vector<char> free_nodes(const Deployment& deployment, const WallTree& wall, double reach)
{
    const BraidLattice& lattice = deployment.lattice;
    std::vector<char> free(deployment.nodes.size(), 0);
    for (int node = 0; node < lattice.num_nodes(); ++node) {
        const CrossSection& ring = deployment.rings[index(node / lattice.nodes_per_ring)];
        const Vec3& point = deployment.nodes[index(node)];
        const double distance = (point - ring.origin).norm();
        const Vec3 direction = (point - ring.origin) / distance;
        free[index(node)] =
            distance_to_wall(wall, ring.origin, direction, reach) > outside_ratio * distance;
    }
    return free;
}

/// The largest share of a ring that nodes take of the rings for which `counts` holds.
template <typename Condition>
double largest_share(const std::vector<int>& nodes, const std::vector<char>& also,
                     const BraidLattice& lattice, Condition counts)
{
    std::vector<int> in_ring(index(lattice.num_rings), 0);
    for (const int node : nodes)
        ++in_ring[index(node / lattice.nodes_per_ring)];
    int most = 0;
    for (int ring = 0; ring < lattice.num_rings; ++ring) {
        if (in_ring[index(ring)] == 0 || !counts(ring)) continue;
        int total = in_ring[index(ring)];
        for (int column = 0; column < lattice.nodes_per_ring; ++column)
            total += also[index(lattice.node(ring, column))];
        most = std::max(most, total);
    }
    return static_cast<double>(most) / lattice.nodes_per_ring;
}

/// Parts of the device that are free of the wall all round, or at an end.
std::vector<WallOpening> free_parts(const std::vector<WallOpening>& known,
                                    const Deployment& deployment, const std::vector<double>& areas,
                                    const WallTree& wall, double reach)
{
    const BraidLattice& lattice = deployment.lattice;
    const std::vector<char> taken = nodes_of(known, lattice.num_nodes());
    std::vector<char> free = free_nodes(deployment, wall, reach);
    for (std::size_t node = 0; node < free.size(); ++node)
        free[node] = free[node] && !taken[node];
    const std::vector<int> patch = connected_patches(lattice, free);
    std::map<int, std::vector<int>> patches;
    for (int node = 0; node < lattice.num_nodes(); ++node) {
        if (patch[index(node)] >= 0) patches[patch[index(node)]].push_back(node);
    }
    const int last = lattice.num_rings - 1;
    std::vector<WallOpening> parts;
    for (const auto& [root, nodes] : patches) {
        WallOpening part = opening_of(deployment, areas, nodes);
        const double of_end = largest_share(nodes, std::vector<char>(free.size(), 0), lattice,
                                            [&](int ring) { return ring == 0 || ring == last; });
        const double of_ring = largest_share(nodes, taken, lattice, [](int) { return true; });
        if (of_end >= 0.25) {
            part.kind = OpeningKind::end;
        } else if (takes_an_end(part, lattice) || !(of_ring >= 1.0)) {
            continue;
        }
        parts.push_back(std::move(part));
    }
    return parts;
}

/// Joins the ends at one end of the device: both are one place where it is off the wall.
std::vector<WallOpening> with_joined_ends(std::vector<WallOpening> openings,
                                          const Deployment& deployment,
                                          const std::vector<double>& areas)
{
    std::vector<WallOpening> joined;
    for (WallOpening& opening : openings) {
        const auto at_same_end = [&](const WallOpening& other) {
            const OpeningEnds own = ends_of(opening, deployment.lattice);
            const OpeningEnds others = ends_of(other, deployment.lattice);
            return other.kind == OpeningKind::end && opening.kind == OpeningKind::end &&
                   ((own.distal && others.distal) || (own.proximal && others.proximal));
        };
        const auto other = std::find_if(joined.begin(), joined.end(), at_same_end);
        if (other == joined.end()) {
            joined.push_back(std::move(opening));
            continue;
        }
        std::vector<int> nodes = other->nodes;
        nodes.insert(nodes.end(), opening.nodes.begin(), opening.nodes.end());
        const bool in_sac = other->in_sac || opening.in_sac;
        *other = opening_of(deployment, areas, std::move(nodes));
        other->kind = OpeningKind::end;
        other->in_sac = in_sac;
    }
    return joined;
}

}  // namespace

std::string_view name_of(OpeningKind kind)
{
    switch (kind) {
        case OpeningKind::sac:
            return "sac";
        case OpeningKind::branch:
            return "branch";
        case OpeningKind::end:
            return "end";
    }
    return "";
}

OpeningEnds ends_of(const WallOpening& opening, const BraidLattice& lattice)
{
    if (opening.nodes.empty()) return {};
    return {opening.nodes.front() < lattice.nodes_per_ring,
            opening.nodes.back() >= lattice.node(lattice.num_rings - 1, 0)};
}

Vec3 middle_of(const WallOpening& opening, const Deployment& deployment)
{
    if (opening.nodes.empty())
        return deployment.rings[index((opening.distal_ring + opening.proximal_ring) / 2)].origin;
    Vec3 sum = Vec3::Zero();
    for (const int node : opening.nodes)
        sum += deployment.nodes[index(node)];
    return sum / static_cast<double>(opening.nodes.size());
}

std::vector<WallOpening> told_apart(const std::vector<WallOpening>& openings,
                                    const Deployment& deployment, const VesselAround& around,
                                    bool neck_given)
{
    const double reach = reach_ratio * deployment.lattice.nominal_radius;
    const std::vector<double> areas = node_areas(deployment.lattice, deployment.nodes);
    const auto first_found = openings.begin() + (neck_given ? 1 : 0);
    const std::vector<WallOpening> found(first_found, openings.end());
    std::vector<WallOpening> parts;
    if (!found.empty()) {
        Surroundings surroundings(around, reach);
        surroundings.part_sacs_behind(found, deployment);
        parts = parts_of(found, deployment, areas, surroundings);
    }

    std::vector<WallOpening> known(openings.begin(), first_found);
    known.insert(known.end(), parts.begin(), parts.end());
    for (WallOpening& part : free_parts(known, deployment, areas, around.wall, reach))
        parts.push_back(std::move(part));
    parts = with_joined_ends(std::move(parts), deployment, areas);
    std::stable_sort(parts.begin(), parts.end(), [](const WallOpening& a, const WallOpening& b) {
        return a.kind != b.kind ? a.kind < b.kind : a.area > b.area;
    });
    parts.insert(parts.begin(), openings.begin(), first_found);
    return parts;
}

}  // namespace braidzone
