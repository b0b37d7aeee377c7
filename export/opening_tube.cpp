#include "export/opening_tube.hpp"

#include <algorithm>
#include <cmath>

namespace braidzone {

namespace {

constexpr double bend_ratio = 2.0;     // of the arc's radius to the outline's; 1 would pinch
constexpr double longest_turn = 0.15;  // between rings [rad]
// Less is left to the way to the plane, which shears the outline by 5e-5 of its radius at most.
constexpr double least_turn = 0.01;

double mean_edge(const std::vector<Vec3>& ring)
{
    double sum = 0.0;
    for (std::size_t i = 0; i < ring.size(); ++i)
        sum += (ring[(i + 1) % ring.size()] - ring[i]).norm();
    return sum / static_cast<double>(ring.size());
}

/// Number of steps no longer than `longest`, at least one.
int steps_of(double length, double longest)
{
    return std::max(1, static_cast<int>(std::ceil(length / longest)));
}

}  // namespace

TubeRings bent_tube(const Vessel& vessel, const Opening& opening, const Vec3& direction,
                    double straight)
{
    TubeRings tube;
    std::vector<Vec3> rim, flat;
    std::vector<double> heights;
    double radius = 0.0;
    for (const int point : opening.rim) {
        const Vec3& place = vessel.wall.points[static_cast<std::size_t>(point)];
        const double height = (place - opening.centre).dot(opening.normal);
        rim.push_back(place);
        heights.push_back(height);
        flat.emplace_back(place - opening.centre - height * opening.normal);
        radius = std::max(radius, flat.back().norm());
    }
    tube.rings.push_back(rim);
    tube.arc_lengths.push_back(0.0);

    const double edge = mean_edge(rim);
    const int num_straight = steps_of(straight, edge);
    for (int step = 1; step <= num_straight; ++step) {
        const double share = static_cast<double>(step) / num_straight;
        std::vector<Vec3> ring;
        for (std::size_t i = 0; i < flat.size(); ++i) {
            const double height = share * straight + (1.0 - share) * heights[i];
            ring.emplace_back(opening.centre + flat[i] + height * opening.normal);
        }
        tube.rings.push_back(ring);
        tube.arc_lengths.push_back(share * straight);
    }

    const Vec3 axis = opening.normal.cross(direction);
    const double angle = std::atan2(axis.norm(), opening.normal.dot(direction));
    if (!(angle > least_turn)) return tube;
    const Vec3 turn_axis = axis.normalized(), sideways = turn_axis.cross(opening.normal);
    const double bend = bend_ratio * radius;
    const int num_turns = std::max(steps_of(angle, longest_turn), steps_of(angle * bend, 2 * edge));
    for (int step = 1; step <= num_turns; ++step) {
        const double phi = angle * step / num_turns;
        const Vec3 centre =
            opening.centre + straight * opening.normal +
            bend * (std::sin(phi) * opening.normal + (1.0 - std::cos(phi)) * sideways);
        const Mat3 turn = Eigen::AngleAxisd(phi, turn_axis).toRotationMatrix();
        std::vector<Vec3> ring;
        for (const Vec3& offset : flat)
            ring.emplace_back(centre + turn * offset);
        tube.rings.push_back(ring);
        tube.arc_lengths.push_back(straight + bend * phi);
    }
    return tube;
}

void continue_to_plane(TubeRings& tube, const Vec3& direction, double height)
{
    const std::vector<Vec3> from = tube.rings.back();
    const double start = tube.arc_lengths.back(), length = height - from.front().dot(direction);
    const int num_steps = steps_of(length, 2.0 * mean_edge(from));
    for (int step = 1; step <= num_steps; ++step) {
        const double share = static_cast<double>(step) / num_steps;
        std::vector<Vec3> ring;
        for (const Vec3& point : from) {
            // To the plane itself at the end, whatever the round-off of the turn.
            const double rise = height - point.dot(direction);
            ring.emplace_back(point + share * rise * direction);
        }
        tube.rings.push_back(ring);
        tube.arc_lengths.push_back(start + share * length);
    }
}

std::vector<int> append_tube(TriangleMesh& mesh, const std::vector<int>& rim, const TubeRings& tube)
{
    std::vector<int> last = rim;
    for (std::size_t k = 1; k < tube.rings.size(); ++k) {
        std::vector<int> next;
        for (const Vec3& point : tube.rings[k]) {
            next.push_back(static_cast<int>(mesh.points.size()));
            mesh.points.push_back(point);
        }
        for (std::size_t i = 0; i < rim.size(); ++i) {
            const std::size_t j = (i + 1) % rim.size();
            mesh.triangles.push_back({last[i], last[j], next[j]});
            mesh.triangles.push_back({last[i], next[j], next[i]});
        }
        last = next;
    }
    return last;
}

}  // namespace braidzone
