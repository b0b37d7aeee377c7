#include "porous/voxel_wall_distance.hpp"

#include "core/mesh_topology.hpp"
#include "core/wall_tree.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>

namespace braidzone {

namespace {

constexpr int edge = VoxelCubes::edge;

/// Voxels from a triangle within which every voxel is measured against it.
constexpr double exact_band = 1.0;

/// The nearest triangle known so far.
struct Candidate {
    double distance = std::numeric_limits<double>::infinity();
    int triangle = -1;
};

/// A triangle prepared for distances: its plane with axes along the first edge (u), across it (v)
/// and normal (n), in which the corners are (0, 0), (length, 0) and (x, y); a sphere about it.
struct Facet {
    Vec3 corner = Vec3::Zero();
    Vec3 u = Vec3::Zero(), v = Vec3::Zero(), n = Vec3::Zero();
    double length = 0.0, x = 0.0, y = 0.0;
    std::array<double, 3> inverse_squares{};  ///< 1 / squared length of each side, 0 for none
    Vec3 middle = Vec3::Zero();
    double radius = 0.0;
};

Facet make_facet(const TriangleMesh& mesh, std::size_t triangle)
{
    const auto point = [&](std::size_t i) {
        return mesh.points[static_cast<std::size_t>(mesh.triangles[triangle][i])];
    };
    const Vec3 edge1 = point(1) - point(0), edge2 = point(2) - point(0);
    Facet facet;
    facet.corner = point(0);
    facet.u = edge1.normalized();
    facet.n = edge1.cross(edge2).normalized();
    facet.v = facet.n.cross(facet.u);
    facet.length = edge1.norm();
    facet.x = edge2.dot(facet.u);
    facet.y = edge2.dot(facet.v);
    const auto inverse = [](const Vec3& side) {
        return side.squaredNorm() > 0.0 ? 1.0 / side.squaredNorm() : 0.0;
    };
    facet.inverse_squares = {inverse(edge1), inverse(edge2 - edge1), inverse(edge2)};
    facet.middle = (point(0) + point(1) + point(2)) / 3.0;
    for (std::size_t i = 0; i < 3; ++i)
        facet.radius = std::max(facet.radius, (point(i) - facet.middle).norm());
    return facet;
}

/// Squared distance, in a plane, of the point (px, py) from the segment from the origin to (x, y).
double squared_distance_to_segment(double px, double py, double x, double y, double inverse_square)
{
    const double part = std::clamp((px * x + py * y) * inverse_square, 0.0, 1.0);
    const double dx = px - part * x, dy = py - part * y;
    return dx * dx + dy * dy;
}

/// Squared distance of a point from a triangle. In the plane, the nearest point is the foot if it
/// lies on the inner side of every edge, else on one of the edges whose outer side it is on.
double squared_distance(const Vec3& point, const Facet& facet)
{
    const Vec3 offset = point - facet.corner;
    const double px = offset.dot(facet.u), py = offset.dot(facet.v), height = offset.dot(facet.n);
    const double x = facet.x, y = facet.y, length = facet.length;
    double nearest = std::numeric_limits<double>::infinity();
    if (py < 0.0)
        nearest = squared_distance_to_segment(px, py, length, 0.0, facet.inverse_squares[0]);
    if ((x - length) * py - y * (px - length) < 0.0)
        nearest = std::min(nearest, squared_distance_to_segment(px - length, py, x - length, y,
                                                                facet.inverse_squares[1]));
    if (y * px - x * py < 0.0)
        nearest =
            std::min(nearest, squared_distance_to_segment(px, py, x, y, facet.inverse_squares[2]));
    const bool is_above = nearest == std::numeric_limits<double>::infinity();
    return height * height + (is_above ? 0.0 : nearest);
}

/// The part of a triangle that a point is nearest to.
struct Foot {
    double squared_distance = std::numeric_limits<double>::infinity();
    Vec3 offset = Vec3::Zero();  ///< of the point from its foot
    int side = -1;               ///< 0: from corner 0 to 1, 1: from 1 to 2, 2: from 2 to 0
    int corner = -1;             ///< 0, 1, 2; neither side nor corner: the face
};

/// The foot on one side of a triangle.
Foot foot_on_side(const Vec3& offset, const Vec3& along, double squared_length, int side)
{
    const double part = squared_length > 0.0 ? offset.dot(along) / squared_length : 0.0;
    Foot foot;
    foot.offset = offset - std::clamp(part, 0.0, 1.0) * along;
    foot.squared_distance = foot.offset.squaredNorm();
    if (part <= 0.0) {
        foot.corner = side;
    } else if (part >= 1.0) {
        foot.corner = (side + 1) % 3;
    } else {
        foot.side = side;
    }
    return foot;
}

Foot foot_on(const TriangleMesh& mesh, int triangle, const Vec3& point)
{
    const auto& corners = mesh.triangles[static_cast<std::size_t>(triangle)];
    const auto corner = [&](std::size_t i) {
        return mesh.points[static_cast<std::size_t>(corners[i])];
    };
    const Vec3 edge1 = corner(1) - corner(0), edge2 = corner(2) - corner(0);
    const Vec3 offset = point - corner(0);
    const double e11 = edge1.squaredNorm(), e12 = edge1.dot(edge2), e22 = edge2.squaredNorm();
    const double d1 = offset.dot(edge1);
    const double d2 = offset.dot(edge2);
    // Barycentric coordinates of the foot point, times the determinant.
    const double determinant = e11 * e22 - e12 * e12;
    const double u = e22 * d1 - e12 * d2;
    const double v = e11 * d2 - e12 * d1;
    if (u >= 0.0 && v >= 0.0 && u + v <= determinant && determinant > 0.0) {
        Foot foot;
        foot.offset = offset - (u * edge1 + v * edge2) / determinant;
        foot.squared_distance = foot.offset.squaredNorm();
        return foot;
    }
    Foot nearest = foot_on_side(offset, edge1, e11, 0);
    const Foot second = foot_on_side(offset - edge1, edge2 - edge1, e11 - 2.0 * e12 + e22, 1);
    const Foot third = foot_on_side(offset - edge2, -edge2, e22, 2);
    if (second.squared_distance < nearest.squared_distance) nearest = second;
    if (third.squared_distance < nearest.squared_distance) nearest = third;
    return nearest;
}

/// Normals by whose sign a point beside the surface is told from one within.
class PseudoNormals {
public:
    explicit PseudoNormals(const TriangleMesh& mesh)
        : mesh_(mesh),
          of_points_(mesh.points.size(), Vec3::Zero()),
          of_sides_(mesh.triangles.size())
    {
        for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
            const Vec3 normal = face_normal(t);
            for (std::size_t corner = 0; corner < 3; ++corner) {
                of_points_[point_index(t, corner)] += angle(t, corner) * normal;
                of_sides_[t][corner] = normal;
            }
        }
        const std::vector<TriangleSide> sides = sorted_sides(mesh);
        for_each_edge(sides, [&](auto first, auto last) {
            Vec3 sum = Vec3::Zero();
            for (auto side = first; side != last; ++side)
                sum += face_normal(static_cast<std::size_t>(side->triangle));
            for (auto side = first; side != last; ++side) {
                const auto t = static_cast<std::size_t>(side->triangle);
                const int start = side->forward ? side->low : side->high;
                for (std::size_t corner = 0; corner < 3; ++corner)
                    if (mesh.triangles[t][corner] == start) of_sides_[t][corner] = sum;
            }
        });
    }

    bool is_within(const Foot& foot, int triangle) const
    {
        const auto t = static_cast<std::size_t>(triangle);
        Vec3 normal;
        if (foot.corner >= 0) {
            normal = of_points_[point_index(t, static_cast<std::size_t>(foot.corner))];
        } else if (foot.side >= 0) {
            normal = of_sides_[t][static_cast<std::size_t>(foot.side)];
        } else {
            normal = face_normal(t);
        }
        return foot.offset.dot(normal) < 0.0;
    }

private:
    std::size_t point_index(std::size_t triangle, std::size_t corner) const
    {
        return static_cast<std::size_t>(mesh_.triangles[triangle][corner]);
    }

    Vec3 face_normal(std::size_t triangle) const
    {
        return area_vector(mesh_, static_cast<int>(triangle)).normalized();
    }

    double angle(std::size_t triangle, std::size_t corner) const
    {
        const Vec3& tip = mesh_.points[point_index(triangle, corner)];
        const Vec3 u = mesh_.points[point_index(triangle, (corner + 1) % 3)] - tip;
        const Vec3 v = mesh_.points[point_index(triangle, (corner + 2) % 3)] - tip;
        return std::atan2(u.cross(v).norm(), u.dot(v));
    }

    const TriangleMesh& mesh_;
    std::vector<Vec3> of_points_;
    std::vector<std::array<Vec3, 3>> of_sides_;
};

/// For each triangle, the triangles that share a corner with it: those of triangle t are
/// `triangles[first[t]]` up to `triangles[first[t + 1]]`.
struct Neighbours {
    std::vector<std::size_t> first;
    std::vector<int> triangles;
};

Neighbours neighbours_by_corner(const TriangleMesh& mesh)
{
    std::vector<std::vector<int>> triangles_of_point(mesh.points.size());
    for (std::size_t triangle = 0; triangle < mesh.triangles.size(); ++triangle) {
        for (const int point : mesh.triangles[triangle]) {
            triangles_of_point[static_cast<std::size_t>(point)].push_back(
                static_cast<int>(triangle));
        }
    }
    Neighbours neighbours{{0}, {}};
    std::vector<int> around;
    for (std::size_t triangle = 0; triangle < mesh.triangles.size(); ++triangle) {
        around.clear();
        for (const int point : mesh.triangles[triangle]) {
            const std::vector<int>& fan = triangles_of_point[static_cast<std::size_t>(point)];
            around.insert(around.end(), fan.begin(), fan.end());
        }
        std::sort(around.begin(), around.end());
        around.erase(std::unique(around.begin(), around.end()), around.end());
        std::erase(around, static_cast<int>(triangle));
        neighbours.triangles.insert(neighbours.triangles.end(), around.begin(), around.end());
        neighbours.first.push_back(neighbours.triangles.size());
    }
    return neighbours;
}

/// An opening's cap with room around it: a flat cylinder.
struct CapRegion {
    Vec3 centre, normal;
    double radius, half_height;
};

/// True within `room` of a cap's region.
bool is_near(const CapRegion& cap, const Vec3& point, double room)
{
    const Vec3 offset = point - cap.centre;
    const double radius = cap.radius + room;
    return offset.squaredNorm() < radius * radius &&
           std::abs(offset.dot(cap.normal)) < cap.half_height + room;
}

/// Voxels around a triangle.
struct VoxelRange {
    std::array<int, 3> first{}, last{};
};

/// For each held cube, the triangles that are scanned in it: those of slot s are
/// `triangles[first[s]]` up to `triangles[first[s + 1]]`.
struct TrianglesOfCubes {
    std::vector<std::size_t> first;
    std::vector<int> triangles;
};

/// The 13 neighbours with a smaller index, nearest first.
constexpr std::array<std::array<int, 3>, 13> earlier_neighbours{{{-1, 0, 0},
                                                                 {0, -1, 0},
                                                                 {0, 0, -1},
                                                                 {-1, -1, 0},
                                                                 {1, -1, 0},
                                                                 {-1, 0, -1},
                                                                 {1, 0, -1},
                                                                 {0, -1, -1},
                                                                 {0, 1, -1},
                                                                 {-1, -1, -1},
                                                                 {1, -1, -1},
                                                                 {-1, 1, -1},
                                                                 {1, 1, -1}}};

constexpr std::array<std::array<int, 3>, 6> face_neighbours{
    {{-1, 0, 0}, {0, -1, 0}, {0, 0, -1}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};

class WallDistance {
public:
    WallDistance(const VoxelGrid& grid, const Vessel& vessel, CubeMarks& marks)
        : grid_(grid),
          wall_(vessel.wall),
          tree_(vessel),
          neighbours_(neighbours_by_corner(vessel.wall)),
          normals_(vessel.wall)
    {
        facets_.reserve(vessel.wall.triangles.size());
        for (std::size_t triangle = 0; triangle < vessel.wall.triangles.size(); ++triangle) {
            facets_.push_back(make_facet(vessel.wall, triangle));
            ranges_.push_back(range_around(vessel.wall, triangle));
            marks.mark(ranges_.back().first, ranges_.back().last);
        }
        for (const Opening& opening : vessel.openings) {
            caps_.push_back(cap_region(vessel, opening));
            mark_cap(marks, caps_.back());
        }
        field_.cubes = marks.cubes();
    }

    VoxelWallDistance compute()
    {
        const VoxelCubes& cubes = field_.cubes;
        list_triangles();
        middles_.resize(cubes.num_cubes());
        tbb::parallel_for(std::size_t{0}, cubes.held.size(), [&](std::size_t slot) {
            const auto cube = static_cast<std::size_t>(cubes.held[slot]);
            offer(middles_[cube], middle_of(cube), tree_.nearest(middle_of(cube)).triangle);
        });
        field_.of_voxels.resize(cubes.num_held_voxels());
        tbb::parallel_for(std::size_t{0}, cubes.held.size(),
                          [&](std::size_t slot) { fill_cube(slot); });
        fill_other_cubes();
        return std::move(field_);
    }

private:
    using CubeOfCandidates = std::array<Candidate, VoxelCubes::volume>;

    /// Voxels whose centres lie in a box, with the exact band around it; of the cubes, which may
    /// reach over the grid.
    VoxelRange range_of(const Vec3& lower, const Vec3& upper) const
    {
        VoxelRange range;
        for (std::size_t a = 0; a < 3; ++a) {
            const auto axis = static_cast<int>(a);
            // Clamped before the conversion: a triangle far off need not fit into an int.
            const double end = (grid_.dims[a] + edge - 1) / edge * edge;
            const double first = (lower[axis] - grid_.origin[axis]) / grid_.spacing - exact_band;
            const double last = (upper[axis] - grid_.origin[axis]) / grid_.spacing + exact_band;
            range.first[a] = static_cast<int>(std::clamp(std::ceil(first), 0.0, end));
            range.last[a] = static_cast<int>(std::clamp(std::floor(last), -1.0, end - 1.0));
        }
        return range;
    }

    VoxelRange range_around(const TriangleMesh& mesh, std::size_t triangle) const
    {
        const auto& corners = mesh.triangles[triangle];
        Vec3 lower = mesh.points[static_cast<std::size_t>(corners[0])], upper = lower;
        for (const int corner : corners) {
            lower = lower.cwiseMin(mesh.points[static_cast<std::size_t>(corner)]);
            upper = upper.cwiseMax(mesh.points[static_cast<std::size_t>(corner)]);
        }
        return range_of(lower, upper);
    }

    /// A cap bounds the lumen as a wall does: no cube that it enters has one side only.
    void mark_cap(CubeMarks& marks, const CapRegion& cap) const
    {
        const double half_diagonal = 0.5 * std::sqrt(3.0) * edge * grid_.spacing;
        const Vec3 reach = Vec3::Constant(std::hypot(cap.radius, cap.half_height));
        const VoxelRange range = range_of(cap.centre - reach, cap.centre + reach);
        for (int k = range.first[2] / edge * edge; k <= range.last[2]; k += edge) {
            for (int j = range.first[1] / edge * edge; j <= range.last[1]; j += edge) {
                for (int i = range.first[0] / edge * edge; i <= range.last[0]; i += edge) {
                    const Vec3 middle =
                        grid_.centre(i, j, k) + Vec3::Constant(0.5 * (edge - 1) * grid_.spacing);
                    if (is_near(cap, middle, half_diagonal)) marks.mark({i, j, k}, {i, j, k});
                }
            }
        }
    }

    CapRegion cap_region(const Vessel& vessel, const Opening& opening) const
    {
        CapRegion cap{opening.centre, opening.normal, 0.0, 0.0};
        for (const int point : opening.rim) {
            const Vec3 offset =
                vessel.wall.points[static_cast<std::size_t>(point)] - opening.centre;
            cap.radius = std::max(cap.radius, offset.norm());
            cap.half_height = std::max(cap.half_height, std::abs(offset.dot(opening.normal)));
        }
        cap.radius += 2.0 * grid_.spacing;
        cap.half_height += 2.0 * grid_.spacing;
        return cap;
    }

    /// True within `room` of any cap's region.
    bool near_cap(const Vec3& point, double room) const
    {
        return std::any_of(caps_.begin(), caps_.end(),
                           [&](const CapRegion& cap) { return is_near(cap, point, room); });
    }

    template <typename Visit>
    void for_each_cube_of(const VoxelRange& range, Visit visit) const
    {
        for (int c = range.first[2] / edge; c * edge <= range.last[2]; ++c)
            for (int b = range.first[1] / edge; b * edge <= range.last[1]; ++b)
                for (int a = range.first[0] / edge; a * edge <= range.last[0]; ++a)
                    visit(static_cast<std::size_t>(
                        field_.cubes.slots[field_.cubes.cube_index(a, b, c)]));
    }

    void list_triangles()
    {
        TrianglesOfCubes& lists = scanned_;
        lists.first.assign(field_.cubes.held.size() + 1, 0);
        for (const VoxelRange& range : ranges_)
            for_each_cube_of(range, [&](std::size_t slot) { ++lists.first[slot + 1]; });
        std::partial_sum(lists.first.begin(), lists.first.end(), lists.first.begin());
        lists.triangles.resize(lists.first.back());
        std::vector<std::size_t> next(lists.first.begin(), lists.first.end() - 1);
        for (std::size_t triangle = 0; triangle < ranges_.size(); ++triangle)
            for_each_cube_of(ranges_[triangle], [&](std::size_t slot) {
                lists.triangles[next[slot]++] = static_cast<int>(triangle);
            });
    }

    Vec3 middle_of(std::size_t cube) const
    {
        const auto& [a, b, c] = field_.cubes.place_of(cube);
        return grid_.centre(edge * a, edge * b, edge * c) +
               Vec3::Constant(0.5 * (edge - 1) * grid_.spacing);
    }

    void offer(Candidate& candidate, const Vec3& point, int triangle) const
    {
        if (triangle < 0 || triangle == candidate.triangle) return;
        const Facet& facet = facets_[static_cast<std::size_t>(triangle)];
        const double reach = candidate.distance + facet.radius;
        if ((point - facet.middle).squaredNorm() >= reach * reach) return;
        const double distance = std::sqrt(squared_distance(point, facet));
        if (distance < candidate.distance) candidate = {distance, triangle};
    }

    /// Goes on from triangle to triangle as long as one that shares a corner is nearer.
    void walk_over_wall(Candidate& candidate, const Vec3& point) const
    {
        for (int before = -1; candidate.triangle != before;) {
            before = candidate.triangle;
            const auto triangle = static_cast<std::size_t>(before);
            for (std::size_t i = neighbours_.first[triangle]; i < neighbours_.first[triangle + 1];
                 ++i) {
                offer(candidate, point, neighbours_.triangles[i]);
            }
        }
    }

    /// Triangles nearest to the middles of a cube and of the held cubes beside it.
    std::vector<int> seeds_of(std::size_t cube) const
    {
        std::vector<int> seeds{middles_[cube].triangle};
        for (const auto& step : face_neighbours) {
            const auto other = beside(cube, step);
            if (other && field_.cubes.slots[*other] != VoxelCubes::not_held)
                seeds.push_back(middles_[*other].triangle);
        }
        std::sort(seeds.begin(), seeds.end());
        seeds.erase(std::unique(seeds.begin(), seeds.end()), seeds.end());
        return seeds;
    }

    /// The cube at a step from another; none beyond the grid.
    std::optional<std::size_t> beside(std::size_t cube, const std::array<int, 3>& step) const
    {
        std::array<int, 3> place = field_.cubes.place_of(cube);
        for (std::size_t axis = 0; axis < 3; ++axis) {
            place[axis] += step[axis];
            if (place[axis] < 0 || place[axis] >= field_.cubes.counts[axis]) return std::nullopt;
        }
        return field_.cubes.cube_index(place[0], place[1], place[2]);
    }

    void fill_cube(std::size_t slot)
    {
        const auto cube = static_cast<std::size_t>(field_.cubes.held[slot]);
        const auto& [a, b, c] = field_.cubes.place_of(cube);
        const std::array<int, 3> corner{edge * a, edge * b, edge * c};
        CubeOfCandidates nearest{};
        scan(nearest, slot, corner);
        hand_on(nearest, cube, corner);
        write_signed(nearest, slot, corner);
    }

    /// Measures the voxels within the exact band of each triangle.
    void scan(CubeOfCandidates& nearest, std::size_t slot, const std::array<int, 3>& corner) const
    {
        // A little more than the band, so that round-off does not leave out a voxel at its edge.
        const double reach = 1.01 * exact_band * grid_.spacing;
        for (std::size_t n = scanned_.first[slot]; n < scanned_.first[slot + 1]; ++n) {
            const int triangle = scanned_.triangles[n];
            const Facet& facet = facets_[static_cast<std::size_t>(triangle)];
            const VoxelRange& range = ranges_[static_cast<std::size_t>(triangle)];
            std::array<int, 3> first{}, last{};
            for (std::size_t axis = 0; axis < 3; ++axis) {
                first[axis] = std::max(range.first[axis], corner[axis]);
                last[axis] = std::min(range.last[axis], corner[axis] + edge - 1);
            }
            for (int k = first[2]; k <= last[2]; ++k) {
                for (int j = first[1]; j <= last[1]; ++j) {
                    for (int i = first[0]; i <= last[0]; ++i) {
                        const Vec3 centre = grid_.centre(i, j, k);
                        if (std::abs((centre - facet.corner).dot(facet.n)) > reach) continue;
                        offer(nearest[VoxelCubes::place_in_cube(i, j, k)], centre, triangle);
                    }
                }
            }
        }
    }

    /// Gives the voxels beyond the exact band a triangle: that of a voxel beside them, once from
    /// below and once from above, or a seed, which enters at the cube's corners.
    void hand_on(CubeOfCandidates& nearest, std::size_t cube,
                 const std::array<int, 3>& corner) const
    {
        const std::vector<int> seeds = seeds_of(cube);
        const auto take = [&](int i, int j, int k, int step) {
            Candidate& voxel = nearest[VoxelCubes::place_in_cube(i, j, k)];
            if (voxel.distance <= exact_band * grid_.spacing) return;
            const Vec3 centre = grid_.centre(corner[0] + i, corner[1] + j, corner[2] + k);
            const auto from = [&](int ii, int jj, int kk) {
                offer(voxel, centre, nearest[VoxelCubes::place_in_cube(ii, jj, kk)].triangle);
            };
            const auto is_inside = [&](int index) {
                return index + step >= 0 && index + step < edge;
            };
            if (is_inside(i)) from(i + step, j, k);
            if (is_inside(j)) from(i, j + step, k);
            if (is_inside(k)) from(i, j, k + step);
            if (step > 0) return;
            const auto is_walker = [](int index) { return index % 2 == 0 || index == edge - 1; };
            if (!is_walker(i) || !is_walker(j) || !is_walker(k)) return;
            for (const int triangle : seeds)
                offer(voxel, centre, triangle);
            walk_over_wall(voxel, centre);
        };
        for (int k = 0; k < edge; ++k)
            for (int j = 0; j < edge; ++j)
                for (int i = 0; i < edge; ++i)
                    take(i, j, k, -1);
        for (int k = edge - 1; k >= 0; --k)
            for (int j = edge - 1; j >= 0; --j)
                for (int i = edge - 1; i >= 0; --i)
                    take(i, j, k, 1);
    }

    /// Distance that a voxel certainly has from the wall, in voxels.
    double certain_distance(const Candidate& voxel) const
    {
        return std::min(voxel.distance / grid_.spacing, exact_band);
    }

    void write_signed(const CubeOfCandidates& nearest, std::size_t slot,
                      const std::array<int, 3>& corner)
    {
        std::array<char, VoxelCubes::volume> in_lumen{};
        const bool has_cap = near_cap(grid_.centre(corner[0], corner[1], corner[2]) +
                                          Vec3::Constant(0.5 * (edge - 1) * grid_.spacing),
                                      edge * grid_.spacing);
        float* distances = field_.of_voxels.data() + slot * VoxelCubes::volume;
        for (int k = 0; k < edge; ++k) {
            for (int j = 0; j < edge; ++j) {
                for (int i = 0; i < edge; ++i) {
                    const std::size_t place = VoxelCubes::place_in_cube(i, j, k);
                    const Vec3 centre = grid_.centre(corner[0] + i, corner[1] + j, corner[2] + k);
                    const bool within = has_cap && near_cap(centre, 0.0)
                                            ? tree_.contains(centre)
                                            : is_in_lumen(nearest, in_lumen, centre, i, j, k);
                    in_lumen[place] = within ? 1 : 0;
                    const double distance = nearest[place].distance;
                    distances[place] = static_cast<float>(in_lumen[place] ? -distance : distance);
                }
            }
        }
    }

    /// Side of a voxel away from caps: by the nearest part of the wall if that is certain, else
    /// that of an earlier neighbour in its cube if no wall can lie between.
    bool is_in_lumen(const CubeOfCandidates& nearest,
                     const std::array<char, VoxelCubes::volume>& in_lumen, const Vec3& centre,
                     int i, int j, int k) const
    {
        const Candidate& voxel = nearest[VoxelCubes::place_in_cube(i, j, k)];
        if (voxel.distance <= exact_band * grid_.spacing) {
            return normals_.is_within(foot_on(wall_, voxel.triangle, centre), voxel.triangle);
        }
        for (const auto& [di, dj, dk] : earlier_neighbours) {
            const int ii = i + di, jj = j + dj, kk = k + dk;
            if (ii < 0 || jj < 0 || kk < 0 || ii >= edge || jj >= edge) continue;
            const std::size_t other = VoxelCubes::place_in_cube(ii, jj, kk);
            const double step = std::sqrt(static_cast<double>(di * di + dj * dj + dk * dk));
            if (certain_distance(voxel) + certain_distance(nearest[other]) > step)
                return in_lumen[other] != 0;
        }
        return tree_.contains(centre);
    }

    /// The cubes that neither wall nor cap enters: each takes the nearest triangle of its
    /// neighbours, once from below and once from above.
    void fill_other_cubes()
    {
        const VoxelCubes& cubes = field_.cubes;
        field_.of_cubes.assign(cubes.num_cubes(), 0.0F);
        const auto take = [&](std::size_t cube, int direction) {
            if (cubes.slots[cube] != VoxelCubes::not_held) return;
            const Vec3 middle = middle_of(cube);
            for (std::array<int, 3> step : earlier_neighbours) {
                for (int& component : step)
                    component *= direction;
                const auto other = beside(cube, step);
                if (other) offer(middles_[cube], middle, middles_[*other].triangle);
            }
            if (middles_[cube].triangle >= 0) walk_over_wall(middles_[cube], middle);
        };
        for (std::size_t cube = 0; cube < cubes.num_cubes(); ++cube)
            take(cube, 1);
        for (std::size_t cube = cubes.num_cubes(); cube-- > 0;)
            take(cube, -1);

        for (std::size_t cube = 0; cube < cubes.num_cubes(); ++cube) {
            if (cubes.slots[cube] != VoxelCubes::not_held) continue;
            const auto distance = static_cast<float>(middles_[cube].distance);
            field_.of_cubes[cube] = is_cube_in_lumen(cube) ? -distance : distance;
        }
    }

    /// Side of a cube that nothing enters: that of an earlier one beside it of which the same
    /// holds.
    bool is_cube_in_lumen(std::size_t cube) const
    {
        for (std::size_t n = 0; n < 3; ++n) {
            const auto other = beside(cube, face_neighbours[n]);
            if (other && field_.cubes.slots[*other] == VoxelCubes::not_held)
                return field_.of_cubes[*other] < 0.0F;
        }
        return tree_.contains(middle_of(cube));
    }

    const VoxelGrid& grid_;
    const TriangleMesh& wall_;
    WallTree tree_;
    Neighbours neighbours_;
    PseudoNormals normals_;
    std::vector<Facet> facets_;
    std::vector<VoxelRange> ranges_;
    std::vector<CapRegion> caps_;
    TrianglesOfCubes scanned_;
    std::vector<Candidate> middles_;  ///< of all cubes
    VoxelWallDistance field_;
};

}  // namespace

float distance_at(const VoxelWallDistance& field, int i, int j, int k)
{
    const std::size_t cube = field.cubes.cube_of(i, j, k);
    if (field.cubes.slots[cube] == VoxelCubes::not_held) return field.of_cubes[cube];
    return field.of_voxels[held_place(field.cubes, i, j, k)];
}

VoxelWallDistance voxel_wall_distance(const VoxelGrid& grid, const Vessel& vessel, CubeMarks marks)
{
    return WallDistance(grid, vessel, marks).compute();
}

}  // namespace braidzone
