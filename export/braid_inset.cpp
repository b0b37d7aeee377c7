#include "export/braid_inset.hpp"

#include "deploy/node_normals.hpp"
#include "export/wire_path.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cassert>

namespace braidzone {

namespace {

constexpr double smallest_cosine = 0.5;  // against a wall that stands across the braid

/// By how much to move a point against a normal so that it is a distance from the wall [m]; 0 if it
/// is.
double missing_inset(const Vec3& point, const Vec3& normal, const WallTree& wall, double distance)
{
    if (!wall.comes_nearer(point, distance)) return 0.0;
    const WallPoint nearest = wall.nearest(point);
    const bool is_outside = (point - nearest.point).dot(nearest.normal) > 0.0;
    const double depth = is_outside ? -nearest.distance : nearest.distance;
    return (distance - depth) / std::max(smallest_cosine, normal.dot(nearest.normal));
}

/// The neighbours of each node along both wires.
std::vector<std::vector<int>> neighbours_of(const BraidLattice& lattice)
{
    std::vector<std::vector<int>> neighbours(static_cast<std::size_t>(lattice.num_nodes()));
    for (const Wire wire : wires_of(lattice)) {
        for (int ring = 0; ring + 1 < lattice.num_rings; ++ring) {
            const int a = lattice.node(ring, column_of_wire(lattice, wire, ring));
            const int b = lattice.node(ring + 1, column_of_wire(lattice, wire, ring + 1));
            neighbours[static_cast<std::size_t>(a)].push_back(b);
            neighbours[static_cast<std::size_t>(b)].push_back(a);
        }
    }
    return neighbours;
}

/// Raises each inset to the mean of its neighbours', several times.
void soften(std::vector<double>& insets, const std::vector<std::vector<int>>& neighbours)
{
    constexpr int sweeps = 8;  // a transition of three or four nodes
    for (int sweep = 0; sweep < sweeps; ++sweep) {
        const std::vector<double> before = insets;
        for (std::size_t node = 0; node < insets.size(); ++node) {
            double sum = 0.0;
            for (const int other : neighbours[node])
                sum += before[static_cast<std::size_t>(other)];
            insets[node] =
                std::max(before[node], sum / static_cast<double>(neighbours[node].size()));
        }
    }
}

std::vector<Vec3> moved_inwards(const std::vector<Vec3>& nodes, const std::vector<Vec3>& normals,
                                const std::vector<double>& insets)
{
    std::vector<Vec3> moved;
    for (std::size_t node = 0; node < nodes.size(); ++node)
        moved.push_back(nodes[node] - insets[node] * normals[node]);
    return moved;
}

/// What is missing at the nodes themselves and along the stretches of wire between them, which is
/// laid on the nodes at both ends.
std::vector<double> missing_insets(const BraidLattice& lattice, const std::vector<Vec3>& nodes,
                                   const std::vector<Vec3>& normals, const WallTree& wall,
                                   double distance)
{
    constexpr int pieces = 6;
    const std::vector<Wire> wires = wires_of(lattice);
    std::vector<std::vector<double>> along(wires.size());
    tbb::parallel_for(std::size_t{0}, wires.size(), [&](std::size_t i) {
        const std::vector<Vec3> points = spline_along_wire(lattice, nodes, wires[i], pieces);
        const std::vector<Vec3> directions = spline_along_wire(lattice, normals, wires[i], pieces);
        for (std::size_t k = 0; k < points.size(); ++k)
            along[i].push_back(
                missing_inset(points[k], directions[k].normalized(), wall, distance));
    });
    std::vector<double> missing(nodes.size(), 0.0);
    for (std::size_t i = 0; i < wires.size(); ++i) {
        for (int ring = 0; ring < lattice.num_rings; ++ring) {
            const int node = lattice.node(ring, column_of_wire(lattice, wires[i], ring));
            const auto at = static_cast<std::size_t>(pieces * ring);
            double& value = missing[static_cast<std::size_t>(node)];
            const std::size_t first = ring > 0 ? at - (pieces - 1) : at;
            const std::size_t last = std::min(at + pieces, along[i].size());
            for (std::size_t k = first; k < last; ++k)
                value = std::max(value, along[i][k]);
        }
    }
    return missing;
}

}  // namespace

InsetBraid inset_braid(const Deployment& deployment, const WallTree& wall, double distance)
{
    assert(distance > 0.0);
    const BraidLattice& lattice = deployment.lattice;
    const std::vector<std::vector<int>> neighbours = neighbours_of(lattice);
    InsetBraid braid{deployment.nodes, node_normals(lattice, deployment.nodes)};
    std::vector<double> insets(deployment.nodes.size(), 0.0);
    // Once moved, other parts of a curved wall may be the nearest.
    constexpr int most_moves = 10;
    for (int move = 0; move < most_moves; ++move) {
        const std::vector<double> missing =
            missing_insets(lattice, braid.nodes, braid.normals, wall, distance);
        if (*std::max_element(missing.begin(), missing.end()) < 0.005 * distance) break;
        for (std::size_t node = 0; node < insets.size(); ++node)
            insets[node] += missing[node];
        soften(insets, neighbours);
        braid.nodes = moved_inwards(deployment.nodes, braid.normals, insets);
    }
    braid.largest_inset = *std::max_element(insets.begin(), insets.end());
    return braid;
}

}  // namespace braidzone
