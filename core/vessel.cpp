#include "core/vessel.hpp"

#include "core/error.hpp"
#include "core/line_frame.hpp"
#include "core/line_network.hpp"
#include "core/lumen_behind.hpp"
#include "core/mesh_topology.hpp"
#include "core/near_points.hpp"
#include "core/place_text.hpp"
#include "core/rounded_ends.hpp"
#include "core/split_edges.hpp"
#include "core/surface_caps.hpp"
#include "core/surface_check.hpp"
#include "core/wall_tree.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

namespace braidzone {

namespace {

/// A vessel on its way: what `make_vessel` does step by step.
class VesselMaking {
public:
    VesselMaking(const LabelledSurface& surface, const LengthUnit& unit,
                 const VesselOptions& options)
        : options_(options)
    {
        vessel_.unit = unit;
        vessel_.notes = surface.notes;
        open_labelled_caps(with_edges_split_at_corners(with_merged_points(surface)));
        auto [mended, notes] = repair(vessel_.wall, options.repair, unit);
        vessel_.wall = std::move(mended);
        vessel_.notes.insert(vessel_.notes.end(), notes.begin(), notes.end());
        measure();
    }

    Vessel result() &&
    {
        settle_holes();
        if (vessel_.openings.size() < 2) open_flat_caps();
        carry_out_orders();
        cut_where_lines_end();
        if (vessel_.openings.empty()) cut_at_given_ends();
        require_vessel_size();
        require_inlet_and_outlet();
        return std::move(vessel_);
    }

private:
    std::string diameter(double radius) const
    {
        return fmt::format("{:.6g} {}", 2.0 * radius / vessel_.unit.metres, vessel_.unit.name);
    }

    std::string place(const Vec3& point) const { return place_text(point, vessel_.unit); }

    /// The surface with triangles that came of others, which keep their labels.
    static LabelledSurface with_mesh(const LabelledSurface& surface, TriangleMesh mesh,
                                     const std::vector<int>& from)
    {
        LabelledSurface result = surface;
        result.mesh = std::move(mesh);
        if (surface.labels.empty()) return result;
        result.labels.clear();
        for (const int triangle : from)
            result.labels.push_back(surface.labels[static_cast<std::size_t>(triangle)]);
        return result;
    }

    LabelledSurface with_merged_points(const LabelledSurface& surface)
    {
        MergedPoints merged = merged_near_points(surface.mesh);
        if (merged.num_merged == 0) return surface;
        const std::size_t num_dropped = surface.mesh.triangles.size() - merged.kept.size();
        vessel_.notes.push_back(fmt::format(
            "merged {} points nearer to another one than 1e-4 of the edges there{}",
            merged.num_merged,
            num_dropped > 0 ? fmt::format(" and dropped {} triangles of no width", num_dropped)
                            : std::string()));
        return with_mesh(surface, std::move(merged.mesh), merged.kept);
    }

    LabelledSurface with_edges_split_at_corners(const LabelledSurface& surface)
    {
        SplitEdges split = with_split_edges(surface.mesh);
        if (split.num_corners == 0) return surface;
        vessel_.notes.push_back(fmt::format(
            "split edges at {} corners of finer triangles that lie on them", split.num_corners));
        return with_mesh(surface, std::move(split.mesh), split.from);
    }

    void open_labelled_caps(LabelledSurface surface)
    {
        if (!surface.labels.empty() && is_inverted(surface.mesh)) {
            for (std::array<int, 3>& corners : surface.mesh.triangles)
                std::swap(corners[1], corners[2]);
            vessel_.notes.push_back("turned all normals out of the lumen");
        }
        const LabelledCaps found = labelled_caps(surface);
        vessel_.notes.insert(vessel_.notes.end(), found.notes.begin(), found.notes.end());
        std::vector<std::vector<int>> regions;
        for (const LabelledCap& cap : found.caps) {
            regions.push_back(cap.triangles);
            opened_.push_back(cap.opening);
            opened_.back().kind = fmt::format("cap {} {}", surface.label_name, cap.label);
        }
        vessel_.wall = std::move(surface.mesh);
        if (regions.empty()) return;
        take_out(regions);
        vessel_.notes.push_back(
            fmt::format("opened {} caps labelled by {}", regions.size(), surface.label_name));
    }

    void take_out(const std::vector<std::vector<int>>& regions)
    {
        std::vector<char> is_kept(vessel_.wall.triangles.size(), 1);
        for (const std::vector<int>& region : regions) {
            for (const int triangle : region)
                is_kept[static_cast<std::size_t>(triangle)] = 0;
        }
        std::vector<int> kept;
        for (std::size_t triangle = 0; triangle < is_kept.size(); ++triangle) {
            if (is_kept[triangle]) kept.push_back(static_cast<int>(triangle));
        }
        vessel_.wall = submesh(vessel_.wall, kept);
    }

    /// Measures the openings anew; those that were opened keep their kind.
    void measure()
    {
        vessel_.openings = measured_openings(vessel_.wall);
        for (Opening& opening : vessel_.openings) {
            for (const Opening& known : opened_) {
                const bool is_same =
                    (known.centre - opening.centre).norm() < 0.1 * opening.radius &&
                    std::abs(known.radius - opening.radius) < 0.1 * opening.radius;
                if (is_same) opening.kind = known.kind;
            }
        }
    }

    bool is_ordered(const Opening& opening) const
    {
        return std::any_of(options_.orders.begin(), options_.orders.end(),
                           [&](const OpeningOrder& order) {
                               const Vec3* point = std::get_if<Vec3>(&order.at);
                               return point != nullptr && order.action != OpeningAction::cut &&
                                      lies_at(*point, opening);
                           });
    }

    /// True for a point that names the opening: no farther from its middle than its rim is wide.
    bool lies_at(const Vec3& point, const Opening& opening) const
    {
        return (point - opening.centre).norm() <= 2.0 * opening.radius;
    }

    /// Refuses rims without a tube behind them, or closes them.
    void settle_holes()
    {
        if (vessel_.openings.empty()) return;
        const WallTree wall(vessel_);
        std::vector<std::pair<Opening, LumenBehind>> holes;
        for (const Opening& opening : vessel_.openings) {
            const LumenBehind behind = lumen_behind(opening, vessel_.wall, wall);
            if (!behind.is_tube && !is_ordered(opening)) holes.emplace_back(opening, behind);
        }
        if (holes.empty()) return;
        if (!options_.repair.holes) refuse(holes);
        for (const auto& [hole, behind] : holes) {
            append_fan(vessel_.wall, hole.rim, hole.centre);
            vessel_.notes.push_back(fmt::format("closed a hole of {} diameter at {}",
                                                diameter(hole.radius), place(hole.centre)));
        }
        require_sound(vessel_.wall);
        measure();
    }

    [[noreturn]] void refuse(const std::vector<std::pair<Opening, LumenBehind>>& holes) const
    {
        constexpr std::size_t most = 5;
        std::string text;
        for (std::size_t k = 0; k < std::min(holes.size(), most); ++k) {
            const auto& [hole, behind] = holes[k];
            text += fmt::format("  {} diameter at {}, where the lumen is {} wide\n",
                                diameter(hole.radius), place(hole.centre), diameter(behind.radius));
        }
        if (holes.size() > most) text += fmt::format("  and {} more\n", holes.size() - most);
        Repairs with_holes = options_.repair;
        with_holes.holes = true;
        throw GeometryError(fmt::format(
            "the wall has {} opening{} far smaller than the lumen behind, without a tube that "
            "leads there:\n{}close holes by `{}` in [vessel], or name the openings that are to "
            "stay in vessel.openings",
            holes.size(), holes.size() == 1 ? "" : "s", text, repair_text(with_holes)));
    }

    static void require_sound(const TriangleMesh& surface) { repair(surface, {}); }

    void open_flat_caps()
    {
        const std::vector<std::vector<int>> caps = flat_caps(vessel_.wall, options_.cap_angle_deg);
        if (caps.empty()) return;
        for (const std::vector<int>& cap : caps) {
            TriangleMesh alone{vessel_.wall.points, {}};
            for (const int triangle : cap)
                alone.triangles.push_back(
                    vessel_.wall.triangles[static_cast<std::size_t>(triangle)]);
            opened_.push_back(measured_opening(alone, border_loops(alone).front()));
            opened_.back().kind = "flat cap";
        }
        take_out(caps);
        measure();
        vessel_.notes.push_back(fmt::format("opened {} flat caps", caps.size()));
    }

    std::vector<RoundedEnd> closed_ends() const
    {
        return rounded_ends(vessel_.wall, vessel_.openings, WallTree(vessel_));
    }

    void carry_out_orders()
    {
        if (options_.orders.empty()) return;
        const std::vector<Opening> openings = vessel_.openings;
        const std::vector<RoundedEnd> ends = closed_ends();
        std::set<std::size_t> capped;
        std::vector<LumenEnd> cuts;
        for (const OpeningOrder& order : options_.orders) {
            if (order.action == OpeningAction::cut) {
                cuts.push_back(cut_of(order, openings, ends));
                continue;
            }
            const std::size_t opening = opening_of(order, openings);
            if (order.action == OpeningAction::cap) capped.insert(opening);
        }
        for (const std::size_t opening : capped) {
            append_fan(vessel_.wall, openings[opening].rim, openings[opening].centre);
            vessel_.notes.push_back(fmt::format("capped the opening of {} diameter at {}",
                                                diameter(openings[opening].radius),
                                                place(openings[opening].centre)));
        }
        if (!capped.empty()) require_sound(vessel_.wall);
        for (const LumenEnd& cut : cuts)
            vessel_.notes.push_back(fmt::format("cut open at {}", place(cut.point)));
        cut_at(cuts);
    }

    void cut_at(const std::vector<LumenEnd>& cuts)
    {
        if (!cuts.empty()) vessel_.wall = cut_open(vessel_.wall, cuts);
        measure();
        for (Opening& opening : vessel_.openings) {
            for (const LumenEnd& cut : cuts) {
                const bool is_in_plane =
                    std::abs((opening.centre - cut.point).dot(cut.outwards)) < 0.1 * opening.radius;
                if (is_in_plane && lies_at(cut.point, opening)) opening.kind = "cut";
            }
            if (opening.kind == "cut") opened_.push_back(opening);
        }
    }

    std::size_t opening_of(const OpeningOrder& order, const std::vector<Opening>& openings) const
    {
        if (const int* number = std::get_if<int>(&order.at)) {
            if (static_cast<std::size_t>(*number) < openings.size())
                return static_cast<std::size_t>(*number);
            throw GeometryError(fmt::format(
                "vessel.openings names opening {}; the vessel has {} that could be kept or capped",
                *number, openings.size()));
        }
        const Vec3& point = std::get<Vec3>(order.at);
        for (std::size_t k = 0; k < openings.size(); ++k) {
            if (lies_at(point, openings[k])) return k;
        }
        throw GeometryError(fmt::format(
            "vessel.openings names {}, but no opening lies there: a point names an opening whose "
            "middle is nearer to it than the opening is wide",
            place(point)));
    }

    LumenEnd cut_of(const OpeningOrder& order, const std::vector<Opening>& openings,
                    const std::vector<RoundedEnd>& ends) const
    {
        if (const int* number = std::get_if<int>(&order.at)) {
            const std::size_t end = static_cast<std::size_t>(*number) - openings.size();
            if (static_cast<std::size_t>(*number) < openings.size()) {
                throw GeometryError(fmt::format(
                    "vessel.openings cuts at {}, which is open; to shorten the vessel give the "
                    "point where it is to be cut",
                    *number));
            }
            if (end < ends.size()) return {ends[end].centre, ends[end].outwards, ends[end].radius};
            throw GeometryError(fmt::format(
                "vessel.openings cuts at {}; the vessel has {} openings and {} rounded ends",
                *number, openings.size(), ends.size()));
        }
        return cut_towards_nearest_end(std::get<Vec3>(order.at), openings, ends);
    }

    /// A cut through a point, across the direction of the end that is nearest to it.
    LumenEnd cut_towards_nearest_end(const Vec3& point, const std::vector<Opening>& openings,
                                     const std::vector<RoundedEnd>& ends) const
    {
        const WallTree wall(vessel_);
        if (!wall.contains(point)) {
            throw GeometryError(
                fmt::format("vessel.openings cuts at {}, which is not in the lumen", place(point)));
        }
        LumenEnd cut{point, Vec3::UnitX(), wall.nearest(point).distance};
        double nearest = -1.0;
        const auto take_if_nearer = [&](const Vec3& where, const Vec3& outwards, double radius) {
            const double distance = (where - point).norm();
            if (nearest >= 0.0 && distance >= nearest) return;
            nearest = distance;
            cut.outwards = outwards;
            cut.radius = std::max(wall.nearest(point).distance, std::min(radius, distance));
        };
        for (const Opening& opening : openings)
            take_if_nearer(opening.centre, opening.normal, opening.radius);
        for (const RoundedEnd& end : ends)
            take_if_nearer(end.centre, end.outwards, end.radius);
        return cut;
    }

    /// Cuts the vessel where a line ends, if it is not open there.
    void cut_where_lines_end()
    {
        if (options_.lines.empty()) return;
        const bool is_closed = vessel_.openings.size() < 2;
        const WallTree wall(vessel_);
        std::vector<Polyline> lines;
        for (const std::vector<Vec3>& points : options_.lines)
            lines.push_back({points, {}});
        if (is_closed) require_same_frame(lines, vessel_, wall);
        // One line alone may say where a closed vessel is to be cut; of several some may end
        // anywhere.
        const bool is_trusted = is_closed && lines.size() == 1;
        std::vector<RoundedEnd> ends;
        if (!is_trusted) ends = closed_ends();
        const LineNetwork network(lines);
        std::vector<LumenEnd> cuts;
        for (std::vector<Vec3> line : options_.lines) {
            for (int side = 0; side < 2; ++side, std::reverse(line.begin(), line.end())) {
                if (!network.ends_at(line.back()) || is_open_at(line.back())) continue;
                const std::optional<LumenEnd> cut = end_of_line(line, wall);
                if (!cut || is_among(*cut, cuts)) continue;
                if (is_trusted || is_at_rounded_end(*cut, ends)) cuts.push_back(*cut);
            }
        }
        if (cuts.empty()) return;
        for (const LumenEnd& cut : cuts) {
            vessel_.notes.push_back(
                fmt::format("cut open at {}, where the given centerline ends", place(cut.point)));
        }
        cut_at(cuts);
    }

    bool is_open_at(const Vec3& point) const
    {
        return std::any_of(vessel_.openings.begin(), vessel_.openings.end(),
                           [&](const Opening& opening) { return lies_at(point, opening); });
    }

    static bool is_among(const LumenEnd& cut, const std::vector<LumenEnd>& cuts)
    {
        return std::any_of(cuts.begin(), cuts.end(), [&](const LumenEnd& other) {
            return (cut.point - other.point).norm() < cut.radius;
        });
    }

    /// True if what the cut takes off is the round of a tip: within three radii of the end.
    static bool is_at_rounded_end(const LumenEnd& cut, const std::vector<RoundedEnd>& ends)
    {
        constexpr double most_radii = 3.0;
        return std::any_of(ends.begin(), ends.end(), [&](const RoundedEnd& end) {
            return (cut.point - end.centre).norm() < most_radii * end.radius &&
                   cut.outwards.dot(end.outwards) > 0.5;
        });
    }

    void cut_at_given_ends()
    {
        if (!options_.ends) {
            throw GeometryError(fmt::format(
                "the surface is closed and has no flat caps (normals within {:.6g} degrees, "
                "a rim sharper than 45 degrees) that could be opened; its ends are\n{}"
                "cut two of them open in vessel.openings, or give end points in the lumen, "
                "vessel.from and vessel.to{}",
                options_.cap_angle_deg, ends_text(), notes_text()));
        }
        vessel_.wall = open_rounded_ends(vessel_.wall, *options_.ends);
        measure();
        for (Opening& opening : vessel_.openings)
            opening.kind = "cut";
        vessel_.notes.push_back(
            fmt::format("cut the closed surface open at {} and {}; its other ends stay closed",
                        place(options_.ends->from), place(options_.ends->to)));
    }

    std::string ends_text() const
    {
        std::string text;
        int number = 0;
        for (const RoundedEnd& end : closed_ends()) {
            text += fmt::format("  {}: about {} wide at {}\n", number++, diameter(end.radius),
                                place(end.centre));
        }
        return text;
    }

    /// What was changed before the vessel was refused: it may be the reason.
    std::string notes_text() const
    {
        std::string text;
        for (const std::string& note : vessel_.notes)
            text += "\n  note: " + note;
        return text;
    }

    void require_vessel_size() const
    {
        // From the smallest perforating branch that a surface resolves to the aortic root.
        constexpr double smallest = 0.5e-3, largest = 30e-3;
        if (vessel_.openings.empty()) throw GeometryError("the vessel has no opening left");
        const double wide = 2.0 * vessel_.openings.front().radius;
        if (wide >= smallest && wide <= largest) return;
        throw GeometryError(fmt::format(
            "the largest opening is {:.6g} mm wide, no blood vessel (0.5 to 30 mm): is the surface "
            "really in {}? Check `length_unit` in [vessel]",
            wide * 1e3, vessel_.unit.name));
    }

    void require_inlet_and_outlet() const
    {
        if (vessel_.openings.size() >= 2) return;
        throw GeometryError(
            fmt::format("the vessel has one opening only, of {:.6g} mm diameter at {}; blood needs "
                        "an inlet and an outlet{}",
                        2e3 * vessel_.openings.front().radius,
                        place(vessel_.openings.front().centre), notes_text()));
    }

    const VesselOptions& options_;
    Vessel vessel_;
    std::vector<Opening> opened_;  ///< by us, with their kind
};

/// Refuses a moved wall that has passed itself, such as a tube by more than its radius: that is a
/// sound tube again, but each of its triangles faces the other way.
void require_unturned(const Vessel& vessel, const TriangleMesh& moved)
{
    const int num_triangles = static_cast<int>(moved.triangles.size());
    int num_turned = 0, first = 0;
    for (int triangle = 0; triangle < num_triangles; ++triangle) {
        if (area_vector(vessel.wall, triangle).dot(area_vector(moved, triangle)) > 0.0) continue;
        if (num_turned == 0) first = triangle;
        ++num_turned;
    }
    if (num_turned == 0) return;
    const Vec3& place = vessel.wall.points[static_cast<std::size_t>(
        vessel.wall.triangles[static_cast<std::size_t>(first)].front())];
    throw GeometryError(
        fmt::format("{} of {} triangles of the moved surface face the other way, the first at {}",
                    num_turned, num_triangles, place_text(place, vessel.unit)));
}

}  // namespace

Vessel make_vessel(const LabelledSurface& surface, const LengthUnit& unit,
                   const VesselOptions& options)
{
    return VesselMaking(surface, unit, options).result();
}

Vessel make_vessel(const TriangleMesh& surface, const LengthUnit& unit,
                   const VesselOptions& options)
{
    return make_vessel(LabelledSurface{surface, {}, "", {}}, unit, options);
}

Vessel with_wall(const Vessel& vessel, TriangleMesh wall)
{
    require_unturned(vessel, wall);
    // Nothing is mended: even normals that point inwards mean that the wall has passed itself.
    if (const SurfaceDefects defects = find_defects(wall); !is_sound(defects))
        throw GeometryError("the moved surface is defective:\n" + describe(defects));
    Vessel moved = vessel;
    moved.wall = std::move(wall);
    moved.openings = measured_openings(moved.wall);
    for (Opening& opening : moved.openings) {
        for (const Opening& before : vessel.openings) {
            if (before.rim == opening.rim) opening.kind = before.kind;
        }
    }
    return moved;
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
