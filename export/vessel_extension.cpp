#include "export/vessel_extension.hpp"

#include "core/error.hpp"
#include "core/place_text.hpp"
#include "core/surface_check.hpp"
#include "core/wall_tree.hpp"
#include "export/opening_tube.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <optional>
#include <utility>

namespace braidzone {

namespace {

constexpr double largest_turn = 100.0 * std::numbers::pi / 180.0;
constexpr double largest_turn_along_z = 170.0 * std::numbers::pi / 180.0;

/// A way along an axis: 2 axis, and one more for the positive end.
using Way = int;

Vec3 direction_of(Way way)
{
    return (way % 2 == 0 ? -1.0 : 1.0) * Vec3::Unit(way / 2);
}

double angle_between(const Vec3& a, const Vec3& b)
{
    return std::atan2(a.cross(b).norm(), a.dot(b));
}

/// Ways that an opening can take, the least turn first.
std::vector<Way> ways_of(const Opening& opening)
{
    std::vector<Way> ways(6);
    std::iota(ways.begin(), ways.end(), 0);
    const auto turn = [&](Way way) { return angle_between(opening.normal, direction_of(way)); };
    std::stable_sort(ways.begin(), ways.end(), [&](Way a, Way b) { return turn(a) < turn(b); });
    std::erase_if(ways, [&](Way way) { return turn(way) > largest_turn; });
    return ways;
}

double highest_point(const std::vector<Vec3>& points, const Vec3& direction)
{
    double highest = -std::numeric_limits<double>::infinity();
    for (const Vec3& point : points)
        highest = std::max(highest, point.dot(direction));
    return highest;
}

/// How far the rim reaches off the plane across `direction` through its outermost point.
double unevenness(const Vessel& vessel, const Opening& opening, const Vec3& direction)
{
    double lowest = std::numeric_limits<double>::infinity(), highest = -lowest;
    for (const int point : opening.rim) {
        const double height = vessel.wall.points[static_cast<std::size_t>(point)].dot(direction);
        lowest = std::min(lowest, height);
        highest = std::max(highest, height);
    }
    return highest - lowest;
}

/// A vessel with tubes along chosen ways.
struct Draft {
    ExtendedVessel extended;
    std::vector<std::optional<TubeRings>> tubes;  ///< of each opening; none if it stays
    std::vector<int> opening_of;                  ///< of each triangle, -1 on the vessel's own wall
};

Draft draft_of(const Vessel& vessel, const std::vector<Way>& ways, double clearance)
{
    const std::size_t num_openings = vessel.openings.size();
    Draft draft;
    draft.tubes.resize(num_openings);
    std::vector<char> is_flat(num_openings, 0);
    for (std::size_t i = 0; i < num_openings; ++i) {
        const Opening& opening = vessel.openings[i];
        const Vec3 direction = direction_of(ways[i]);
        is_flat[i] = unevenness(vessel, opening, direction) < 1e-6 * opening.radius &&
                     opening.normal.dot(direction) > 0.0;
        if (!is_flat[i]) draft.tubes[i] = bent_tube(vessel, opening, direction, clearance);
    }
    for (Way way = 0; way < 6; ++way) {
        const Vec3 direction = direction_of(way);
        double highest = highest_point(vessel.wall.points, direction);
        for (const auto& tube : draft.tubes) {
            if (!tube) continue;
            for (const auto& ring : tube->rings)
                highest = std::max(highest, highest_point(ring, direction));
        }
        const auto may_stay = [&](std::size_t i) {
            return is_flat[i] && vessel.openings[i].centre.dot(direction) >
                                     highest - 1e-6 * vessel.openings[i].radius;
        };
        bool all_stay = true;
        for (std::size_t i = 0; i < num_openings; ++i)
            all_stay = all_stay && (ways[i] != way || may_stay(i));
        if (all_stay) continue;
        for (std::size_t i = 0; i < num_openings; ++i) {
            if (ways[i] != way) continue;
            if (!draft.tubes[i])
                draft.tubes[i] = bent_tube(vessel, vessel.openings[i], direction, clearance);
            continue_to_plane(*draft.tubes[i], direction, highest + 2.0 * clearance);
        }
    }

    ExtendedVessel& extended = draft.extended;
    extended.vessel = vessel;
    draft.opening_of.assign(vessel.wall.triangles.size(), -1);
    for (std::size_t i = 0; i < num_openings; ++i) {
        if (!draft.tubes[i]) continue;
        Opening& opening = extended.vessel.openings[i];
        const Vec3 direction = direction_of(ways[i]);
        opening.rim = append_tube(extended.vessel.wall, opening.rim, *draft.tubes[i]);
        draft.opening_of.resize(extended.vessel.wall.triangles.size(), static_cast<int>(i));
        extended.tubes.push_back({static_cast<int>(i), direction,
                                  angle_between(vessel.openings[i].normal, direction),
                                  draft.tubes[i]->arc_lengths.back()});
    }
    return draft;
}

/// The wall of one tube as a vessel's, to ask how near it is.
Vessel wall_of(const TubeRings& tube)
{
    Vessel vessel;
    vessel.wall.points = tube.rings.front();
    std::vector<int> rim(tube.rings.front().size());
    std::iota(rim.begin(), rim.end(), 0);
    append_tube(vessel.wall, rim, tube);
    return vessel;
}

/// The openings whose tubes cross a wall, or come nearer to one than the clearance.
std::vector<char> blocked_openings(const Vessel& vessel, const WallTree& wall, const Draft& draft,
                                   double clearance)
{
    const std::size_t num_openings = vessel.openings.size();
    std::vector<char> blocked(num_openings, 0);
    const SurfaceDefects defects = find_defects(draft.extended.vessel.wall);
    for (const auto& pair : defects.intersecting_triangles) {
        for (const int triangle : pair) {
            const int opening = draft.opening_of[static_cast<std::size_t>(triangle)];
            if (opening >= 0) blocked[static_cast<std::size_t>(opening)] = 1;
        }
    }
    for (std::size_t i = 0; i < num_openings; ++i) {
        if (!draft.tubes[i] || blocked[i]) continue;
        const auto comes_near = [&](const WallTree& other, bool joins) {
            const TubeRings& tube = *draft.tubes[i];
            for (std::size_t k = 1; k < tube.rings.size(); ++k) {
                // It leaves its own rim step by step.
                const double distance =
                    joins ? std::min(clearance, 0.5 * tube.arc_lengths[k]) : clearance;
                for (const Vec3& point : tube.rings[k])
                    if (other.comes_nearer(point, distance)) return true;
            }
            return false;
        };
        blocked[i] = comes_near(wall, true);
        for (std::size_t j = 0; j < i && !blocked[i]; ++j) {
            if (!draft.tubes[j]) continue;
            blocked[i] = comes_near(WallTree(wall_of(*draft.tubes[j])), false);
        }
    }
    return blocked;
}

/// Openings' figures at their new place.
void measure(ExtendedVessel& extended, const Vessel& original)
{
    for (const OpeningTube& tube : extended.tubes) {
        const auto index = static_cast<std::size_t>(tube.opening);
        Opening& opening = extended.vessel.openings[index];
        const Opening& before = original.openings[index];
        // The outline is moved and turned, not changed: its centroid goes with any of its points.
        const auto point = [](const Vessel& vessel, const Opening& of) {
            return vessel.wall.points[static_cast<std::size_t>(of.rim.front())];
        };
        const Mat3 turn =
            Eigen::Quaterniond::FromTwoVectors(before.normal, tube.direction).toRotationMatrix();
        Vec3 offset = point(original, before) - before.centre;
        offset -= offset.dot(before.normal) * before.normal;
        opening.centre = point(extended.vessel, opening) - turn * offset;
        opening.normal = tube.direction;
    }
}

[[noreturn]] void fail(const Vessel& vessel, std::size_t opening, const char* where)
{
    throw GeometryError(fmt::format(
        "export.openings: the opening at {} cannot be made flat: a tube from it to {} of the box "
        "would run into the vessel or another tube; cut the vessel elsewhere, turn it, or leave "
        "out the targets that need flat openings",
        place_text(vessel.openings[opening].centre, vessel.unit), where));
}

Draft draft_to_any_face(const Vessel& vessel, const WallTree& wall, double clearance)
{
    std::vector<std::vector<Way>> candidates;
    for (const Opening& opening : vessel.openings)
        candidates.push_back(ways_of(opening));
    std::vector<std::size_t> choice(vessel.openings.size(), 0);
    for (;;) {
        std::vector<Way> ways;
        for (std::size_t i = 0; i < choice.size(); ++i)
            ways.push_back(candidates[i][choice[i]]);
        Draft draft = draft_of(vessel, ways, clearance);
        const std::vector<char> blocked = blocked_openings(vessel, wall, draft, clearance);
        // Of those in the way of each other the smallest, the last one, gives way.
        bool any_blocked = false, moved = false;
        std::size_t stuck = 0;
        for (std::size_t i = choice.size(); i-- > 0 && !moved;) {
            if (!blocked[i]) continue;
            any_blocked = true;
            stuck = i;
            if (choice[i] + 1 == candidates[i].size()) continue;
            ++choice[i];
            moved = true;
        }
        if (!any_blocked) return draft;
        if (!moved) fail(vessel, stuck, "any face");
    }
}

Draft draft_along_z(const Vessel& vessel, const WallTree& wall, std::size_t inlet, double clearance)
{
    constexpr Way lower = 4, upper = 5;
    std::array<std::vector<Way>, 2> choices;
    std::array<double, 2> turns{};
    for (std::size_t choice = 0; choice < 2; ++choice) {
        for (std::size_t i = 0; i < vessel.openings.size(); ++i) {
            const Way way = (i == inlet) == (choice == 0) ? lower : upper;
            choices[choice].push_back(way);
            turns[choice] = std::max(turns[choice],
                                     angle_between(vessel.openings[i].normal, direction_of(way)));
        }
    }
    if (turns[1] < turns[0]) std::swap(choices[0], choices[1]);
    std::size_t stuck = 0;
    for (const std::vector<Way>& ways : choices) {
        const auto turns_back = [&](std::size_t i) {
            return angle_between(vessel.openings[i].normal, direction_of(ways[i])) >
                   largest_turn_along_z;
        };
        std::size_t back = 0;
        while (back < ways.size() && !turns_back(back))
            ++back;
        if (back < ways.size()) {
            stuck = back;
            continue;
        }
        Draft draft = draft_of(vessel, ways, clearance);
        const std::vector<char> blocked = blocked_openings(vessel, wall, draft, clearance);
        const auto first = std::find(blocked.begin(), blocked.end(), 1);
        if (first == blocked.end()) return draft;
        stuck = static_cast<std::size_t>(first - blocked.begin());
    }
    fail(vessel, stuck, "a face across z");
}

}  // namespace

std::string_view name_of(OpeningFaces faces)
{
    switch (faces) {
        case OpeningFaces::as_is:
            return "as_is";
        case OpeningFaces::extended:
            return "extended";
        case OpeningFaces::extended_z:
            return "extended_z";
    }
    return {};
}

ExtendedVessel extend_openings(const Vessel& vessel, const ExtensionOptions& options)
{
    if (!(options.clearance > 0.0)) {
        throw InputError(fmt::format("clearance {:.6g} m of extended openings: must be positive",
                                     options.clearance));
    }
    if (options.faces == OpeningFaces::as_is) return {vessel, {}};
    const WallTree wall(vessel);
    Draft draft = options.faces == OpeningFaces::extended_z
                      ? draft_along_z(vessel, wall, static_cast<std::size_t>(options.inlet),
                                      options.clearance)
                      : draft_to_any_face(vessel, wall, options.clearance);
    measure(draft.extended, vessel);
    return std::move(draft.extended);
}

std::vector<std::string> describe(const std::vector<OpeningTube>& tubes, const Vessel& vessel)
{
    std::vector<std::string> sentences;
    for (const OpeningTube& tube : tubes) {
        Eigen::Index axis = 0;
        tube.direction.cwiseAbs().maxCoeff(&axis);
        sentences.push_back(fmt::format(
            "lattice: the opening at {} is continued by {:.3g} mm, turned by {:.2g} degrees, to "
            "the {} face of the box across {}",
            place_text(vessel.openings[static_cast<std::size_t>(tube.opening)].centre, vessel.unit),
            1e3 * tube.length, tube.turn * 180.0 / std::numbers::pi,
            tube.direction[axis] > 0.0 ? "upper" : "lower", "xyz"[axis]));
    }
    return sentences;
}

}  // namespace braidzone
