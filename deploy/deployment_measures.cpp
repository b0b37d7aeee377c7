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

template <typename Function>
void for_each_rhombus(const BraidLattice& lattice, Function function)
{
    for (int ring = 0; ring + 2 < lattice.num_rings; ++ring) {
        for (int column = 0; column < lattice.nodes_per_ring; ++column)
            function(ring, column);
    }
}

/// Mean of the values whose flag is set; none if there are none.
std::optional<double> mean_where(const std::vector<double>& values, const std::vector<char>& flags)
{
    double sum = 0.0;
    std::size_t count = 0;
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (!flags[i]) continue;
        sum += values[i];
        ++count;
    }
    if (count == 0) return std::nullopt;
    return sum / static_cast<double>(count);
}

}  // namespace

std::vector<double> node_areas(const BraidLattice& lattice, const std::vector<Vec3>& nodes)
{
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

std::vector<char> is_free_of_wall(const Deployment& deployment, double neck_gap)
{
    std::vector<char> free(deployment.nodes.size());
    for (std::size_t i = 0; i < free.size(); ++i) {
        free[i] = !deployment.in_contact[i] && deployment.wall_distance[i] > neck_gap;
    }
    return free;
}

DeploymentMeasures measure(const Deployment& deployment, const FlowDiverter& device,
                           const WallTree& wall, double neck_gap)
{
    const BraidLattice& lattice = deployment.lattice;
    const std::vector<double> areas = node_areas(lattice, deployment.nodes);
    const std::vector<double> expansion = radial_expansion(deployment);
    const std::vector<char> free = is_free_of_wall(deployment, neck_gap);

    DeploymentMeasures measures;
    measures.implanted_length =
        deployment.ring_arc_length.front() - deployment.ring_arc_length.back();
    measures.resting_length = lattice.ring_spacing * (lattice.num_rings - 1);
    const double length_in_catheter =
        measures.resting_length *
        length_ratio(device.braid_ratio, device.catheter_diameter / device.nominal_diameter);
    measures.foreshortening = 1.0 - measures.implanted_length / length_in_catheter;
    measures.mean_radial_expansion =
        mean_where(expansion, std::vector<char>(expansion.size(), 1)).value();
    measures.mean_radial_expansion_neck = mean_where(expansion, free);

    double contact_force = 0.0, contact_area = 0.0;
    for (std::size_t i = 0; i < areas.size(); ++i) {
        measures.device_area += areas[i];
        if (free[i]) measures.malapposed_area += areas[i];
        if (!deployment.in_contact[i]) continue;
        contact_area += areas[i];
        contact_force += deployment.contact_force[i];
        measures.max_contact_pressure =
            std::max(measures.max_contact_pressure, deployment.contact_pressure[i]);
    }
    measures.contact_area_fraction = contact_area / measures.device_area;
    if (contact_area > 0.0) measures.mean_contact_pressure = contact_force / contact_area;
    measures.radial_force_per_length = contact_force / measures.implanted_length;
    measures.inverted_rhombi = static_cast<int>(inverted_rhombi(deployment).size());
    measures.nodes_outside_vessel =
        static_cast<int>(std::count_if(deployment.nodes.begin(), deployment.nodes.end(),
                                       [&](const Vec3& node) { return !wall.contains(node); }));
    return measures;
}

}  // namespace braidzone
