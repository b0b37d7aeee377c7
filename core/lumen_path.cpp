#include "core/lumen_path.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <queue>
#include <unordered_map>
#include <utility>

namespace braidzone {

namespace {

using GridIndex = std::array<int, 3>;

struct GridHash {
    std::size_t operator()(const GridIndex& index) const
    {
        // Spreads three small numbers (Teschner et al. 2003, Optimized spatial hashing).
        return static_cast<std::size_t>(index[0]) * 73856093u ^
               static_cast<std::size_t>(index[1]) * 19349663u ^
               static_cast<std::size_t>(index[2]) * 83492791u;
    }
};

/// Of distances to the wall, relative: far below what a step changes.
constexpr double distance_error = 0.05;

/// Of how deep the lumen is at a point: the distance to the wall there, or from farther away in the
/// direction off the wall as long as it doubles with each doubling of the way.
double depth_of_lumen(const Vec3& point, const WallPoint& foot, const WallTree& wall)
{
    constexpr double least_growth = 1.7;  // of 2: past an edge between facets of 60 degrees too
    constexpr int most_doublings = 20;
    double distance = foot.distance;
    for (int k = 0; k < most_doublings; ++k) {
        const Vec3 deeper = foot.point + 2.0 * distance / foot.distance * (point - foot.point);
        if (wall.comes_nearer(deeper, least_growth * distance)) break;
        distance *= 2.0;
    }
    return distance;
}

struct GridPoint {
    bool in_lumen = false;
    bool settled = false;
    int step = 1;                ///< to its neighbours, in units of the finest grid
    double wall_distance = 0.0;  ///< [m]
    double cost_so_far = std::numeric_limits<double>::infinity();
    GridIndex previous{};
};

/// The grid's points, examined when the search first meets them; the origin is the path's start.
class LumenGrid {
public:
    LumenGrid(const WallTree& wall, const Vec3& origin, double spacing)
        : wall_(wall), origin_(origin), finest_(spacing / 2.0), least_radius_(0.25 * spacing)
    {
    }

    Vec3 place(const GridIndex& index) const
    {
        return origin_ + finest_ * Vec3(index[0], index[1], index[2]);
    }

    double length_of(int step) const { return finest_ * step; }

    GridPoint& point(const GridIndex& index)
    {
        const auto [entry, is_new] = points_.try_emplace(index);
        if (is_new) examine(place(index), entry->second);
        return entry->second;
    }

    GridPoint& known_point(const GridIndex& index) { return points_.at(index); }

    /// True if the wall does not lie between two neighbours in the lumen.
    bool joined(const Vec3& from, double wall_distance, const Vec3& to) const
    {
        return (to - from).norm() < (1.0 - distance_error) * wall_distance ||
               !wall_.first_hit(from, to);
    }

    /// The points of a grid of the point's own step around it.
    template <typename Visit>
    void visit_neighbours(const GridIndex& index, int step, const Visit& visit) const
    {
        GridIndex middle{};
        for (std::size_t axis = 0; axis < 3; ++axis)
            middle[axis] = step * static_cast<int>(std::lround(1.0 * index[axis] / step));
        for (int i = -step; i <= step; i += step) {
            for (int j = -step; j <= step; j += step) {
                for (int k = -step; k <= step; k += step) {
                    const GridIndex next = {middle[0] + i, middle[1] + j, middle[2] + k};
                    if (next != index) visit(next);
                }
            }
        }
    }

private:
    void examine(const Vec3& position, GridPoint& point) const
    {
        const WallPoint foot = wall_.nearly_nearest(position, distance_error);
        point.wall_distance = foot.distance;
        point.in_lumen = foot.distance >= least_radius_ && wall_.contains(position);
        if (!point.in_lumen) return;
        const double depth = depth_of_lumen(position, foot, wall_);
        constexpr double steps_per_depth = 2.5;
        constexpr int largest_step = 1 << 12;
        while (point.step < largest_step &&
               2.0 * length_of(point.step) * steps_per_depth <= depth) {
            point.step *= 2;
        }
    }

    const WallTree& wall_;
    Vec3 origin_;
    double finest_;        ///< step [m]
    double least_radius_;  ///< of a passage [m]
    std::unordered_map<GridIndex, GridPoint, GridHash> points_;
};

class Search {
public:
    Search(const WallTree& wall, const Vec3& from, const Vec3& to, double cap, double spacing)
        : to_(to), cap_(cap), spacing_(spacing), grid_(wall, from, spacing)
    {
    }

    /// The points after `from`, up to `to`; empty if no path joins them.
    std::vector<Vec3> path()
    {
        grid_.point(start).cost_so_far = 0.0;
        front_.emplace(least_rest(start), start);
        while (!front_.empty()) {
            const GridIndex index = front_.top().second;
            front_.pop();
            GridPoint& here = grid_.known_point(index);
            if (here.settled) continue;
            here.settled = true;
            if (arrived(index, here)) return way_to(index);
            grid_.visit_neighbours(index, here.step,
                                   [&](const GridIndex& next) { reach(index, here, next); });
        }
        return {};
    }

private:
    static constexpr GridIndex start = {0, 0, 0};

    double cost_per_length(const GridPoint& point) const
    {
        // An end of the path may lie nearer to the wall than any passage does.
        const double width = std::min(std::max(point.wall_distance, 0.25 * spacing_), cap_);
        return 1.0 / (width * width);
    }

    /// No rest of a path is cheaper than a straight line at the cap's cost.
    double least_rest(const GridIndex& index) const
    {
        return (grid_.place(index) - to_).norm() / (cap_ * cap_);
    }

    bool arrived(const GridIndex& index, const GridPoint& here) const
    {
        const Vec3 place = grid_.place(index);
        const double reach = std::max(spacing_, grid_.length_of(here.step));
        return (place - to_).norm() <= reach && grid_.joined(place, here.wall_distance, to_);
    }

    void reach(const GridIndex& index, const GridPoint& here, const GridIndex& next)
    {
        GridPoint& there = grid_.point(next);
        if (!there.in_lumen || there.settled) return;
        const Vec3 from = grid_.place(index), to = grid_.place(next);
        const double cost = here.cost_so_far + 0.5 * (to - from).norm() *
                                                   (cost_per_length(here) + cost_per_length(there));
        if (!(cost < there.cost_so_far)) return;
        if (!grid_.joined(from, here.wall_distance, to)) return;
        there.cost_so_far = cost;
        there.previous = index;
        front_.emplace(cost + least_rest(next), next);
    }

    std::vector<Vec3> way_to(const GridIndex& last)
    {
        std::vector<Vec3> path = {to_};
        for (GridIndex i = last; i != start; i = grid_.known_point(i).previous)
            path.push_back(grid_.place(i));
        std::reverse(path.begin(), path.end());
        return path;
    }

    // Equal costs are taken in the order of the indices: the path does not depend on chance.
    using Entry = std::pair<double, GridIndex>;

    Vec3 to_;
    double cap_, spacing_;
    LumenGrid grid_;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> front_;
};

}  // namespace

std::vector<Vec3> least_cost_path(const WallTree& wall, const Vec3& from, const Vec3& to,
                                  double cap, double spacing)
{
    // From the narrower end the rest is cheap: few points elsewhere are as cheap.
    const bool from_end = wall.nearest(to).distance < wall.nearest(from).distance;
    std::vector<Vec3> path =
        Search(wall, from_end ? to : from, from_end ? from : to, cap, spacing).path();
    if (path.empty()) return {};
    path.insert(path.begin(), from_end ? to : from);
    if (from_end) std::reverse(path.begin(), path.end());
    return path;
}

}  // namespace braidzone
