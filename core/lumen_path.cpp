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

struct GridPoint {
    bool in_lumen = false;
    bool settled = false;
    double wall_distance = 0.0;  ///< exact below the cap, else a lower bound not below it
    double cost_so_far = std::numeric_limits<double>::infinity();
    GridIndex previous{};
};

/// The grid's points, examined when the search first meets them; the origin is the path's start.
class LumenGrid {
public:
    LumenGrid(const WallTree& wall, const Vec3& origin, double spacing, double cap)
        : wall_(wall), origin_(origin), spacing_(spacing), cap_(cap)
    {
    }

    Vec3 place(const GridIndex& index) const
    {
        return origin_ + spacing_ * Vec3(index[0], index[1], index[2]);
    }

    /// @param distance_bound  the wall is known to be at least this far away
    GridPoint& point(const GridIndex& index, double distance_bound)
    {
        const auto [entry, is_new] = points_.try_emplace(index);
        GridPoint& point = entry->second;
        if (is_new) {
            const Vec3 position = place(index);
            point.in_lumen = wall_.contains(position);
            if (point.in_lumen) {
                point.wall_distance =
                    distance_bound >= cap_ ? distance_bound : wall_.nearest(position).distance;
            }
        }
        return point;
    }

    GridPoint& known_point(const GridIndex& index) { return points_.at(index); }

    /// True if the wall does not lie between two neighbours in the lumen.
    bool joined(const GridIndex& a, double wall_distance, const GridIndex& b) const
    {
        const Vec3 from = place(a), to = place(b);
        return (to - from).norm() < wall_distance || !wall_.first_hit(from, to);
    }

private:
    const WallTree& wall_;
    Vec3 origin_;
    double spacing_;
    double cap_;
    std::unordered_map<GridIndex, GridPoint, GridHash> points_;
};

std::vector<GridIndex> neighbour_offsets()
{
    std::vector<GridIndex> offsets;
    for (int i = -1; i <= 1; ++i) {
        for (int j = -1; j <= 1; ++j) {
            for (int k = -1; k <= 1; ++k) {
                if (i != 0 || j != 0 || k != 0) offsets.push_back({i, j, k});
            }
        }
    }
    return offsets;
}

}  // namespace

std::vector<Vec3> least_cost_path(const WallTree& wall, const Vec3& from, const Vec3& to,
                                  double cap, double spacing)
{
    const std::vector<GridIndex> offsets = neighbour_offsets();
    LumenGrid grid(wall, from, spacing, cap);
    const auto cost_per_length = [&](const GridPoint& point) {
        const double width = std::min(point.wall_distance, cap);
        return 1.0 / (width * width);
    };

    // No rest of a path is cheaper than a straight line at the cap's cost (A* search).
    const auto least_rest = [&](const GridIndex& index) {
        return (grid.place(index) - to).norm() / (cap * cap);
    };

    // Equal costs are taken in the order of the indices: the path does not depend on chance.
    using Entry = std::pair<double, GridIndex>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> front;
    const GridIndex start = {0, 0, 0};
    grid.point(start, 0.0).cost_so_far = 0.0;
    front.emplace(least_rest(start), start);
    while (!front.empty()) {
        const GridIndex index = front.top().second;
        front.pop();
        GridPoint& here = grid.known_point(index);
        if (here.settled) continue;
        here.settled = true;
        const bool arrived =
            (grid.place(index) - to).norm() <= spacing && !wall.first_hit(grid.place(index), to);
        if (arrived) {
            std::vector<Vec3> path = {to};
            for (GridIndex i = index; i != start; i = grid.known_point(i).previous) {
                path.push_back(grid.place(i));
            }
            path.push_back(from);
            std::reverse(path.begin(), path.end());
            return path;
        }
        for (const GridIndex& offset : offsets) {
            const GridIndex next = {index[0] + offset[0], index[1] + offset[1],
                                    index[2] + offset[2]};
            const double length = (grid.place(next) - grid.place(index)).norm();
            GridPoint& there = grid.point(next, here.wall_distance - length);
            if (!there.in_lumen || there.settled) continue;
            const double cost =
                here.cost_so_far + 0.5 * length * (cost_per_length(here) + cost_per_length(there));
            if (!(cost < there.cost_so_far)) continue;
            if (!grid.joined(index, here.wall_distance, next)) continue;
            there.cost_so_far = cost;
            there.previous = index;
            front.emplace(cost + least_rest(next), next);
        }
    }
    return {};
}

}  // namespace braidzone
