#include "export/braid_inset.hpp"

#include "deploy/node_normals.hpp"
#include "export/wire_path.hpp"

#include <tbb/blocked_range.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <array>
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

/// A place between nodes of a braid: on a wire or on a rhombus.
struct Place {
    Vec3 point = Vec3::Zero();   ///< [m]
    Vec3 normal = Vec3::Zero();  ///< of the braid, not unit
};

/// Raises what is missing at some nodes to what is missing at a place between them.
class MissingInsets {
public:
    MissingInsets(std::vector<double>& missing, const WallTree& wall, double distance)
        : missing_(missing), wall_(wall), distance_(distance)
    {
    }

    template <std::size_t N>
    void add(const Place& place, const std::array<int, N>& nodes)
    {
        const double inset =
            missing_inset(place.point, place.normal.normalized(), wall_, distance_);
        for (const int node : nodes) {
            double& value = missing_[static_cast<std::size_t>(node)];
            value = std::max(value, inset);
        }
    }

private:
    std::vector<double>& missing_;
    const WallTree& wall_;
    double distance_ = 0.0;
};

/// True if one of the nodes has moved.
template <std::size_t N>
bool has_moved(const std::vector<char>& moved, const std::array<int, N>& nodes)
{
    return std::any_of(nodes.begin(), nodes.end(),
                       [&](int node) { return moved[static_cast<std::size_t>(node)] != 0; });
}

/// What is missing along the wires, between each two crossings. Only stretches with a node that has
/// moved are looked at.
void add_along_wire(MissingInsets& missing, const BraidLattice& lattice, const InsetBraid& braid,
                    Wire wire, const std::vector<char>& moved)
{
    constexpr int pieces = 6;
    const std::vector<Vec3> points = spline_along_wire(lattice, braid.nodes, wire, pieces);
    const std::vector<Vec3> normals = spline_along_wire(lattice, braid.normals, wire, pieces);
    for (int ring = 0; ring + 1 < lattice.num_rings; ++ring) {
        const std::array<int, 2> ends{
            lattice.node(ring, column_of_wire(lattice, wire, ring)),
            lattice.node(ring + 1, column_of_wire(lattice, wire, ring + 1))};
        if (!has_moved(moved, ends)) continue;
        for (int piece = 0; piece <= pieces; ++piece) {
            const auto at = static_cast<std::size_t>(pieces * ring + piece);
            missing.add({points[at], normals[at]}, ends);
        }
    }
}

/// What is missing on a triangle of a rhombus, at places a third of its sides apart.
void add_on_triangle(MissingInsets& missing, const InsetBraid& braid,
                     const std::array<int, 3>& corners, const std::vector<char>& moved)
{
    if (!has_moved(moved, corners)) return;
    constexpr int parts = 3;
    const auto mean = [&](const std::vector<Vec3>& values, int i, int j) -> Vec3 {
        const auto value = [&](std::size_t k) -> const Vec3& {
            return values[static_cast<std::size_t>(corners[k])];
        };
        return (i * value(0) + j * value(1) + (parts - i - j) * value(2)) / parts;
    };
    for (int i = 0; i <= parts; ++i)
        for (int j = 0; i + j <= parts; ++j)
            missing.add({mean(braid.nodes, i, j), mean(braid.normals, i, j)}, corners);
}

std::vector<double> missing_insets(const BraidLattice& lattice, const InsetBraid& braid,
                                   const WallTree& wall, double distance,
                                   const std::vector<char>& moved)
{
    const std::vector<Wire> wires = wires_of(lattice);
    const std::vector<std::array<int, 3>> triangles = rhombus_triangles(lattice);
    const std::vector<double> none(braid.nodes.size(), 0.0);
    using Range = tbb::blocked_range<std::size_t>;
    const auto larger = [](std::vector<double> a, const std::vector<double>& b) {
        for (std::size_t i = 0; i < a.size(); ++i)
            a[i] = std::max(a[i], b[i]);
        return a;
    };
    const std::vector<double> along_wires = tbb::parallel_reduce(
        Range(0, wires.size()), none,
        [&](const Range& range, std::vector<double> values) {
            MissingInsets missing(values, wall, distance);
            for (std::size_t i = range.begin(); i < range.end(); ++i)
                add_along_wire(missing, lattice, braid, wires[i], moved);
            return values;
        },
        larger);
    return tbb::parallel_reduce(
        Range(0, triangles.size(), triangles.size() / 16 + 1), along_wires,
        [&](const Range& range, std::vector<double> values) {
            MissingInsets missing(values, wall, distance);
            for (std::size_t i = range.begin(); i < range.end(); ++i)
                add_on_triangle(missing, braid, triangles[i], moved);
            return values;
        },
        larger);
}

}  // namespace

InsetBraid inset_braid(const Deployment& deployment, const WallTree& wall, double distance)
{
    assert(distance > 0.0);
    const BraidLattice& lattice = deployment.lattice;
    const std::vector<std::vector<int>> neighbours = neighbours_of(lattice);
    InsetBraid braid{deployment.nodes, node_normals(lattice, deployment.nodes)};
    std::vector<double> insets(deployment.nodes.size(), 0.0);
    std::vector<char> moved(insets.size(), 1);
    // Once moved, other parts of a curved wall may be the nearest; beside a wall that stands across
    // the braid each move gains a part of what is missing only.
    constexpr int most_moves = 40;
    for (int move = 0; move < most_moves; ++move) {
        const std::vector<double> missing = missing_insets(lattice, braid, wall, distance, moved);
        if (*std::max_element(missing.begin(), missing.end()) < 0.005 * distance) break;
        const std::vector<double> before = insets;
        for (std::size_t node = 0; node < insets.size(); ++node)
            insets[node] += missing[node];
        soften(insets, neighbours);
        for (std::size_t node = 0; node < insets.size(); ++node)
            moved[node] = insets[node] > before[node];
        braid.nodes = moved_inwards(deployment.nodes, braid.normals, insets);
    }
    braid.largest_inset = *std::max_element(insets.begin(), insets.end());
    return braid;
}

TriangleMesh inner_face(const BraidLattice& lattice, const InsetBraid& braid, double depth)
{
    const std::vector<double> depths(braid.nodes.size(), depth);
    return {moved_inwards(braid.nodes, braid.normals, depths), rhombus_triangles(lattice)};
}

}  // namespace braidzone
