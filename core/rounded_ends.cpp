#include "core/rounded_ends.hpp"

#include "core/disjoint_sets.hpp"
#include "core/lumen_behind.hpp"

#include <algorithm>
#include <array>
#include <functional>
#include <limits>
#include <optional>
#include <queue>
#include <utility>

namespace braidzone {

namespace {

constexpr double unreached = std::numeric_limits<double>::infinity();

std::size_t at(int index)
{
    return static_cast<std::size_t>(index);
}

/// The edges of a surface, at each of their points.
class EdgeGraph {
public:
    explicit EdgeGraph(const TriangleMesh& mesh) : neighbours_(mesh.points.size())
    {
        for (const std::array<int, 3>& corners : mesh.triangles) {
            for (std::size_t k = 0; k < 3; ++k) {
                const int a = corners[k], b = corners[(k + 1) % 3];
                const double length = (mesh.points[at(a)] - mesh.points[at(b)]).norm();
                neighbours_[at(a)].emplace_back(b, length);
                neighbours_[at(b)].emplace_back(a, length);
            }
        }
    }

    const std::vector<std::pair<int, double>>& around(int point) const
    {
        return neighbours_[at(point)];
    }

    /// Shortest paths from the nearest source, up to a length [m].
    std::vector<double> distances(const std::vector<int>& sources, double longest) const
    {
        using Entry = std::pair<double, int>;
        std::vector<double> distance(neighbours_.size(), unreached);
        std::priority_queue<Entry, std::vector<Entry>, std::greater<>> front;
        for (const int source : sources) {
            distance[at(source)] = 0.0;
            front.emplace(0.0, source);
        }
        while (!front.empty()) {
            const auto [length, point] = front.top();
            front.pop();
            if (length > distance[at(point)]) continue;
            for (const auto& [neighbour, edge] : around(point)) {
                const double through = length + edge;
                if (through >= distance[at(neighbour)] || through > longest) continue;
                distance[at(neighbour)] = through;
                front.emplace(through, neighbour);
            }
        }
        return distance;
    }

private:
    std::vector<std::vector<std::pair<int, double>>> neighbours_;
};

int farthest(const std::vector<double>& distance)
{
    int found = -1;
    for (std::size_t k = 0; k < distance.size(); ++k) {
        if (distance[k] == unreached) continue;
        if (found < 0 || distance[k] > distance[at(found)]) found = static_cast<int>(k);
    }
    return found;
}

/// Local maxima with their persistence: by descending height, regions about maxima grow until they
/// meet, where the lower one's ends.
std::vector<std::pair<int, double>> maxima(const EdgeGraph& graph,
                                           const std::vector<double>& height)
{
    std::vector<int> order;
    for (std::size_t k = 0; k < height.size(); ++k) {
        if (height[k] != unreached) order.push_back(static_cast<int>(k));
    }
    std::stable_sort(order.begin(), order.end(),
                     [&](int a, int b) { return height[at(a)] > height[at(b)]; });
    DisjointSets regions(height.size());
    std::vector<int> summit(height.size(), -1);  // of the region that a point is the root of
    std::vector<std::pair<int, double>> found;
    for (const int point : order) {
        summit[at(point)] = point;
        for (const auto& [neighbour, edge] : graph.around(point)) {
            if (summit[at(neighbour)] < 0) continue;
            const std::size_t a = regions.find(at(point)), b = regions.find(at(neighbour));
            if (a == b) continue;
            int high = summit[a], low = summit[b];
            if (height[at(low)] > height[at(high)]) std::swap(high, low);
            const double rise = height[at(low)] - height[at(point)];
            if (rise > 0.0) found.emplace_back(low, rise);
            regions.unite(a, b);
            summit[regions.find(a)] = high;
        }
    }
    if (!order.empty()) found.emplace_back(order.front(), height[at(order.front())]);
    return found;
}

/// Mean of the points between two distances from the tip.
std::optional<Vec3> band_middle(const TriangleMesh& mesh, const std::vector<double>& distance,
                                double from, double to)
{
    Vec3 sum = Vec3::Zero();
    double number = 0.0;
    for (std::size_t k = 0; k < distance.size(); ++k) {
        if (!(distance[k] >= from && distance[k] <= to)) continue;
        sum += mesh.points[k];
        number += 1.0;
    }
    if (!(number >= 3.0)) return std::nullopt;
    return sum / number;
}

std::vector<Vec3> point_normals(const TriangleMesh& mesh)
{
    std::vector<Vec3> normals(mesh.points.size(), Vec3::Zero());
    for (std::size_t k = 0; k < mesh.triangles.size(); ++k) {
        for (const int point : mesh.triangles[k])
            normals[at(point)] += area_vector(mesh, static_cast<int>(k));
    }
    for (Vec3& normal : normals)
        normal.normalize();
    return normals;
}

/// True if the wall about a summit, down to a depth, closes the lumen as a dome does. Where paths
/// from two openings meet it is a band around the lumen, whose area vectors cancel each other.
bool is_dome(int summit, double depth, const TriangleMesh& mesh, const EdgeGraph& graph,
             const std::vector<double>& height)
{
    constexpr double least_share = 0.2;  // 0.63 for a half sphere down to 1.3 radii
    std::vector<char> is_inside(mesh.points.size(), 0);
    std::vector<int> front{summit};
    is_inside[at(summit)] = 1;
    while (!front.empty()) {
        const int point = front.back();
        front.pop_back();
        for (const auto& [neighbour, edge] : graph.around(point)) {
            if (is_inside[at(neighbour)] || height[at(neighbour)] < height[at(summit)] - depth)
                continue;
            is_inside[at(neighbour)] = 1;
            front.push_back(neighbour);
        }
    }
    Vec3 sum = Vec3::Zero();
    double area = 0.0;
    for (std::size_t k = 0; k < mesh.triangles.size(); ++k) {
        const auto& [a, b, c] = mesh.triangles[k];
        if (!is_inside[at(a)] || !is_inside[at(b)] || !is_inside[at(c)]) continue;
        const Vec3 vector = area_vector(mesh, static_cast<int>(k));
        sum += vector;
        area += vector.norm();
    }
    return sum.norm() > least_share * area;
}

RoundedEnd end_at(int tip, double radius, const Vec3& normal, const TriangleMesh& mesh,
                  const EdgeGraph& graph)
{
    RoundedEnd end{mesh.points[at(tip)], Vec3::Zero(), normal, radius};
    end.centre = end.tip - radius * normal;
    const std::vector<double> distance = graph.distances({tip}, 3.0 * radius);
    const std::optional<Vec3> near = band_middle(mesh, distance, 1.3 * radius, 1.9 * radius);
    const std::optional<Vec3> far = band_middle(mesh, distance, 2.3 * radius, 2.9 * radius);
    if (!near || !far || !((*near - *far).norm() > 0.1 * radius)) return end;
    end.centre = *near;
    end.outwards = (*near - *far).normalized();
    return end;
}

}  // namespace

std::vector<RoundedEnd> rounded_ends(const TriangleMesh& mesh, const std::vector<Opening>& openings,
                                     const WallTree& wall)
{
    const EdgeGraph graph(mesh);
    std::vector<int> sources;
    for (const Opening& opening : openings)
        sources.insert(sources.end(), opening.rim.begin(), opening.rim.end());
    std::vector<std::pair<int, double>> tips;
    if (sources.empty()) {
        sources = {farthest(graph.distances({mesh.triangles.front()[0]}, unreached))};
        tips.emplace_back(sources.front(), unreached);
    }
    const std::vector<double> height = graph.distances(sources, unreached);
    for (const auto& maximum : maxima(graph, height))
        tips.push_back(maximum);

    const std::vector<Vec3> normals = point_normals(mesh);
    std::vector<RoundedEnd> ends;
    for (const auto& [tip, rise] : tips) {
        const double step = graph.around(tip).front().second;
        if (!(rise > 2.0 * step)) continue;  // roughness of the wall
        const Vec3& normal = normals[at(tip)];
        const double radius = first_largest_distance(mesh.points[at(tip)], -normal, step, wall);
        if (!(rise > radius)) continue;
        const double depth = std::min(0.9 * rise, 1.3 * radius);
        if (rise < unreached && !is_dome(tip, depth, mesh, graph, height)) continue;
        // Across a tube, where paths from three openings meet, the opposite wall is 2 radii away.
        constexpr double least_depth = 2.3;
        const Vec3 inside = mesh.points[at(tip)] - 0.1 * radius * normal;
        if (wall.first_hit(inside, mesh.points[at(tip)] - least_depth * radius * normal)) continue;
        ends.push_back(end_at(tip, radius, normal, mesh, graph));
    }
    std::stable_sort(ends.begin(), ends.end(),
                     [](const RoundedEnd& a, const RoundedEnd& b) { return a.radius > b.radius; });
    return ends;
}

}  // namespace braidzone
