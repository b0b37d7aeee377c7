#include "deploy/ring_planes.hpp"
#include "support/bent_tube.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace braidzone {
namespace {

constexpr double least = 20e-6;

/// Rings on an arc, distal first, `step` apart in angle, between straight ends of `straight` rings.
std::vector<CrossSection> rings_on_arc(double bend_radius, double step, int num_gaps, int straight)
{
    const test::BentTube bend{.bend_radius = bend_radius, .angle = step * num_gaps};
    std::vector<CrossSection> rings;
    const auto add_straight = [&](CrossSection section, int first, int end) {
        const Vec3 start = section.origin;
        for (int i = first; i > end; --i) {
            section.origin = start + i * step * bend_radius * section.tangent;
            rings.push_back(section);
        }
    };
    add_straight(bend.section(bend.angle), straight, 0);
    for (int gap = num_gaps; gap >= 0; --gap)
        rings.push_back(bend.section(step * gap));
    add_straight(bend.section(0.0), -1, -1 - straight);
    return rings;
}

std::vector<Vec3> normals_within(const std::vector<CrossSection>& rings, double reach,
                                 double least_gap)
{
    const std::vector<double> reaches(rings.size() - 1, reach);
    return uncrossed_normals(rings, reaches, std::vector<double>(reaches.size(), least_gap));
}

/// The least distance of a node on the inner side, at the reach from its hub, to the planes beside.
double least_distance(const std::vector<CrossSection>& rings, const std::vector<Vec3>& normals,
                      double reach)
{
    double nearest = 1.0;
    for (std::size_t k = 0; k + 1 < rings.size(); ++k) {
        const Vec3 turn = normals[k] - normals[k + 1];
        for (const bool distal : {true, false}) {
            const std::size_t own = distal ? k : k + 1, other = distal ? k + 1 : k;
            Vec3 inwards = turn - turn.dot(normals[own]) * normals[own];
            if (!(inwards.norm() > 1e-9)) continue;
            const Vec3 node = rings[own].origin + reach * inwards.normalized();
            nearest = std::min(nearest, std::abs((node - rings[other].origin).dot(normals[other])));
        }
    }
    return nearest;
}

}  // namespace

// Planes at a step d of a bend of radius R turn by 2 sin(d/2), and their hubs are 2 R sin(d/2) cos
// (d/2) apart along the normals: at the reach r their distance is 2 sin(d/2) (R cos(d/2) - r).
TEST(UncrossedNormals, AreTheTangentsUntilPlanesTouch)
{
    const double bend_radius = 2e-3, step = 0.05, reach = 1.6e-3;
    const double distance =
        2.0 * std::sin(0.5 * step) * (bend_radius * std::cos(0.5 * step) - reach);
    const std::vector<CrossSection> rings = rings_on_arc(bend_radius, step, 30, 20);
    const std::vector<Vec3> apart = normals_within(rings, reach, distance * (1.0 - 1e-9));
    for (std::size_t k = 0; k < rings.size(); ++k)
        EXPECT_EQ(apart[k], rings[k].tangent) << k;
    const std::vector<Vec3> touching = normals_within(rings, reach, 1.02 * distance);
    double tilt = 0.0;
    for (std::size_t k = 0; k < rings.size(); ++k)
        tilt = std::max(tilt, (touching[k] - rings[k].tangent).norm());
    EXPECT_GT(tilt, 1e-3);
}

// A quarter circle as tight as the lumen is wide, all of it too tight: each plane turns by
// (h cos(lag) - g) / r, the middle one stays across the vessel, and what the planes lag behind at
// one end they are ahead by at the other.
TEST(UncrossedNormals, TurnByWhatTheWiresLeave)
{
    const double radius = 1.8e-3, step = 0.06;
    const int num_gaps = 26;
    const std::vector<CrossSection> rings = rings_on_arc(radius, step, num_gaps, 0);
    const std::vector<Vec3> normals = normals_within(rings, radius, least);
    const double chord = 2.0 * radius * std::sin(0.5 * step);
    double lag = 0.0;  // of the planes behind the middle one
    for (int k = num_gaps / 2; k < num_gaps; ++k) {
        const Vec3& here = normals[static_cast<std::size_t>(k)];
        const Vec3& next = normals[static_cast<std::size_t>(k + 1)];
        const double turn = (here - next).norm();
        // The hubs' step stands between the two tangents, from which both normals lag.
        const double mean_lag = lag + 0.5 * (step - turn);
        EXPECT_NEAR(turn, (chord * std::cos(mean_lag) - least) / radius, 1e-3 * turn) << k;
        lag += step - turn;
        EXPECT_NEAR((next - rings[static_cast<std::size_t>(k + 1)].tangent).norm(), lag,
                    0.01 * lag);
    }
    EXPECT_GT(lag, 0.1);
    EXPECT_LT((normals[num_gaps / 2] - rings[num_gaps / 2].tangent).norm(), 1e-6);
    const auto last = static_cast<std::size_t>(num_gaps);
    EXPECT_NEAR((normals[0] - rings[0].tangent).norm(),
                (normals[last] - rings[last].tangent).norm(), 1e-6);
}

// In straight ends planes give back what they lag behind, and none comes too near.
TEST(UncrossedNormals, LetNoNodeNearTheNextPlane)
{
    const double radius = 1.8e-3;
    const std::vector<CrossSection> rings = rings_on_arc(radius, 0.06, 52, 60);
    const std::vector<Vec3> normals = normals_within(rings, radius, least);
    EXPECT_GT(least_distance(rings, normals, radius), 0.95 * least);
    EXPECT_LT((normals.front() - rings.front().tangent).norm(), 1e-3);
    // Planes across the vessel meet at the bend's centre.
    std::vector<Vec3> tangents;
    for (const CrossSection& ring : rings)
        tangents.push_back(ring.tangent);
    EXPECT_LT(least_distance(rings, tangents, radius), 0.2 * least);
}

// To first order in a change of the bend: the normals' differences halve with the change.
TEST(UncrossedNormals, FollowTheVesselSmoothly)
{
    const auto at = [](double bend_radius) {
        return normals_within(rings_on_arc(bend_radius, 0.06, 26, 20), 1.8e-3, least);
    };
    const double whole = 2e-6;
    const std::vector<Vec3> base = at(1.9e-3), half = at(1.9e-3 + 0.5 * whole),
                            far = at(1.9e-3 + whole);
    double bent = 0.0, moved = 0.0;
    for (std::size_t k = 0; k < base.size(); ++k) {
        bent = std::max(bent, (base[k] - 2.0 * half[k] + far[k]).norm());
        moved = std::max(moved, (far[k] - base[k]).norm());
    }
    EXPECT_GT(moved, 1e-5);
    EXPECT_LT(bent, 0.02 * moved);
}

// The wall of the bend is 1.8 mm away on its inner side, a prism of 96 sides; a device of less than
// that reaches as far as it is wide.
TEST(InnerReaches, EndAtTheWallOrAtTheDevice)
{
    const test::BentTube bend{.radius = 1.8e-3, .bend_radius = 4e-3, .angle = 1.5};
    const WallTree wall(bend.vessel());
    const std::vector<CrossSection> rings = [&] {
        std::vector<CrossSection> all;
        for (int k = 30; k >= 10; --k)
            all.push_back(bend.section(0.0375 * k));
        return all;
    }();
    for (const double reach : inner_reaches(rings, wall, 2.2e-3))
        EXPECT_NEAR(reach, 1.8e-3, 0.002e-3);
    for (const double reach : inner_reaches(rings, wall, 1.5e-3))
        EXPECT_NEAR(reach, 1.5e-3, 1e-9);
}

// Frames stay right-handed, hubs where they are, and a ring is not turned about its own normal: the
// axis of the least rotation from the old normal to the new one keeps its place in the ring.
TEST(UncrossedRings, TurnAboutTheirHubs)
{
    const test::BentTube bend{.radius = 1.8e-3, .bend_radius = 1.9e-3, .angle = 2.4};
    const WallTree wall(bend.vessel());
    std::vector<CrossSection> rings;
    for (int k = 38; k >= 2; --k)
        rings.push_back(bend.section(0.06 * k));
    const std::vector<CrossSection> turned =
        uncrossed_rings(rings, wall, 2e-3, std::vector<double>(rings.size() - 1, least));
    double tilt = 0.0;
    for (std::size_t k = 0; k < rings.size(); ++k) {
        EXPECT_EQ(turned[k].origin, rings[k].origin);
        EXPECT_LT((turned[k].tangent.cross(turned[k].normal) - turned[k].binormal).norm(), 1e-12);
        EXPECT_NEAR(turned[k].normal.norm(), 1.0, 1e-12);
        const Vec3 axis = rings[k].tangent.cross(turned[k].tangent);
        tilt = std::max(tilt, axis.norm());
        EXPECT_NEAR(axis.dot(rings[k].normal), axis.dot(turned[k].normal), 1e-12);
        EXPECT_NEAR(axis.dot(rings[k].binormal), axis.dot(turned[k].binormal), 1e-12);
    }
    EXPECT_GT(tilt, 0.05);
}

TEST(UncrossedRings, AreTheSameBytesInAGentleBend)
{
    const test::BentTube bend{.radius = 1.8e-3, .bend_radius = 5e-3, .angle = 1.5};
    const WallTree wall(bend.vessel());
    std::vector<CrossSection> rings;
    for (int k = 30; k >= 10; --k)
        rings.push_back(bend.section(0.03 * k));
    const std::vector<CrossSection> same =
        uncrossed_rings(rings, wall, 2e-3, std::vector<double>(rings.size() - 1, least));
    for (std::size_t k = 0; k < rings.size(); ++k) {
        EXPECT_EQ(same[k].tangent, rings[k].tangent);
        EXPECT_EQ(same[k].normal, rings[k].normal);
        EXPECT_EQ(same[k].binormal, rings[k].binormal);
    }
}

}  // namespace braidzone
