#include "core/line_network.hpp"

#include "core/line_points.hpp"
#include "core/triangle_mesh.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <queue>
#include <utility>

namespace braidzone {

namespace {

std::size_t at(int index)
{
    return static_cast<std::size_t>(index);
}

/// Numbers points, the same one for points that lie together.
class PointNumbers {
public:
    explicit PointNumbers(double tolerance) : tolerance_(tolerance) {}

    int number(const Vec3& point, std::vector<Vec3>& points)
    {
        const Cell cell = cell_of(point);
        for (int k = 0; k < 27; ++k) {
            const auto found =
                cells_.find({cell[0] + k % 3 - 1, cell[1] + k / 3 % 3 - 1, cell[2] + k / 9 - 1});
            if (found == cells_.end()) continue;
            if ((points[at(found->second)] - point).norm() <= tolerance_) return found->second;
        }
        const int number = static_cast<int>(points.size());
        points.push_back(point);
        cells_.emplace(cell, number);
        return number;
    }

private:
    using Cell = std::array<long, 3>;

    Cell cell_of(const Vec3& point) const
    {
        Cell cell{};
        for (int axis = 0; axis < 3; ++axis)
            cell[at(axis)] = static_cast<long>(std::floor(point[axis] / tolerance_));
        return cell;
    }

    double tolerance_;
    std::map<Cell, int> cells_;
};

double extent(const std::vector<Polyline>& lines)
{
    TriangleMesh all;
    for (const Polyline& line : lines)
        all.points.insert(all.points.end(), line.points.begin(), line.points.end());
    const Box box = bounding_box(all);
    return (box.upper - box.lower).norm();
}

}  // namespace

LineNetwork::LineNetwork(const std::vector<Polyline>& lines) : tolerance_(1e-6 * extent(lines))
{
    PointNumbers numbers(tolerance_);
    const bool have_radii = std::all_of(lines.begin(), lines.end(), [](const Polyline& line) {
        return !line.inscribed_radii.empty();
    });
    for (const Polyline& line : lines) {
        int before = -1;
        for (std::size_t i = 0; i < line.points.size(); ++i) {
            const int number = numbers.number(line.points[i], points_);
            edges_.resize(points_.size());
            if (have_radii && radii_.size() < points_.size())
                radii_.push_back(line.inscribed_radii[i]);
            if (before >= 0 && before != number) {
                const double length = (points_[at(number)] - points_[at(before)]).norm();
                edges_[at(before)].push_back({number, length});
                edges_[at(number)].push_back({before, length});
            }
            before = number;
        }
    }
}

std::vector<int> LineNetwork::free_ends() const
{
    std::vector<int> ends;
    for (std::size_t i = 0; i < points_.size(); ++i) {
        const auto is_same = [&](const Edge& edge) { return edge.to == edges_[i].front().to; };
        const bool is_end =
            !edges_[i].empty() && std::all_of(edges_[i].begin(), edges_[i].end(), is_same);
        if (is_end) ends.push_back(static_cast<int>(i));
    }
    return ends;
}

bool LineNetwork::ends_at(const Vec3& point) const
{
    const std::vector<int> ends = free_ends();
    return std::any_of(ends.begin(), ends.end(),
                       [&](int end) { return (place(end) - point).norm() <= tolerance_; });
}

Polyline LineNetwork::path(int from, int to) const
{
    constexpr double unreached = std::numeric_limits<double>::infinity();
    using Entry = std::pair<double, int>;
    std::vector<double> length(points_.size(), unreached);
    std::vector<int> previous(points_.size(), -1);
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> front;
    length[at(from)] = 0.0;
    front.emplace(0.0, from);
    while (!front.empty()) {
        const auto [so_far, point] = front.top();
        front.pop();
        if (so_far > length[at(point)]) continue;
        for (const Edge& edge : edges_[at(point)]) {
            if (!(so_far + edge.length < length[at(edge.to)])) continue;
            length[at(edge.to)] = so_far + edge.length;
            previous[at(edge.to)] = point;
            front.emplace(length[at(edge.to)], edge.to);
        }
    }
    Polyline path;
    if (length[at(to)] == unreached) return path;
    for (int point = to; point >= 0; point = previous[at(point)]) {
        path.points.push_back(points_[at(point)]);
        if (!radii_.empty()) path.inscribed_radii.push_back(radii_[at(point)]);
    }
    return reversed(std::move(path));
}

}  // namespace braidzone
