#include "porous/voxel_wall_distance.hpp"

#include "core/wall_tree.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace braidzone {

namespace {

/// Voxels from a triangle within which every voxel is measured against it.
constexpr double exact_band = 1.0;
/// Every so many voxels along each axis the nearest triangle is looked up in the tree.
constexpr int coarse_step = 4;
/// Planes of voxels that one task works on; fixed, so that tasks do not depend on the threads.
constexpr int planes_per_slab = 4;

struct Candidate {
    double distance = std::numeric_limits<double>::infinity();
    int triangle = -1;
};

/// A triangle prepared for distances: corner and edges, with their products; centroid and the
/// radius of a sphere about it.
struct Facet {
    Vec3 corner, edge1, edge2;
    double e11, e12, e22;
    Vec3 middle;
    double radius;
};

Facet make_facet(const TriangleMesh& mesh, std::size_t triangle)
{
    const auto point = [&](std::size_t i) {
        return mesh.points[static_cast<std::size_t>(mesh.triangles[triangle][i])];
    };
    const Vec3 edge1 = point(1) - point(0);
    const Vec3 edge2 = point(2) - point(0);
    const Vec3 middle = (point(0) + point(1) + point(2)) / 3.0;
    const double radius = std::max(
        {(point(0) - middle).norm(), (point(1) - middle).norm(), (point(2) - middle).norm()});
    return {point(0), edge1, edge2, edge1.squaredNorm(), edge1.dot(edge2), edge2.squaredNorm(),
            middle,   radius};
}

/// Squared distance of a point, given by its offset, to the segment from the origin along `edge`.
double squared_distance_to_segment(const Vec3& offset, const Vec3& edge, double squared_length)
{
    const double along = squared_length > 0.0 ? offset.dot(edge) / squared_length : 0.0;
    return (offset - std::clamp(along, 0.0, 1.0) * edge).squaredNorm();
}

double squared_distance(const Vec3& point, const Facet& facet)
{
    const Vec3 offset = point - facet.corner;
    const double d1 = offset.dot(facet.edge1);
    const double d2 = offset.dot(facet.edge2);
    // Barycentric coordinates of the foot point, times the determinant.
    const double determinant = facet.e11 * facet.e22 - facet.e12 * facet.e12;
    const double u = facet.e22 * d1 - facet.e12 * d2;
    const double v = facet.e11 * d2 - facet.e12 * d1;
    if (u >= 0.0 && v >= 0.0 && u + v <= determinant && determinant > 0.0) {
        const Vec3 foot = (u * facet.edge1 + v * facet.edge2) / determinant;
        return (offset - foot).squaredNorm();
    }
    const Vec3 third = facet.edge2 - facet.edge1;
    return std::min({squared_distance_to_segment(offset, facet.edge1, facet.e11),
                     squared_distance_to_segment(offset, facet.edge2, facet.e22),
                     squared_distance_to_segment(offset - facet.edge1, third,
                                                 facet.e11 - 2.0 * facet.e12 + facet.e22)});
}

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

class WallDistance {
public:
    WallDistance(const VoxelGrid& grid, const Vessel& vessel)
        : grid_(grid), tree_(vessel), neighbours_(neighbours_by_corner(vessel.wall))
    {
        facets_.reserve(vessel.wall.triangles.size());
        for (std::size_t triangle = 0; triangle < vessel.wall.triangles.size(); ++triangle) {
            facets_.push_back(make_facet(vessel.wall, triangle));
        }
        for (const Opening& opening : vessel.openings) {
            caps_.push_back(cap_region(vessel, opening));
        }
        nearest_.resize(grid.num_voxels());
    }

    std::vector<float> compute()
    {
        scan_around_triangles();
        look_up_coarse_voxels();
        for (int step = coarse_step / 2; step >= 1; step /= 2)
            hand_on_between(step);
        return signed_distances();
    }

private:
    /// Calls task(k) for every plane of voxels, slabs of planes in parallel.
    template <typename Task>
    void for_each_plane(const Task& task) const
    {
        const int num_slabs = (grid_.dims[2] + planes_per_slab - 1) / planes_per_slab;
        tbb::parallel_for(0, num_slabs, [&](int slab) {
            const int end = std::min(grid_.dims[2], (slab + 1) * planes_per_slab);
            for (int k = slab * planes_per_slab; k < end; ++k)
                task(k);
        });
    }

    void offer(Candidate& voxel, const Vec3& centre, int triangle) const
    {
        if (triangle < 0 || triangle == voxel.triangle) return;
        const Facet& facet = facets_[static_cast<std::size_t>(triangle)];
        const double reach = voxel.distance + facet.radius;
        if ((centre - facet.middle).squaredNorm() >= reach * reach) return;
        const double distance = std::sqrt(squared_distance(centre, facet));
        if (distance < voxel.distance) voxel = {distance, triangle};
    }

    /// Goes on from triangle to triangle as long as one that shares a corner is nearer.
    void walk_over_wall(Candidate& voxel, const Vec3& centre) const
    {
        for (int before = -1; voxel.triangle != before;) {
            before = voxel.triangle;
            const auto triangle = static_cast<std::size_t>(before);
            for (std::size_t i = neighbours_.first[triangle]; i < neighbours_.first[triangle + 1];
                 ++i) {
                offer(voxel, centre, neighbours_.triangles[i]);
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

    bool near_cap(const Vec3& point) const
    {
        return std::any_of(caps_.begin(), caps_.end(), [&](const CapRegion& cap) {
            const Vec3 offset = point - cap.centre;
            return offset.squaredNorm() < cap.radius * cap.radius &&
                   std::abs(offset.dot(cap.normal)) < cap.half_height;
        });
    }

    void scan_around_triangles()
    {
        const double h = grid_.spacing;
        struct Range {
            std::array<int, 3> first, last;
        };
        std::vector<Range> ranges(facets_.size());
        for (std::size_t triangle = 0; triangle < facets_.size(); ++triangle) {
            const Facet& facet = facets_[triangle];
            const Vec3 p = (facet.corner - grid_.origin) / h;
            const Vec3 q = p + facet.edge1 / h, r = p + facet.edge2 / h;
            const Vec3 lower = p.cwiseMin(q).cwiseMin(r), upper = p.cwiseMax(q).cwiseMax(r);
            for (int axis = 0; axis < 3; ++axis) {
                const auto a = static_cast<std::size_t>(axis);
                // Clamped before the conversion: a triangle far off need not fit into an int.
                const double end = grid_.dims[a];
                ranges[triangle].first[a] =
                    static_cast<int>(std::clamp(std::ceil(lower[axis] - exact_band), 0.0, end));
                ranges[triangle].last[a] = static_cast<int>(
                    std::clamp(std::floor(upper[axis] + exact_band), -1.0, end - 1.0));
            }
        }
        const int num_slabs = (grid_.dims[2] + planes_per_slab - 1) / planes_per_slab;
        tbb::parallel_for(0, num_slabs, [&](int slab) {
            const int slab_first = slab * planes_per_slab;
            const int slab_last = std::min(grid_.dims[2], slab_first + planes_per_slab) - 1;
            for (std::size_t triangle = 0; triangle < facets_.size(); ++triangle) {
                const auto& [first, last] = ranges[triangle];
                for (int k = std::max(first[2], slab_first); k <= std::min(last[2], slab_last); ++k)
                    for (int j = first[1]; j <= last[1]; ++j)
                        for (int i = first[0]; i <= last[0]; ++i)
                            offer(nearest_[grid_.index(i, j, k)], grid_.centre(i, j, k),
                                  static_cast<int>(triangle));
            }
        });
    }

    void look_up_coarse_voxels()
    {
        for_each_plane([&](int k) {
            if (k % coarse_step != 0) return;
            for (int j = 0; j < grid_.dims[1]; j += coarse_step) {
                for (int i = 0; i < grid_.dims[0]; i += coarse_step) {
                    const Vec3 centre = grid_.centre(i, j, k);
                    offer(nearest_[grid_.index(i, j, k)], centre, tree_.nearest(centre).triangle);
                }
            }
        });
    }

    /// Offers the voxels on multiples of `step` the triangles of their neighbours on multiples of
    /// twice the step. The latter are not changed, so that planes are independent.
    void hand_on_between(int step)
    {
        const int wide = 2 * step;
        for_each_plane([&](int k) {
            if (k % step != 0) return;
            for (int j = 0; j < grid_.dims[1]; j += step) {
                for (int i = 0; i < grid_.dims[0]; i += step) {
                    if (i % wide == 0 && j % wide == 0 && k % wide == 0) continue;
                    Candidate& voxel = nearest_[grid_.index(i, j, k)];
                    const Vec3 centre = grid_.centre(i, j, k);
                    for (int kk = k - k % wide; kk <= k + k % wide; kk += wide)
                        for (int jj = j - j % wide; jj <= j + j % wide; jj += wide)
                            for (int ii = i - i % wide; ii <= i + i % wide; ii += wide)
                                if (is_inside(ii, jj, kk))
                                    offer(voxel, centre,
                                          nearest_[grid_.index(ii, jj, kk)].triangle);
                    walk_over_wall(voxel, centre);
                }
            }
        });
    }

    bool is_inside(int i, int j, int k) const
    {
        return i >= 0 && j >= 0 && k >= 0 && i < grid_.dims[0] && j < grid_.dims[1] &&
               k < grid_.dims[2];
    }

    /// Distance that a voxel certainly has from the wall, in voxels.
    double certain_distance(std::size_t index) const
    {
        return std::min(nearest_[index].distance / grid_.spacing, exact_band);
    }

    std::vector<float> signed_distances() const
    {
        std::vector<char> in_lumen(nearest_.size());
        std::vector<float> distances(nearest_.size());
        const int num_slabs = (grid_.dims[2] + planes_per_slab - 1) / planes_per_slab;
        tbb::parallel_for(0, num_slabs, [&](int slab) {
            const int first_plane = slab * planes_per_slab;
            const int end = std::min(grid_.dims[2], first_plane + planes_per_slab);
            for (int k = first_plane; k < end; ++k) {
                for (int j = 0; j < grid_.dims[1]; ++j) {
                    for (int i = 0; i < grid_.dims[0]; ++i) {
                        const std::size_t index = grid_.index(i, j, k);
                        in_lumen[index] = is_in_lumen(in_lumen, first_plane, i, j, k);
                        const double distance = nearest_[index].distance;
                        distances[index] =
                            static_cast<float>(in_lumen[index] ? -distance : distance);
                    }
                }
            }
        });
        return distances;
    }

    /// Side of a voxel: that of an earlier neighbour in its slab if no wall or cap can lie between.
    char is_in_lumen(const std::vector<char>& in_lumen, int first_plane, int i, int j, int k) const
    {
        const Vec3 centre = grid_.centre(i, j, k);
        if (!near_cap(centre)) {
            const double own = certain_distance(grid_.index(i, j, k));
            for (const auto& [di, dj, dk] : earlier_neighbours) {
                const int ii = i + di, jj = j + dj, kk = k + dk;
                if (kk < first_plane || !is_inside(ii, jj, kk)) continue;
                const std::size_t neighbour = grid_.index(ii, jj, kk);
                const double step = std::sqrt(static_cast<double>(di * di + dj * dj + dk * dk));
                if (own + certain_distance(neighbour) > step) return in_lumen[neighbour];
            }
        }
        return tree_.contains(centre) ? 1 : 0;
    }

    /// The 13 neighbours with a smaller index, nearest first.
    static constexpr std::array<std::array<int, 3>, 13> earlier_neighbours{{{-1, 0, 0},
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

    const VoxelGrid& grid_;
    WallTree tree_;
    std::vector<Facet> facets_;
    Neighbours neighbours_;
    std::vector<CapRegion> caps_;
    std::vector<Candidate> nearest_;
};

}  // namespace

std::vector<float> voxel_wall_distance(const VoxelGrid& grid, const Vessel& vessel)
{
    return WallDistance(grid, vessel).compute();
}

}  // namespace braidzone
