#include "core/error.hpp"
#include "core/wall_tree.hpp"
#include "support/shapes.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

namespace braidzone {
namespace {

constexpr double radius = 2e-3, length = 10e-3;
constexpr int around = 48, along = 30;
/// Radius of the circle within the prism that stands for the tube.
const double inner_radius = radius * std::cos(std::numbers::pi / around);

/// A box of 1 x 1 x 4 mm, open at both ends in z.
Vessel square_channel()
{
    TriangleMesh mesh = test::box(Vec3(0, 0, 0), Vec3(1e-3, 1e-3, 4e-3));
    mesh.triangles.erase(mesh.triangles.begin(), mesh.triangles.begin() + 4);
    return make_vessel(mesh, LengthUnit{"mm", 1e-3});
}

class RandomPoints {
public:
    Vec3 in(const Vec3& lower, const Vec3& upper)
    {
        Vec3 point;
        for (int axis = 0; axis < 3; ++axis) {
            point[axis] = lower[axis] + (upper[axis] - lower[axis]) * uniform_(generator_);
        }
        return point;
    }
    Vec3 near_tube() { return in(Vec3(-1.2, -1.2, -0.2) * radius, Vec3(1.2, 1.2, 5.2) * radius); }

private:
    std::mt19937 generator_{20};
    std::uniform_real_distribution<double> uniform_{0.0, 1.0};
};

/// First crossing by solving for the point in barycentric coordinates, triangle by triangle.
std::optional<double> first_fraction_by_loop(const TriangleMesh& wall, const Vec3& from,
                                             const Vec3& to)
{
    std::optional<double> first;
    for (const auto& [a, b, c] : wall.triangles) {
        const Vec3& corner = wall.points[static_cast<std::size_t>(a)];
        Mat3 matrix;  // corner + u e1 + v e2 = from + t d
        matrix.col(0) = wall.points[static_cast<std::size_t>(b)] - corner;
        matrix.col(1) = wall.points[static_cast<std::size_t>(c)] - corner;
        matrix.col(2) = from - to;
        const Vec3 uvt = matrix.inverse() * (from - corner);
        if (uvt.minCoeff() < 0.0 || uvt[0] + uvt[1] > 1.0 || uvt[2] > 1.0) continue;
        if (!first || uvt[2] < *first) first = uvt[2];
    }
    return first;
}

/// Distance to a triangle: to its plane if the foot lies in it, otherwise to the nearest side.
double distance_to_triangle(const Vec3& p, const std::array<Vec3, 3>& corners)
{
    const Vec3 normal = (corners[1] - corners[0]).cross(corners[2] - corners[0]).normalized();
    bool foot_is_inside = true;
    double to_sides = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < 3; ++k) {
        const Vec3& a = corners[k];
        const Vec3 side = corners[(k + 1) % 3] - a;
        foot_is_inside = foot_is_inside && normal.dot(side.cross(p - a)) >= 0.0;
        const double s = std::clamp(side.dot(p - a) / side.squaredNorm(), 0.0, 1.0);
        to_sides = std::min(to_sides, (a + s * side - p).norm());
    }
    return foot_is_inside ? std::abs(normal.dot(p - corners[0])) : to_sides;
}

double distance_by_loop(const TriangleMesh& wall, const Vec3& point)
{
    double least = std::numeric_limits<double>::infinity();
    for (const auto& [a, b, c] : wall.triangles) {
        least = std::min(least,
                         distance_to_triangle(point, {wall.points[static_cast<std::size_t>(a)],
                                                      wall.points[static_cast<std::size_t>(b)],
                                                      wall.points[static_cast<std::size_t>(c)]}));
    }
    return least;
}

TEST(FirstHit, OnAFlatWallMatchesHandCalculation)
{
    const WallTree wall(square_channel());
    const auto hit = wall.first_hit(Vec3(0.5e-3, 0.25e-3, 1e-3), Vec3(2.5e-3, 0.25e-3, 2e-3));
    ASSERT_TRUE(hit);
    EXPECT_NEAR(hit->fraction, 0.25, 1e-12);  // 0.5 mm of the 2 mm in x
    EXPECT_LT((hit->point - Vec3(1e-3, 0.25e-3, 1.25e-3)).norm(), 1e-15);
    EXPECT_LT((hit->normal - Vec3::UnitX()).norm(), 1e-15);
}

TEST(FirstHit, IsTheFirstOfSeveral)
{
    const WallTree wall(square_channel());
    // Enters at y = 0, leaves at y = 1 mm.
    const auto hit = wall.first_hit(Vec3(0.3e-3, -1e-3, 2.1e-3), Vec3(0.3e-3, 3e-3, 2.1e-3));
    ASSERT_TRUE(hit);
    EXPECT_NEAR(hit->fraction, 0.25, 1e-12);
    EXPECT_LT((hit->normal + Vec3::UnitY()).norm(), 1e-15);
}

TEST(FirstHit, IsNoneForASegmentThatEndsShort)
{
    const WallTree wall(square_channel());
    EXPECT_FALSE(wall.first_hit(Vec3(0.5e-3, 0.5e-3, 1e-3), Vec3(0.999e-3, 0.5e-3, 1e-3)));
    EXPECT_FALSE(wall.first_hit(Vec3(0.5e-3, 0.5e-3, 1e-3), Vec3(0.5e-3, 0.5e-3, 1e-3)));
}

TEST(FirstHit, IsNoneThroughAnOpening)
{
    const WallTree wall(square_channel());
    EXPECT_FALSE(wall.first_hit(Vec3(0.5e-3, 0.4e-3, 1e-3), Vec3(0.5e-3, 0.4e-3, 9e-3)));
}

TEST(FirstHit, DoesNotCountASegmentWithinAWall)
{
    const WallTree wall(square_channel());
    EXPECT_FALSE(wall.first_hit(Vec3(1e-3, 0.2e-3, 1e-3), Vec3(1e-3, 0.8e-3, 2e-3)));
}

TEST(FirstHit, AgreesWithALoopOverAllTriangles)
{
    const Vessel vessel = test::tube_vessel(radius, length, around, along);
    const WallTree wall(vessel);
    RandomPoints random;
    int num_hits = 0;
    for (int k = 0; k < 1000; ++k) {
        const Vec3 from = random.near_tube(), to = random.near_tube();
        const auto expected = first_fraction_by_loop(vessel.wall, from, to);
        const auto hit = wall.first_hit(from, to);
        ASSERT_EQ(hit.has_value(), expected.has_value()) << "segment " << k;
        if (!hit) continue;
        ++num_hits;
        EXPECT_NEAR(hit->fraction, *expected, 1e-10) << "segment " << k;
    }
    EXPECT_GT(num_hits, 300);  // the comparison was not about misses only
    EXPECT_LT(num_hits, 1000);
}

// Each point and each edge's middle, from inside, along the radius and at random slants, both on a
// prism whose points lie on exact multiples of an angle and on one moved off the round numbers.
TEST(FirstHit, NoSegmentSlipsThroughAnEdgeOrAPoint)
{
    RandomPoints random;
    for (const Vec3& offset : {Vec3(0, 0, 0), Vec3(0.0312345, -0.0171717, 0.0298765)}) {
        TriangleMesh mesh = test::tube(radius, length, around, along);
        for (Vec3& point : mesh.points)
            point += offset;
        const Vessel vessel = make_vessel(mesh, LengthUnit{"mm", 1e-3});
        const WallTree wall(vessel);
        for (const std::array<int, 3>& corners : mesh.triangles) {
            for (std::size_t k = 0; k < 3; ++k) {
                const Vec3& a = mesh.points[static_cast<std::size_t>(corners[k])];
                const Vec3& b = mesh.points[static_cast<std::size_t>(corners[(k + 1) % 3])];
                for (const Vec3& target : {a, Vec3(0.5 * (a + b)), Vec3(0.7 * a + 0.3 * b)}) {
                    const double z = target.z() - offset.z();
                    if (z < 1e-6 || z > length - 1e-6) continue;  // the rims have one side only
                    const Vec3 axis_point = offset + Vec3(0, 0, z);
                    const Vec3 slanted = offset + random.in(Vec3(-0.5, -0.5, 0.1) * radius,
                                                            Vec3(0.5, 0.5, 4.9) * radius);
                    for (const Vec3& from : {axis_point, slanted}) {
                        ASSERT_TRUE(wall.first_hit(from, from + 1.5 * (target - from)))
                            << target.transpose();
                    }
                }
            }
        }
    }
}

// A path that is cut at the wall: the first piece ends on it, the second starts there.
TEST(FirstHit, APathCutAtTheWallIsStoppedByOneOfItsPieces)
{
    const WallTree wall(test::tube_vessel(radius, length, around, along));
    RandomPoints random;
    for (int k = 0; k < 20000; ++k) {
        const Vec3 from = random.in(Vec3(-0.5, -0.5, 0.5) * radius, Vec3(0.5, 0.5, 4.5) * radius);
        const Vec3 to = from + random.in(Vec3(-3, -3, -0.2) * radius, Vec3(3, 3, 0.2) * radius);
        const auto hit = wall.first_hit(from, to);
        if (!hit) continue;
        const bool is_stopped = wall.first_hit(from, hit->point) || wall.first_hit(hit->point, to);
        ASSERT_TRUE(is_stopped) << "path " << k;
    }
}

// In the channel's cross-section the nearest wall is that at x = 0.
TEST(Nearest, OnAFlatWallMatchesHandCalculation)
{
    const WallTree wall(square_channel());
    const WallPoint nearest = wall.nearest(Vec3(0.2e-3, 0.5e-3, 2.5e-3));
    EXPECT_NEAR(nearest.distance, 0.2e-3, 1e-18);
    EXPECT_LT((nearest.point - Vec3(0, 0.5e-3, 2.5e-3)).norm(), 1e-18);
    EXPECT_LT((nearest.normal + Vec3::UnitX()).norm(), 1e-15);
}

// Beyond an end the cap does not count: the nearest point lies on the rim.
TEST(Nearest, BeyondAnOpeningIsOnTheRim)
{
    const WallTree wall(square_channel());
    const WallPoint nearest = wall.nearest(Vec3(0.5e-3, 0.5e-3, 4e-3 + 1.2e-3));
    EXPECT_NEAR(nearest.distance, 1.3e-3, 1e-17);  // 0.5 and 1.2: a Pythagorean triple with 1.3
}

// On the axis the prism's sides are at the inner radius.
TEST(Nearest, OnTheAxisOfATubeIsTheInnerRadius)
{
    const WallTree wall(test::tube_vessel(radius, length, around, along));
    EXPECT_NEAR(wall.nearest(Vec3(0, 0, 0.37 * length)).distance, inner_radius, 1e-12 * radius);
}

TEST(Nearest, AgreesWithALoopOverAllTriangles)
{
    const Vessel vessel = test::tube_vessel(radius, length, around, along);
    const WallTree wall(vessel);
    RandomPoints random;
    for (int k = 0; k < 1000; ++k) {
        const Vec3 point = random.near_tube();
        const WallPoint nearest = wall.nearest(point);
        EXPECT_NEAR(nearest.distance, distance_by_loop(vessel.wall, point), 1e-12 * radius);
        EXPECT_NEAR((nearest.point - point).norm(), nearest.distance, 1e-15 * radius);
    }
}

TEST(NearlyNearest, IsOnTheWallAndFartherByTheErrorAtMost)
{
    const WallTree wall(test::tube_vessel(radius, length, around, along));
    RandomPoints random;
    for (int k = 0; k < 500; ++k) {
        const Vec3 point = random.near_tube();
        const double least = wall.nearest(point).distance;
        for (const double error : {0.0, 0.05, 0.5}) {
            const WallPoint found = wall.nearly_nearest(point, error);
            EXPECT_GE(found.distance, least);
            EXPECT_LE((1.0 - error) * found.distance, least * (1.0 + 1e-12));
            EXPECT_NEAR((found.point - point).norm(), found.distance, 1e-15 * radius);
            EXPECT_LT(wall.nearest(found.point).distance, 1e-12 * radius);
        }
    }
}

TEST(NearlyNearest, RefusesErrorsOutOfRange)
{
    const WallTree wall(test::tube_vessel(radius, length, around, along));
    for (const double error : {-0.1, 1.0, std::nan("")})
        EXPECT_THROW(wall.nearly_nearest(Vec3::Zero(), error), InputError) << error;
}

TEST(ComesNearer, AgreesWithTheNearestPoint)
{
    const WallTree wall(test::tube_vessel(radius, 5.0 * radius, 24, 12));
    RandomPoints random;
    int num_nearer = 0;
    for (int i = 0; i < 200; ++i) {
        const Vec3 point = random.near_tube();
        const double distance = 0.3 * radius;
        const bool expected = wall.nearest(point).distance < distance;
        EXPECT_EQ(wall.comes_nearer(point, distance), expected) << i;
        num_nearer += expected;
    }
    EXPECT_GT(num_nearer, 10);
    EXPECT_LT(num_nearer, 190);
}

// The wall at x = 0 of the channel is 0.2 mm away.
TEST(ComesNearer, IsFalseAtTheDistanceItself)
{
    const WallTree wall(square_channel());
    EXPECT_FALSE(wall.comes_nearer(Vec3(0.2e-3, 0.5e-3, 2.5e-3), 0.2e-3));
    EXPECT_TRUE(wall.comes_nearer(Vec3(0.2e-3, 0.5e-3, 2.5e-3), 0.2001e-3));
}

TEST(Within, FindsTheTrianglesThatALoopFinds)
{
    const Vessel vessel = test::tube_vessel(radius, 5.0 * radius, 24, 12);
    const WallTree tree(vessel);
    RandomPoints random;
    std::size_t num_found = 0;
    for (int i = 0; i < 200; ++i) {
        const Vec3 point = random.near_tube();
        const double distance = 0.3 * radius;
        std::vector<int> expected;
        for (int triangle = 0; triangle < static_cast<int>(vessel.wall.triangles.size());
             ++triangle) {
            std::array<Vec3, 3> corners;
            for (std::size_t k = 0; k < 3; ++k) {
                corners[k] = vessel.wall.points[static_cast<std::size_t>(
                    vessel.wall.triangles[static_cast<std::size_t>(triangle)][k])];
            }
            if (distance_to_triangle(point, corners) <= distance) expected.push_back(triangle);
        }
        std::vector<int> found;
        for (const WallPoint& piece : tree.within(point, distance)) {
            found.push_back(piece.triangle);
            EXPECT_NEAR((piece.point - point).norm(), piece.distance, 1e-15);
        }
        EXPECT_EQ(found, expected) << i;
        num_found += found.size();
    }
    EXPECT_GT(num_found, 100U);
}

TEST(Contains, TellsInsideFromOutsideOfATube)
{
    const WallTree wall(test::tube_vessel(radius, length, around, along));
    RandomPoints random;
    for (int k = 0; k < 20000; ++k) {
        const Vec3 point = random.near_tube();
        const double r = point.head<2>().norm();
        if (r > inner_radius && r < radius) continue;  // between the prism and the circle
        const bool is_inside = r <= inner_radius && point.z() > 0.0 && point.z() < length;
        ASSERT_EQ(wall.contains(point), is_inside) << point.transpose();
    }
}

// Points on the axis, level with rows of points: rays towards them would graze edges.
TEST(Contains, IsNotMisledByPointsInLineWithEdges)
{
    const WallTree wall(test::tube_vessel(radius, length, around, along));
    for (int k = 1; k < 10 * along; ++k) {
        const double z = length * k / (10.0 * along);
        EXPECT_TRUE(wall.contains(Vec3(0, 0, z))) << "z = " << z;
        EXPECT_FALSE(wall.contains(Vec3(1.5 * radius, 0, z)));
    }
}

TEST(Contains, IsFalseForNoNumber)
{
    const WallTree wall(square_channel());
    EXPECT_FALSE(wall.contains(Vec3::Constant(std::numeric_limits<double>::quiet_NaN())));
}

TEST(WallTree, OfNoTrianglesIsRefused)
{
    EXPECT_THROW(WallTree(Vessel{}), InputError);
}

TEST(WallTree, CanBeMoved)
{
    WallTree first(square_channel());
    const WallTree second(std::move(first));
    EXPECT_TRUE(second.contains(Vec3(0.5e-3, 0.5e-3, 2e-3)));
}

/// The channel with a plate across half of it at y = 0.6 mm, z from 1 to 3 mm, that faces +y.
WallTree lined_channel()
{
    TriangleMesh plate;
    plate.points = {Vec3(0, 0.6e-3, 1e-3), Vec3(0, 0.6e-3, 3e-3), Vec3(1e-3, 0.6e-3, 3e-3),
                    Vec3(1e-3, 0.6e-3, 1e-3)};
    plate.triangles = {{0, 1, 2}, {0, 2, 3}};
    return WallTree(square_channel(), plate);
}

TEST(Lining, StopsLikeTheWallWithTrianglesNumberedAfterIt)
{
    const WallTree wall = lined_channel();
    const int num_wall_triangles = static_cast<int>(square_channel().wall.triangles.size());
    const auto hit = wall.first_hit(Vec3(0.3e-3, 0.2e-3, 2.5e-3), Vec3(0.3e-3, 1.2e-3, 2.5e-3));
    ASSERT_TRUE(hit);
    EXPECT_NEAR(hit->fraction, 0.4, 1e-12);
    EXPECT_EQ(hit->triangle, num_wall_triangles);  // z - 1 mm above 2 x: the first of the two
    EXPECT_LT((hit->normal - Vec3::UnitY()).norm(), 1e-15);
    // Beyond the plate's end the wall itself stops the segment.
    const auto beyond = wall.first_hit(Vec3(0.3e-3, 0.2e-3, 3.5e-3), Vec3(0.3e-3, 1.2e-3, 3.5e-3));
    ASSERT_TRUE(beyond);
    EXPECT_NEAR(beyond->fraction, 0.8, 1e-12);
    EXPECT_LT(beyond->triangle, num_wall_triangles);
}

TEST(Lining, CarriesLikeTheWall)
{
    const WallTree wall = lined_channel();
    const int num_wall_triangles = static_cast<int>(square_channel().wall.triangles.size());
    const WallPoint nearest = wall.nearest(Vec3(0.5e-3, 0.5e-3, 2.8e-3));
    EXPECT_NEAR(nearest.distance, 0.1e-3, 1e-15);
    EXPECT_GE(nearest.triangle, num_wall_triangles);
    EXPECT_LT((nearest.normal - Vec3::UnitY()).norm(), 1e-15);
    const std::vector<WallPoint> within = wall.within(Vec3(0.5e-3, 0.5e-3, 2.8e-3), 0.15e-3);
    ASSERT_EQ(within.size(), 1U);
    EXPECT_EQ(within[0].triangle, nearest.triangle);
}

TEST(Lining, IsNoBoundaryOfTheLumen)
{
    const WallTree wall = lined_channel();
    EXPECT_TRUE(wall.contains(Vec3(0.3e-3, 0.3e-3, 2e-3)));
    EXPECT_TRUE(wall.contains(Vec3(0.3e-3, 0.8e-3, 2e-3)));
    EXPECT_FALSE(wall.contains(Vec3(0.3e-3, 1.1e-3, 2e-3)));
}

}  // namespace
}  // namespace braidzone
