#include "core/plane_cut.hpp"

#include "core/error.hpp"
#include "core/mesh_topology.hpp"
#include "core/place_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <set>
#include <utility>

namespace braidzone {

namespace {

using Corners = std::array<int, 3>;
using Edge = std::pair<int, int>;  // smaller index first

std::size_t at(int index)
{
    return static_cast<std::size_t>(index);
}

Edge edge_between(int a, int b)
{
    return std::minmax(a, b);
}

/// For each triangle its neighbours across the sides that begin at its corners 0, 1 and 2; -1 at a
/// rim.
std::vector<std::array<int, 3>> neighbours(const TriangleMesh& mesh)
{
    std::vector<std::array<int, 3>> result(mesh.triangles.size(), {-1, -1, -1});
    const auto join = [&](const TriangleSide& side, int neighbour) {
        const Corners& corners = mesh.triangles[at(side.triangle)];
        const int start = side.forward ? side.low : side.high;
        const auto where = std::find(corners.begin(), corners.end(), start) - corners.begin();
        result[at(side.triangle)][static_cast<std::size_t>(where)] = neighbour;
    };
    for_each_edge(sorted_sides(mesh), [&](auto first, auto last) {
        if (last - first != 2) return;
        join(*first, (first + 1)->triangle);
        join(*(first + 1), first->triangle);
    });
    return result;
}

/// Where the points lie. No point counts as lying on the plane: a triangle is crossed through two
/// of its sides or not at all, and a section is a simple loop of triangles.
class Heights {
public:
    Heights(const TriangleMesh& mesh, const Vec3& point, const Vec3& normal)
    {
        for (const Vec3& p : mesh.points)
            heights_.push_back((p - point).dot(normal));
    }
    double operator()(int point) const { return heights_[at(point)]; }
    bool beyond(int point) const { return heights_[at(point)] >= 0.0; }
    bool crosses(int a, int b) const { return beyond(a) != beyond(b); }

private:
    std::vector<double> heights_;
};

/// A closed section: the triangles that it runs through, anticlockwise about the normal where the
/// section encloses the lumen. From one to the next it crosses the edge that `exits` names.
struct Section {
    std::vector<int> triangles;
    std::vector<Edge> exits;
};

/// All closed sections. Those that end at a rim are left out.
std::vector<Section> closed_sections(const TriangleMesh& mesh, const Heights& heights)
{
    const std::vector<std::array<int, 3>> adjacent = neighbours(mesh);
    std::vector<char> visited(mesh.triangles.size(), 0);
    std::vector<Section> sections;
    for (std::size_t start = 0; start < mesh.triangles.size(); ++start) {
        Section section;
        int triangle = static_cast<int>(start);
        while (triangle >= 0 && !visited[at(triangle)]) {
            // A crossed triangle, and no other, has one side that rises through the plane.
            const Corners& corners = mesh.triangles[at(triangle)];
            std::size_t side = 0;
            while (side < 3 &&
                   !(!heights.beyond(corners[side]) && heights.beyond(corners[(side + 1) % 3])))
                ++side;
            if (side == 3) break;
            visited[at(triangle)] = 1;
            section.triangles.push_back(triangle);
            section.exits.push_back(edge_between(corners[side], corners[(side + 1) % 3]));
            triangle = adjacent[at(triangle)][side];
        }
        const bool is_closed = !section.triangles.empty() && triangle == static_cast<int>(start);
        if (is_closed) sections.push_back(std::move(section));
    }
    return sections;
}

Vec3 crossing_point(const TriangleMesh& mesh, const Heights& heights, const Edge& edge)
{
    const auto& [a, b] = edge;
    const double share = heights(a) / (heights(a) - heights(b));
    return mesh.points[at(a)] + share * (mesh.points[at(b)] - mesh.points[at(a)]);
}

/// What a section's polygon looks like from a point in its plane.
struct PolygonView {
    double area = 0.0;           ///< positive if the polygon is anticlockwise [m^2]
    Vec3 centre = Vec3::Zero();  ///< its area centroid [m]
    double turns = 0.0;          ///< how often it winds around the point
};

PolygonView view_of(const std::vector<Vec3>& polygon, const Vec3& point, const Vec3& normal)
{
    PolygonView view;
    Vec3 moment = Vec3::Zero();
    for (std::size_t k = 0; k < polygon.size(); ++k) {
        const Vec3 a = polygon[k] - point, b = polygon[(k + 1) % polygon.size()] - point;
        const double twice_area = normal.dot(a.cross(b));
        view.area += 0.5 * twice_area;
        moment += 0.5 * twice_area * (a + b) / 3.0;
        view.turns += std::atan2(twice_area, a.dot(b)) / (2.0 * std::numbers::pi);
    }
    view.centre = point + moment / view.area;
    return view;
}

/// The mesh, split along one section.
struct SplitMesh {
    TriangleMesh mesh;
    /// The edges in the plane, from and to, directed as the section's triangles follow each other:
    /// the triangle beyond runs along the edge, the one behind the plane against it.
    std::set<std::pair<int, int>> rim;
};

/// Splits the section's triangles. Points close to the plane move onto it and stand for the
/// crossings of their edges: a triangle that has nothing of its own left on one side stays whole.
class Splitter {
public:
    Splitter(const TriangleMesh& mesh, const Heights& heights, const Vec3& normal,
             const Section& section)
        : heights_(heights), is_moved_(mesh.points.size(), 0)
    {
        split_.mesh.points = mesh.points;
        add_rim_points(mesh, normal, section);

        std::vector<char> is_split(mesh.triangles.size(), 0);
        for (const int triangle : section.triangles)
            is_split[at(triangle)] = 1;
        for (std::size_t triangle = 0; triangle < mesh.triangles.size(); ++triangle) {
            if (!is_split[triangle]) split_.mesh.triangles.push_back(mesh.triangles[triangle]);
        }
        for (const int triangle : section.triangles)
            split(mesh.triangles[at(triangle)]);
    }

    SplitMesh result() && { return std::move(split_); }

private:
    void add_rim_points(const TriangleMesh& mesh, const Vec3& normal, const Section& section)
    {
        std::map<int, double> shortest_edge;
        for (const int triangle : section.triangles) {
            const Corners& corners = mesh.triangles[at(triangle)];
            for (std::size_t k = 0; k < 3; ++k) {
                const int a = corners[k], b = corners[(k + 1) % 3];
                const double length = (mesh.points[at(b)] - mesh.points[at(a)]).norm();
                for (const int end : {a, b}) {
                    double& shortest = shortest_edge.try_emplace(end, length).first->second;
                    shortest = std::min(shortest, length);
                }
            }
        }
        for (const auto& [point, length] : shortest_edge) {
            constexpr double share_of_edge = 0.1;
            if (!(std::abs(heights_(point)) < share_of_edge * length)) continue;
            is_moved_[at(point)] = 1;
            split_.mesh.points[at(point)] -= heights_(point) * normal;
        }
        for (const Edge& edge : section.exits) {
            const auto& [a, b] = edge;
            int& rim_point = rim_point_[edge];
            if (is_moved_[at(a)]) {
                rim_point = a;
            } else if (is_moved_[at(b)]) {
                rim_point = b;
            } else {
                rim_point = static_cast<int>(split_.mesh.points.size());
                split_.mesh.points.push_back(crossing_point(mesh, heights_, edge));
            }
        }
    }

    void split(const Corners& corners)
    {
        std::size_t k = 0;  // the corner that is alone on its side
        while (heights_.crosses(corners[(k + 1) % 3], corners[(k + 2) % 3]))
            ++k;
        const int alone = corners[k], next = corners[(k + 1) % 3], last = corners[(k + 2) % 3];
        const int p = rim_point_.at(edge_between(alone, next));
        const int q = rim_point_.at(edge_between(alone, last));
        append({alone, p, q});
        append({p, next, last, q});
        if (p == q) return;
        const auto [from, to] = heights_.beyond(alone) ? std::pair(p, q) : std::pair(q, p);
        // A strip of no width between two moved points has the same edge on both of its sides.
        if (split_.rim.erase({to, from}) == 0) split_.rim.insert({from, to});
    }

    /// Adds a triangle or a quadrilateral, in which equal corners count once.
    void append(std::vector<int> polygon)
    {
        polygon.erase(std::unique(polygon.begin(), polygon.end()), polygon.end());
        if (polygon.front() == polygon.back()) polygon.pop_back();
        if (polygon.size() == 4) {
            const auto distance = [&](std::size_t i, std::size_t j) {
                return (split_.mesh.points[at(polygon[i])] - split_.mesh.points[at(polygon[j])])
                    .norm();
            };
            // Along the shorter diagonal the triangles are the rounder ones.
            if (distance(1, 3) < distance(0, 2)) {
                std::rotate(polygon.begin(), polygon.begin() + 1, polygon.end());
            }
        }
        for (std::size_t k = 2; k < polygon.size(); ++k) {
            split_.mesh.triangles.push_back({polygon[0], polygon[k - 1], polygon[k]});
        }
    }

    const Heights& heights_;
    std::vector<char> is_moved_;
    std::map<Edge, int> rim_point_;
    SplitMesh split_;
};

/// The triangles at the rim, on one of its sides.
std::vector<int> triangles_at_rim(const SplitMesh& split, bool beyond)
{
    std::vector<int> found;
    for (std::size_t triangle = 0; triangle < split.mesh.triangles.size(); ++triangle) {
        const Corners& corners = split.mesh.triangles[triangle];
        for (std::size_t k = 0; k < 3; ++k) {
            const int from = corners[k], to = corners[(k + 1) % 3];
            if (!split.rim.contains(beyond ? std::pair(from, to) : std::pair(to, from))) continue;
            found.push_back(static_cast<int>(triangle));
            break;
        }
    }
    return found;
}

/// Marks the triangles that are connected to those beyond the rim, other than across it.
std::vector<char> connected_beyond(const SplitMesh& split)
{
    const std::vector<std::array<int, 3>> adjacent = neighbours(split.mesh);
    std::vector<char> is_reached(split.mesh.triangles.size(), 0);
    std::vector<int> front = triangles_at_rim(split, true);
    for (const int triangle : front)
        is_reached[at(triangle)] = 1;
    while (!front.empty()) {
        const int triangle = front.back();
        front.pop_back();
        const Corners& corners = split.mesh.triangles[at(triangle)];
        for (std::size_t k = 0; k < 3; ++k) {
            const int neighbour = adjacent[at(triangle)][k];
            if (neighbour < 0 || is_reached[at(neighbour)]) continue;
            const int from = corners[k], to = corners[(k + 1) % 3];
            if (split.rim.contains({from, to}) || split.rim.contains({to, from})) continue;
            is_reached[at(neighbour)] = 1;
            front.push_back(neighbour);
        }
    }
    return is_reached;
}

}  // namespace

PlaneCut cut_across(const TriangleMesh& mesh, const Vec3& point, const Vec3& normal)
{
    const Heights heights(mesh, point, normal);
    const std::vector<Section> sections = closed_sections(mesh, heights);
    const Section* around_point = nullptr;
    PolygonView innermost;
    for (const Section& section : sections) {
        std::vector<Vec3> polygon;
        for (const Edge& edge : section.exits)
            polygon.push_back(crossing_point(mesh, heights, edge));
        const PolygonView view = view_of(polygon, point, normal);
        if (!(view.turns > 0.5)) continue;
        if (around_point != nullptr && !(view.area < innermost.area)) continue;
        around_point = &section;
        innermost = view;
    }
    if (around_point == nullptr) {
        throw GeometryError(
            fmt::format("no closed section of the surface encloses {}", place_text(point)));
    }

    const SplitMesh split = Splitter(mesh, heights, normal, *around_point).result();
    if (split.rim.size() < 3) {
        throw GeometryError(
            fmt::format("the section of the surface around {} is smaller than a triangle of it",
                        place_text(point)));
    }
    const std::vector<char> is_beyond = connected_beyond(split);
    const std::vector<int> behind = triangles_at_rim(split, false);
    const bool hangs_together = std::any_of(
        behind.begin(), behind.end(), [&](int triangle) { return is_beyond[at(triangle)] != 0; });
    if (hangs_together) {
        throw GeometryError(fmt::format(
            "cut across at {}, the surface is still in one part: the vessel runs in a ring",
            place_text(point)));
    }
    std::vector<int> kept, removed;
    for (std::size_t triangle = 0; triangle < is_beyond.size(); ++triangle) {
        (is_beyond[triangle] ? removed : kept).push_back(static_cast<int>(triangle));
    }
    return {submesh(split.mesh, kept), submesh(split.mesh, removed), innermost.area,
            innermost.centre};
}

}  // namespace braidzone
