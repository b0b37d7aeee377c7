#pragma once

#include "core/centerline.hpp"

#include <vector>

namespace braidzone {

/// Lines that meet at common points, as those of a branching vessel do: points of different lines
/// that are nearer to each other than 1e-6 of the whole are one.
class LineNetwork {
public:
    explicit LineNetwork(const std::vector<Polyline>& lines);

    /// Numbers of the points at which lines end that meet no other line there.
    std::vector<int> free_ends() const;

    /// True if a point of the lines is such an end.
    bool ends_at(const Vec3& point) const;

    /// Where a numbered point lies [m].
    const Vec3& place(int point) const { return points_[static_cast<std::size_t>(point)]; }

    /// The shortest path along the lines (Dijkstra 1959, doi 10.1007/BF01386390) between two
    /// numbered points; empty if no lines join them.
    Polyline path(int from, int to) const;

private:
    struct Edge {
        int to;
        double length;
    };

    double tolerance_;  ///< within which points are one [m]
    std::vector<Vec3> points_;
    std::vector<double> radii_;  ///< |points|, or empty
    std::vector<std::vector<Edge>> edges_;
};

}  // namespace braidzone
