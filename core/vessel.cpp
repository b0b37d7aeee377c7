#include "core/vessel.hpp"

#include "core/error.hpp"
#include "core/mesh_topology.hpp"
#include "core/place_text.hpp"
#include "core/surface_caps.hpp"
#include "core/surface_check.hpp"
#include "core/surface_opening.hpp"
#include "core/surface_repair.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <tuple>
#include <utility>

namespace braidzone {

namespace {

/// An opening is measured on its rim's polygon, seen along the rim's vector area, so that the
/// figures do not depend on how the rim would be filled.
Opening measured_opening(const TriangleMesh& wall, std::vector<int> rim)
{
    const auto point = [&](std::size_t k) -> const Vec3& {
        return wall.points[static_cast<std::size_t>(rim[k % rim.size()])];
    };
    Vec3 mean = Vec3::Zero();
    for (std::size_t k = 0; k < rim.size(); ++k)
        mean += point(k) / static_cast<double>(rim.size());

    Vec3 vector_area = Vec3::Zero();
    for (std::size_t k = 0; k < rim.size(); ++k) {
        vector_area += 0.5 * (point(k) - mean).cross(point(k + 1) - mean);
    }
    Opening opening;
    opening.centre = mean;
    opening.area = vector_area.norm();
    opening.radius = std::sqrt(opening.area / std::numbers::pi);
    if (opening.area > 0.0) {  // else a slit, which has no more than a place
        opening.normal = vector_area / opening.area;
        for (std::size_t k = 0; k < rim.size(); ++k) {
            const Vec3 a = point(k) - mean, b = point(k + 1) - mean;
            const double share = 0.5 * a.cross(b).dot(opening.normal) / opening.area;
            opening.centre += share * (a + b) / 3.0;
        }
    }
    opening.rim = std::move(rim);
    return opening;
}

/// All rims of an open surface, largest area first.
std::vector<Opening> measured_openings(const TriangleMesh& wall)
{
    std::vector<Opening> openings;
    for (std::vector<int>& rim : border_loops(wall)) {
        openings.push_back(measured_opening(wall, std::move(rim)));
    }
    std::stable_sort(openings.begin(), openings.end(),
                     [](const Opening& a, const Opening& b) { return a.area > b.area; });
    return openings;
}

/// A rim of less than this share of the largest opening's radius is a hole in the wall.
constexpr double smallest_radius_share = 0.25;

TriangleMesh without_triangles(const TriangleMesh& mesh, const std::vector<std::vector<int>>& parts)
{
    std::vector<char> is_kept(mesh.triangles.size(), 1);
    for (const std::vector<int>& part : parts) {
        for (const int triangle : part)
            is_kept[static_cast<std::size_t>(triangle)] = 0;
    }
    std::vector<int> kept;
    for (std::size_t triangle = 0; triangle < is_kept.size(); ++triangle) {
        if (is_kept[triangle]) kept.push_back(static_cast<int>(triangle));
    }
    return submesh(mesh, kept);
}

void require_sound(const TriangleMesh& surface)
{
    const SurfaceDefects defects = find_defects(surface);
    if (is_sound(defects)) return;
    throw GeometryError(fmt::format(
        "the vessel's surface is defective:\n{}mend it, or state `repair = true` in [vessel]",
        describe(defects)));
}

/// Refuses rims that are too small for a vessel's end, or closes them if `repair`.
void settle_holes(Vessel& vessel, bool repair_requested)
{
    if (vessel.openings.empty()) return;
    const double least_radius = smallest_radius_share * vessel.openings.front().radius;
    const auto first_hole =
        std::find_if(vessel.openings.begin(), vessel.openings.end(),
                     [&](const Opening& opening) { return !(opening.radius >= least_radius); });
    if (first_hole == vessel.openings.end()) return;

    const auto num_holes = vessel.openings.end() - first_hole;
    if (!repair_requested) {
        throw GeometryError(fmt::format(
            "the wall has {} hole{}, the largest of {:.6g} {} diameter at {}; an opening has at "
            "least a quarter of the largest one's {:.6g} {}; close the holes, or state "
            "`repair = true` in [vessel]",
            num_holes, num_holes == 1 ? "" : "s", 2.0 * first_hole->radius / vessel.unit.metres,
            vessel.unit.name, place_text(first_hole->centre, vessel.unit),
            2.0 * vessel.openings.front().radius / vessel.unit.metres, vessel.unit.name));
    }
    for (auto hole = first_hole; hole != vessel.openings.end(); ++hole) {
        append_fan(vessel.wall, hole->rim, hole->centre);
        vessel.notes.push_back(fmt::format(
            "closed a hole of {:.6g} {} diameter at {}", 2.0 * hole->radius / vessel.unit.metres,
            vessel.unit.name, place_text(hole->centre, vessel.unit)));
    }
    vessel.openings.erase(first_hole, vessel.openings.end());
    require_sound(vessel.wall);
}

void require_vessel_size(const Vessel& vessel)
{
    // From the smallest perforating branch that a surface resolves to the aortic root.
    constexpr double smallest = 0.5e-3, largest = 30e-3;
    const double diameter = 2.0 * vessel.openings.front().radius;
    if (diameter >= smallest && diameter <= largest) return;
    throw GeometryError(fmt::format(
        "the largest opening is {:.6g} mm wide, no blood vessel (0.5 to 30 mm): is the surface "
        "really in {}? Check `length_unit` in [vessel]",
        diameter * 1e3, vessel.unit.name));
}

}  // namespace

Vessel make_vessel(const TriangleMesh& surface, const LengthUnit& unit,
                   const VesselOptions& options)
{
    Vessel vessel;
    vessel.unit = unit;
    vessel.wall = surface;
    if (options.repair && !is_sound(find_defects(surface))) {
        std::tie(vessel.wall, vessel.notes) = repair(surface);
    } else {
        require_sound(surface);
    }

    vessel.openings = measured_openings(vessel.wall);
    if (vessel.openings.size() < 2) {
        const std::vector<std::vector<int>> caps = flat_caps(vessel.wall, options.cap_angle_deg);
        if (!caps.empty()) {
            vessel.wall = without_triangles(vessel.wall, caps);
            vessel.openings = measured_openings(vessel.wall);
            vessel.notes.push_back(fmt::format("opened {} flat caps", caps.size()));
        }
    }
    if (vessel.openings.empty()) {
        if (!options.ends) {
            throw GeometryError(fmt::format(
                "the surface is closed and has no flat caps (normals within {:.6g} degrees, "
                "a rim sharper than 45 degrees) that could be opened; give end points in the "
                "lumen, vessel.from and vessel.to, where it is to be cut open",
                options.cap_angle_deg));
        }
        vessel.wall = open_rounded_ends(vessel.wall, *options.ends);
        vessel.openings = measured_openings(vessel.wall);
        vessel.notes.push_back(
            fmt::format("cut the closed surface open at {} and {}; its other ends stay closed",
                        place_text(options.ends->from, unit), place_text(options.ends->to, unit)));
    }
    settle_holes(vessel, options.repair);
    require_vessel_size(vessel);
    if (vessel.openings.size() < 2) {
        throw GeometryError(
            fmt::format("the vessel has one opening only, of {:.6g} mm diameter at {}; blood needs "
                        "an inlet and an outlet",
                        2e3 * vessel.openings.front().radius,
                        place_text(vessel.openings.front().centre, unit)));
    }
    return vessel;
}

ClosedLumen close_openings(const Vessel& vessel)
{
    ClosedLumen lumen{vessel.wall, std::vector<int>(vessel.wall.triangles.size(), -1)};
    for (std::size_t opening = 0; opening < vessel.openings.size(); ++opening) {
        append_fan(lumen.mesh, vessel.openings[opening].rim, vessel.openings[opening].centre);
        lumen.opening_of.resize(lumen.mesh.triangles.size(), static_cast<int>(opening));
    }
    return lumen;
}

}  // namespace braidzone
