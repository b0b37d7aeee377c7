#include "deploy/deployment_measures.hpp"

#include "deploy/braid_kinematics.hpp"

#include <algorithm>
#include <numeric>

namespace braidzone {

namespace {

/// Vector area of a rhombus: half the cross product of its diagonals [m^2], outwards.
Vec3 rhombus_area(const BraidLattice& lattice, const std::vector<Vec3>& nodes, int ring, int column)
{
    const std::array<int, 4> corners = rhombus_corners(lattice, ring, column);
    const auto at = [&](int corner) -> const Vec3& {
        return nodes[static_cast<std::size_t>(corners[static_cast<std::size_t>(corner)])];
    };
    return 0.5 * (at(2) - at(0)).cross(at(3) - at(1));
}

/// The same for a lattice whose rings stand behind each other: a quarter of each quadrilateral
/// between two rings and two columns.
std::vector<double> aligned_node_areas(const BraidLattice& lattice, const std::vector<Vec3>& nodes)
{
    std::vector<double> areas(nodes.size(), 0.0);
    for (int ring = 0; ring + 1 < lattice.num_rings; ++ring) {
        for (int column = 0; column < lattice.nodes_per_ring; ++column) {
            const std::array<int, 4> corners = {
                lattice.node(ring, column), lattice.node(ring, column + 1),
                lattice.node(ring + 1, column + 1), lattice.node(ring + 1, column)};
            const auto at = [&](int i) -> const Vec3& {
                return nodes[static_cast<std::size_t>(corners[static_cast<std::size_t>(i)])];
            };
            const double quarter = 0.125 * (at(2) - at(0)).cross(at(3) - at(1)).norm();
            for (int corner : corners)
                areas[static_cast<std::size_t>(corner)] += quarter;
        }
    }
    return areas;
}

template <typename Function>
void for_each_rhombus(const BraidLattice& lattice, Function function)
{
    for (int ring = 0; ring + 2 < lattice.num_rings; ++ring) {
        for (int column = 0; column < lattice.nodes_per_ring; ++column)
            function(ring, column);
    }
}

std::size_t index(int i)
{
    return static_cast<std::size_t>(i);
}

double mean_over(const std::vector<double>& values, const std::vector<int>& nodes)
{
    double sum = 0.0;
    for (const int node : nodes)
        sum += values[index(node)];
    return sum / static_cast<double>(nodes.size());
}

/// Length of the centerline that a ring stands for [m]: half of the gaps on both sides.
double ring_length(const std::vector<double>& places, std::size_t ring)
{
    const std::size_t distal = ring == 0 ? 0 : ring - 1;
    const std::size_t proximal = std::min(ring + 1, places.size() - 1);
    return 0.5 * (places[distal] - places[proximal]);
}

/// Figures of the rings from `first` to `last`; none if there are none.
std::optional<ZoneMeasures> measure_zone(const Deployment& deployment,
                                         const std::vector<double>& areas, int first, int last)
{
    if (first > last) return std::nullopt;
    double area = 0.0, contact_area = 0.0, force = 0.0, length = 0.0;
    for (int ring = first; ring <= last; ++ring) {
        length += ring_length(deployment.ring_arc_length, index(ring));
        for (int column = 0; column < deployment.lattice.nodes_per_ring; ++column) {
            const std::size_t node = index(deployment.lattice.node(ring, column));
            area += areas[node];
            if (deployment.in_contact[node]) contact_area += areas[node];
            force += deployment.contact_force[node];
        }
    }
    return ZoneMeasures{contact_area / area, force / length};
}

/// Statistics over the malapposed nodes; none if there are none.
std::optional<GapMeasures> measure_gaps(const Deployment& deployment,
                                        const std::vector<double>& areas,
                                        const std::vector<int>& malapposed)
{
    if (malapposed.empty()) return std::nullopt;
    std::vector<int> by_gap = malapposed;
    std::stable_sort(by_gap.begin(), by_gap.end(), [&](int a, int b) {
        return deployment.wall_distance[index(a)] < deployment.wall_distance[index(b)];
    });
    double area = 0.0, moment = 0.0;
    for (const int node : by_gap) {
        area += areas[index(node)];
        moment += areas[index(node)] * deployment.wall_distance[index(node)];
    }
    GapMeasures gaps;
    gaps.mean = moment / area;
    gaps.max = deployment.wall_distance[index(by_gap.back())];
    double nearer = 0.0;
    for (const int node : by_gap) {
        nearer += areas[index(node)];
        gaps.percentile_95 = deployment.wall_distance[index(node)];
        if (nearer >= 0.95 * area) break;
    }
    return gaps;
}

/// The openings through which flow leaves the parent vessel.
std::vector<WallOpening> without_ends(std::vector<WallOpening> openings)
{
    std::erase_if(openings,
                  [](const WallOpening& opening) { return opening.kind == OpeningKind::end; });
    return openings;
}

/// Nodes beyond the wall where it stands: a compliant one gives way under them.
int count_outside(const Deployment& deployment, const WallTree& wall)
{
    int outside = 0;
    for (std::size_t i = 0; i < deployment.nodes.size(); ++i) {
        if (wall.contains(deployment.nodes[i])) continue;
        const double displacement =
            deployment.wall_displacement.empty() ? 0.0 : deployment.wall_displacement[i];
        if (!(wall.nearest(deployment.nodes[i]).distance <= displacement)) ++outside;
    }
    return outside;
}

}  // namespace

std::vector<double> node_areas(const BraidLattice& lattice, const std::vector<Vec3>& nodes)
{
    if (lattice.stagger == 0.0) return aligned_node_areas(lattice, nodes);
    std::vector<double> areas(nodes.size(), 0.0);
    for_each_rhombus(lattice, [&](int ring, int column) {
        const double quarter = 0.25 * rhombus_area(lattice, nodes, ring, column).norm();
        for (int corner : rhombus_corners(lattice, ring, column)) {
            areas[static_cast<std::size_t>(corner)] += quarter;
        }
    });
    return areas;
}

std::vector<double> radial_expansion(const Deployment& deployment)
{
    const int n = deployment.lattice.nodes_per_ring;
    std::vector<double> expansion;
    expansion.reserve(deployment.nodes.size());
    for (int ring = 0; ring < deployment.lattice.num_rings; ++ring) {
        const auto begin = deployment.nodes.begin() + ring * n;
        const Vec3 centre = std::accumulate(begin, begin + n, Vec3(Vec3::Zero())) / n;
        for (int column = 0; column < n; ++column) {
            expansion.push_back((*(begin + column) - centre).norm());
        }
    }
    return expansion;
}

std::vector<int> inverted_rhombi(const Deployment& deployment)
{
    const BraidLattice& lattice = deployment.lattice;
    std::vector<int> inverted;
    for_each_rhombus(lattice, [&](int ring, int column) {
        Vec3 centre = Vec3::Zero();
        for (int corner : rhombus_corners(lattice, ring, column)) {
            centre += 0.25 * deployment.nodes[static_cast<std::size_t>(corner)];
        }
        const CrossSection& middle = deployment.rings[static_cast<std::size_t>(ring + 1)];
        const Vec3 from_axis = centre - middle.origin;
        const Vec3 outward = from_axis - middle.tangent.dot(from_axis) * middle.tangent;
        if (!(rhombus_area(lattice, deployment.nodes, ring, column).dot(outward) > 0.0)) {
            inverted.push_back(ring * lattice.nodes_per_ring + column);
        }
    });
    return inverted;
}

DeploymentMeasures measure(const Deployment& deployment, const FlowDiverter& device,
                           const WallTree& wall, double wall_gap,
                           const std::vector<WallOpening>& openings)
{
    const BraidLattice& lattice = deployment.lattice;
    const std::vector<double>& places = deployment.ring_arc_length;
    const std::vector<double> areas = node_areas(lattice, deployment.nodes);
    const std::vector<double> expansion = radial_expansion(deployment);

    DeploymentMeasures measures;
    measures.implanted_length = places.front() - places.back();
    measures.resting_length = lattice.ring_spacing * (lattice.num_rings - 1);
    const double length_in_catheter =
        measures.resting_length *
        length_ratio(device.braid_ratio, device.catheter_diameter / device.nominal_diameter);
    measures.foreshortening = 1.0 - measures.implanted_length / length_in_catheter;
    measures.foreshortening_label = 1.0 - measures.implanted_length / device.nominal_length;
    measures.mean_radial_expansion = std::accumulate(expansion.begin(), expansion.end(), 0.0) /
                                     static_cast<double>(expansion.size());

    const std::vector<char> over_opening = nodes_of(without_ends(openings), lattice.num_nodes());
    std::vector<int> malapposed;
    double contact_force = 0.0, contact_area = 0.0, reference_area = 0.0;
    for (int node = 0; node < lattice.num_nodes(); ++node) {
        const std::size_t i = index(node);
        measures.device_area += areas[i];
        if (!deployment.in_contact[i]) {
            if (over_opening[i] || !(deployment.wall_distance[i] > wall_gap)) continue;
            measures.malapposed_area += areas[i];
            malapposed.push_back(node);
            continue;
        }
        contact_area += areas[i];
        reference_area += lattice.area_share(node / lattice.nodes_per_ring) * lattice.node_area();
        contact_force += deployment.contact_force[i];
        measures.max_contact_pressure =
            std::max(measures.max_contact_pressure, deployment.contact_pressure[i]);
    }
    measures.contact_area_fraction = contact_area / measures.device_area;
    if (contact_area > 0.0) {
        measures.mean_contact_pressure = contact_force / contact_area;
        measures.mean_contact_pressure_reference = contact_force / reference_area;
    }
    measures.radial_force_per_length = contact_force / measures.implanted_length;
    measures.malapposition_gap = measure_gaps(deployment, areas, malapposed);

    if (const WallOpening* found = neck_of(openings)) {
        const WallOpening& neck = *found;
        if (!neck.nodes.empty()) {
            measures.mean_radial_expansion_neck = mean_over(expansion, neck.nodes);
        }
        measures.neck_area = neck.area;
        measures.neck_range = {places[index(neck.proximal_ring)], places[index(neck.distal_ring)]};
        measures.distal_landing = measure_zone(deployment, areas, 0, neck.distal_ring - 1);
        measures.neck = measure_zone(deployment, areas, neck.distal_ring, neck.proximal_ring);
        measures.proximal_landing =
            measure_zone(deployment, areas, neck.proximal_ring + 1, lattice.num_rings - 1);
    }
    measures.inverted_rhombi = static_cast<int>(inverted_rhombi(deployment).size());
    measures.nodes_outside_vessel = count_outside(deployment, wall);
    return measures;
}

}  // namespace braidzone
