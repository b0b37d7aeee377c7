#include "core/line_order.hpp"

#include "core/error.hpp"
#include "core/place_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>
#include <set>
#include <utility>

namespace braidzone {

namespace {

constexpr double longest_over_median = 3.0;

std::size_t at(int index)
{
    return static_cast<std::size_t>(index);
}

Polyline without_repeated_points(const Polyline& line)
{
    Polyline distinct;
    std::set<std::array<double, 3>> seen;
    for (std::size_t i = 0; i < line.points.size(); ++i) {
        const Vec3& point = line.points[i];
        if (!seen.insert({point.x(), point.y(), point.z()}).second) continue;
        distinct.points.push_back(point);
        if (!line.inscribed_radii.empty())
            distinct.inscribed_radii.push_back(line.inscribed_radii[i]);
    }
    return distinct;
}

double median(std::vector<double> values)
{
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

bool is_plainly_in_order(const std::vector<Vec3>& points)
{
    std::vector<double> lengths;
    for (std::size_t i = 1; i < points.size(); ++i) {
        lengths.push_back((points[i] - points[i - 1]).norm());
        const bool turns_back =
            i > 1 && (points[i] - points[i - 1]).dot(points[i - 1] - points[i - 2]) < 0.0;
        if (turns_back) return false;
    }
    return *std::max_element(lengths.begin(), lengths.end()) <=
           longest_over_median * median(lengths);
}

/// The edges of the minimum spanning tree, the smaller index first.
std::set<std::pair<int, int>> spanning_tree(const std::vector<Vec3>& points)
{
    const int n = static_cast<int>(points.size());
    std::vector<double> distance(points.size(), std::numeric_limits<double>::infinity());
    std::vector<int> nearest(points.size(), 0);
    std::vector<char> is_in(points.size(), 0);
    std::set<std::pair<int, int>> edges;
    int last = 0;
    is_in[0] = 1;
    for (int size = 1; size < n; ++size) {
        int next = -1;
        for (int i = 0; i < n; ++i) {
            if (is_in[at(i)]) continue;
            const double to_last = (points[at(i)] - points[at(last)]).squaredNorm();
            if (to_last < distance[at(i)]) {
                distance[at(i)] = to_last;
                nearest[at(i)] = last;
            }
            if (next < 0 || distance[at(i)] < distance[at(next)]) next = i;
        }
        edges.insert(std::minmax(next, nearest[at(next)]));
        is_in[at(next)] = 1;
        last = next;
    }
    return edges;
}

/// The points along a tree that is a single chain; empty for any other tree.
std::vector<int> chain_of(const std::set<std::pair<int, int>>& edges, int num_points)
{
    std::vector<std::vector<int>> neighbours(at(num_points));
    for (const auto& [a, b] : edges) {
        neighbours[at(a)].push_back(b);
        neighbours[at(b)].push_back(a);
    }
    std::vector<int> chain;
    for (int i = 0; i < num_points; ++i) {
        if (neighbours[at(i)].size() > 2) return {};
        if (neighbours[at(i)].size() == 1 && chain.empty()) chain.push_back(i);
    }
    for (int before = -1; chain.size() < at(num_points);) {
        const std::vector<int>& near = neighbours[at(chain.back())];
        const int next = near.front() != before ? near.front() : near.back();
        before = chain.back();
        chain.push_back(next);
    }
    return chain;
}

/// Segments of the chain that the file has in the same direction, less those in the other.
int direction_of(const std::vector<int>& chain)
{
    int sum = 0;
    for (std::size_t i = 1; i < chain.size(); ++i) {
        if (chain[i] == chain[i - 1] + 1) ++sum;
        if (chain[i] == chain[i - 1] - 1) --sum;
    }
    return sum;
}

/// The first segment that is not in the tree, far longer than its edges, and against the direction
/// of a segment beside it; by its first point.
int first_jump(const std::vector<Vec3>& points, const std::set<std::pair<int, int>>& edges)
{
    std::vector<double> lengths;
    for (const auto& [a, b] : edges)
        lengths.push_back((points[at(a)] - points[at(b)]).norm());
    const double longest = longest_over_median * median(lengths);
    const int last = static_cast<int>(points.size()) - 1;
    const auto segment = [&](int i) -> Vec3 { return points[at(i + 1)] - points[at(i)]; };
    for (int i = 0; i < last; ++i) {
        if (segment(i).norm() <= longest || edges.contains({i, i + 1})) continue;
        const bool turns_back = (i > 0 && segment(i).dot(segment(i - 1)) < 0.0) ||
                                (i + 1 < last && segment(i).dot(segment(i + 1)) < 0.0);
        if (turns_back) return i;
    }
    return -1;
}

}  // namespace

OrderedLine in_evident_order(const Polyline& line)
{
    const Polyline distinct = without_repeated_points(line);
    const std::vector<Vec3>& points = distinct.points;
    if (points.size() < 3 || is_plainly_in_order(points)) return {line, 0};

    const std::set<std::pair<int, int>> edges = spanning_tree(points);
    std::vector<int> chain = chain_of(edges, static_cast<int>(points.size()));
    if (chain.empty()) {
        const int jump = first_jump(points, edges);
        if (jump < 0) return {line, 0};
        throw GeometryError(fmt::format(
            "the centerline jumps from {} to {}, and its points form no single chain in another "
            "order; write them as they follow each other",
            place_text(points[at(jump)]), place_text(points[at(jump + 1)])));
    }
    if (direction_of(chain) < 0) std::reverse(chain.begin(), chain.end());
    OrderedLine ordered;
    for (std::size_t i = 0; i < chain.size(); ++i) {
        ordered.line.points.push_back(points[at(chain[i])]);
        if (!distinct.inscribed_radii.empty())
            ordered.line.inscribed_radii.push_back(distinct.inscribed_radii[at(chain[i])]);
        if (i > 0 && chain[i] != chain[i - 1] + 1) ++ordered.num_misplaced;
    }
    if (ordered.num_misplaced == 0) return {line, 0};
    return ordered;
}

}  // namespace braidzone
