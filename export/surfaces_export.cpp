#include "export/surfaces_export.hpp"

#include "core/error.hpp"
#include "core/surface_check.hpp"
#include "core/surface_io.hpp"
#include "export/device_shell.hpp"
#include "export/text_file.hpp"
#include "export/vessel_distance.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <optional>

namespace braidzone {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

// Between solids that would touch: what a wall of flat triangles may stand out between the places
// at which a layer's distance from it is measured.
constexpr double wire_gap_ratio = 0.05;  // over the wire diameter
constexpr double shell_gap_ratio = 0.1;  // over the thickness; its triangles are larger

constexpr const char* readme = R"(# Closed surfaces
Binary STL, coordinates in the unit that `surfaces.json` and the header of each file name, normals out of
the solid. All files lie in one frame, that of the vessel's own file.

- `vessel.stl`: the lumen, its openings closed by flat caps. Their places: `openings` in `surfaces.json`.
- `device.stl`: the device's skin without pores, as a solid of `thickness_m`. For a resistance or a wall in
  its place; a voxel must be thinner than the solid for the voxels to close it.
- `wires.stl`: every wire as a closed tube of its own, over and under the others. No tube touches another
  if `least_gap_m` is positive. For flow that resolves the wires: 4 voxels or more across one.
- `second_device.stl`, `second_wires.stl`: of a device inside the first one.
- `vessel_distance.vdb`: OpenVDB level set, distance to `vessel.stl` in its unit, negative inside.

HemoCell: `<geometry> vessel.stl </geometry>` of the case's `<domain>`; it scales the surface by
`<refDirN>` voxels along `<refDir>`, takes the inside as fluid and opens the two ends in x, where the
vessel's openings must lie.
FluidX3D: `voxelize_stl` sets a flag inside the surface and places and scales each file by itself. Give
`vessel.stl` the flag TYPE_X, then TYPE_S to every cell without it; place `device.stl` or `wires.stl` by
the bounding boxes in `surfaces.json`.
HemeLB: `vessel.stl` as `StlFile` of the geometry tool's profile (`StlFileUnitId` 0: m, 1: mm, 2: um), an
iolet at each of `openings`.
)";

Json vector_as_json(const Vec3& v)
{
    return {v.x(), v.y(), v.z()};
}

/// One file's entry in surfaces.json.
Json mesh_as_json(const TriangleMesh& mesh)
{
    const Box box = bounding_box(mesh);
    return {{"num_triangles", mesh.triangles.size()},
            {"area_m2", surface_area(mesh)},
            {"volume_m3", enclosed_volume(mesh)},
            {"lower_m", vector_as_json(box.lower)},
            {"upper_m", vector_as_json(box.upper)}};
}

Json openings_as_json(const Vessel& vessel)
{
    Json openings = Json::array();
    for (const Opening& opening : vessel.openings) {
        openings.push_back({{"centre_m", vector_as_json(opening.centre)},
                            {"normal_outwards", vector_as_json(opening.normal)},
                            {"radius_m", opening.radius},
                            {"area_m2", opening.area}});
    }
    return openings;
}

/// A note for each defect of a surface.
void note_defects(std::vector<std::string>& notes, const std::string& file,
                  const TriangleMesh& mesh)
{
    const SurfaceDefects defects = find_defects(mesh);
    if (is_sound(defects)) return;
    std::string found = describe(defects);
    found.pop_back();  // the last line's end
    std::replace(found.begin(), found.end(), '\n', ';');
    notes.push_back(fmt::format("surfaces/{}: {}", file, found));
}

/// A note if a solid in the lumen cuts the lumen's surface.
void note_cuts(std::vector<std::string>& notes, const std::string& file, const TriangleMesh& solid,
               const TriangleMesh& lumen)
{
    TriangleMesh both = solid;
    const int num_points = static_cast<int>(solid.points.size());
    const int num_triangles = static_cast<int>(solid.triangles.size());
    both.points.insert(both.points.end(), lumen.points.begin(), lumen.points.end());
    for (const auto& [a, b, c] : lumen.triangles)
        both.triangles.push_back({a + num_points, b + num_points, c + num_points});
    const SurfaceDefects defects = find_defects(both);
    const auto num_cuts =
        std::count_if(defects.intersecting_triangles.begin(), defects.intersecting_triangles.end(),
                      [&](const std::array<int, 2>& pair) {
                          return pair[0] < num_triangles && pair[1] >= num_triangles;
                      });
    if (num_cuts == 0) return;
    notes.push_back(
        fmt::format("surfaces/{} cuts the vessel's wall in {} pairs of triangles: its triangles "
                    "are too large for "
                    "the wall there, or the vessel too narrow",
                    file, num_cuts));
}

/// The files of a folder with what is said about them.
struct SurfaceFiles {
    const fs::path& folder;
    const LengthUnit& unit;
    Json entries = Json::object();
    std::vector<std::string> notes = {};

    /// Writes a file; returns its entry.
    Json& add(const std::string& name, const TriangleMesh& mesh)
    {
        write_stl(folder / name, mesh, unit);
        return entries[name] = mesh_as_json(mesh);
    }
};

double shell_thickness(const SurfaceDevice& device, const SurfacesOptions& options)
{
    return options.shell_thickness > 0.0 ? options.shell_thickness : 2.0 * device.wire_diameter;
}

/// @return the inner side of the solid
TriangleMesh add_shell(SurfaceFiles& files, const SurfaceDevice& device, const TriangleMesh& lumen,
                       const WallTree& wall, const SurfacesOptions& options)
{
    const std::string name = device.prefix + "device.stl";
    const double thickness = shell_thickness(device, options);
    const BraidLattice& lattice = device.deployment.lattice;
    const InsetBraid braid =
        inset_braid(device.deployment, wall, (0.5 + shell_gap_ratio) * thickness);
    const TriangleMesh shell = make_device_shell(lattice, braid, thickness);
    files.add(name, shell)["thickness_m"] = thickness;
    note_defects(files.notes, name, shell);
    note_cuts(files.notes, name, shell, lumen);
    return inner_face(lattice, braid, 0.5 * thickness);
}

void note_overlaps(SurfaceFiles& files, const std::string& name, const WireTubes& tubes,
                   double wire_diameter)
{
    if (tubes.num_overlaps == 0) return;
    const Vec3 place = tubes.least_gap_place / files.unit.metres;
    files.notes.push_back(fmt::format(
        "surfaces/{}: wires overlap in {} places, most at ({:.6g}, {:.6g}, {:.6g}) {} by {:.3g} of "
        "their diameter: there they lie denser, or cross at a smaller angle, than round wires can",
        name, tubes.num_overlaps, place.x(), place.y(), place.z(), files.unit.name,
        -tubes.least_gap / wire_diameter));
}

/// @return the inner side of the layer that the wires take
TriangleMesh add_wires(SurfaceFiles& files, const SurfaceDevice& device, const WallTree& wall,
                       const WireTubeOptions& options)
{
    const std::string name = device.prefix + "wires.stl";
    const double half_of_layer = half_thickness(options, device.wire_diameter);
    const BraidLattice& lattice = device.deployment.lattice;
    const InsetBraid braid =
        inset_braid(device.deployment, wall, half_of_layer + wire_gap_ratio * device.wire_diameter);
    const WireTubes tubes = make_wire_tubes(lattice, braid, device.wire_diameter, options);
    Json& entry = files.add(name, tubes.mesh);
    entry["num_solids"] = tubes.lines.size();
    entry["braid_pattern"] =
        braid_pattern_names()[static_cast<std::size_t>(options.pattern.over - 1)];
    entry["wire_diameter_m"] = device.wire_diameter;
    entry["wire_length_m"] = tubes.length;
    entry["least_gap_m"] = tubes.least_gap;
    entry["num_overlaps"] = tubes.num_overlaps;
    note_overlaps(files, name, tubes, device.wire_diameter);
    return inner_face(lattice, braid, half_of_layer);
}

}  // namespace

std::vector<std::string> surface_part_names()
{
    return {"vessel", "device", "wires", "distance"};
}

bool SurfacesOptions::has(SurfacePart part) const
{
    return std::find(parts.begin(), parts.end(), part) != parts.end();
}

void require_possible_wires(const FlowDiverter& device, const SurfacesOptions& options)
{
    if (!options.has(SurfacePart::wires)) return;
    const BraidLattice lattice = make_lattice(device);
    const BraidPattern& pattern = options.wires.pattern;
    if (!closes_around(pattern, lattice.nodes_per_ring)) {
        throw ConfigError(fmt::format(
            "export.braid_pattern = \"{}\" does not close around a braid of {} wires: half of "
            "their number must be a multiple of {}",
            braid_pattern_names()[static_cast<std::size_t>(pattern.over - 1)], device.num_wires,
            pattern.over));
    }
    const std::size_t num_triangles = num_wire_triangles(lattice, options.wires);
    if (num_triangles <= most_surface_triangles) return;
    constexpr double gigabytes = 50e-9;  // a triangle of binary STL
    throw ConfigError(fmt::format(
        "export.wire_facets = {} and export.wire_pieces = {} would make wires.stl of {:.3g} "
        "million "
        "triangles ({:.2g} GB); {:.3g} million at most: lower one of them",
        options.wires.facets, options.wires.pieces_per_arm,
        1e-6 * static_cast<double>(num_triangles), gigabytes * static_cast<double>(num_triangles),
        1e-6 * static_cast<double>(most_surface_triangles)));
}

std::vector<std::string> write_surfaces(const fs::path& folder, const Vessel& vessel,
                                        const WallTree& wall,
                                        const std::vector<SurfaceDevice>& devices,
                                        const SurfacesOptions& options, const FileOrigin& origin)
{
    write_text_file(folder / "README.md", readme);
    SurfaceFiles files{folder, vessel.unit};
    const TriangleMesh lumen = close_openings(vessel).mesh;
    if (options.has(SurfacePart::vessel)) {
        files.add("vessel.stl", lumen);
        note_defects(files.notes, "vessel.stl", lumen);
    }
    // A second device lies on what was written of the first.
    std::optional<WallTree> under_shell, under_wires;
    for (const SurfaceDevice& device : devices) {
        if (options.has(SurfacePart::device)) {
            const WallTree& support = under_shell ? *under_shell : wall;
            under_shell.emplace(vessel, add_shell(files, device, lumen, support, options));
        }
        if (options.has(SurfacePart::wires)) {
            const WallTree& support = under_wires ? *under_wires : wall;
            under_wires.emplace(vessel, add_wires(files, device, support, options.wires));
        }
    }
    if (options.has(SurfacePart::distance)) {
        write_vessel_distance(folder / "vessel_distance.vdb", vessel, options.distance_spacing,
                              origin);
        files.entries["vessel_distance.vdb"] = {{"spacing_m", options.distance_spacing}};
    }
    const Json json = {{"format", 1},
                       {"generator", origin.generator},
                       {"case_hash", origin.case_hash},
                       {"length_unit", vessel.unit.name},
                       {"length_unit_m", vessel.unit.metres},
                       {"openings", openings_as_json(vessel)},
                       {"files", files.entries},
                       {"notes", files.notes}};
    write_text_file(folder / "surfaces.json", json.dump(2) + "\n");
    return files.notes;
}

}  // namespace braidzone
