#include "export/foam_apply.hpp"

#include "core/error.hpp"
#include "core/triangle_mesh.hpp"
#include "export/foam_device.hpp"
#include "export/foam_field.hpp"
#include "export/foam_inspection.hpp"
#include "export/foam_report.hpp"
#include "export/foam_sac.hpp"
#include "export/foam_sac_zones.hpp"
#include "export/foam_update.hpp"
#include "export/foam_viscosity.hpp"
#include "export/text_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace braidzone {

namespace {

namespace fs = std::filesystem;

template <typename Item>
void append(std::vector<Item>& list, const std::vector<Item>& more)
{
    list.insert(list.end(), more.begin(), more.end());
}

/// Zones that a call writes and the next one replaces.
bool is_device_zone(const std::string& name)
{
    return name == per_cell_zone || name.starts_with("FD_") || is_sac_zone(name);
}

/// Those of the mesh, then those of the device.
template <typename Zone>
std::vector<Zone> merged(std::vector<Zone> zones, const std::vector<Zone>& device_zones)
{
    std::erase_if(zones, [](const Zone& zone) { return is_device_zone(zone.name); });
    zones.insert(zones.end(), device_zones.begin(), device_zones.end());
    return zones;
}

/// @param staging  where they are written
/// @return the files, relative to the case
std::vector<fs::path> write_zones(const fs::path& foam_case, const fs::path& staging,
                                  const FoamDevice& device, const FoamSacZones& of_sacs)
{
    std::vector<FoamCellZone> cells = device.cell_zones;
    append(cells, of_sacs.cells);
    write_cell_zones(staging, merged(read_cell_zones(foam_case), cells));
    std::vector<FoamFaceZone> faces = device.face_zones;
    append(faces, of_sacs.faces);
    const std::vector<FoamFaceZone> mesh_faces = read_face_zones(foam_case);
    const fs::path folder = fs::path("constant") / "polyMesh";
    if (mesh_faces.empty() && faces.empty()) return {folder / "cellZones"};
    write_face_zones(staging, merged(mesh_faces, faces));
    return {folder / "cellZones", folder / "faceZones"};
}

/// Writes a file if it has text.
/// @return the file, if it was written
std::vector<fs::path> write_unless_empty(const fs::path& staging, const fs::path& file,
                                         const std::string& text)
{
    if (text.empty()) return {};
    write_text_file(staging / file, text);
    return {file};
}

/// Gives the writers what they look at before they write.
void prepare_staging(const fs::path& foam_case, const fs::path& staging)
{
    fs::create_directories(staging / start_folder(foam_case));
    for (const char* file : {"constant/fvOptions", "constant/fvModels", "system/fvOptions"}) {
        if (!fs::exists(foam_case / file)) continue;
        fs::create_directories((staging / file).parent_path());
        fs::copy_file(foam_case / file, staging / file);
    }
}

/// All that this call wrote, and all of an earlier one that it did not write again.
FoamChanges changes_of(const fs::path& foam_case, std::vector<fs::path> written)
{
    FoamChanges changes;
    changes.key = fs::path("constant") / "fdPorosity";
    const auto is_written = [&](const fs::path& file) {
        return std::find(written.begin(), written.end(), file) != written.end();
    };
    // OpenFOAM must not find older zones beside the new ones.
    changes.removed = {"constant/polyMesh/cellZones.gz", "system/fdBaffles", "system/fdFunctions"};
    if (is_written("constant/polyMesh/faceZones"))
        changes.removed.emplace_back("constant/polyMesh/faceZones.gz");
    append(changes.removed, directed_field_files(foam_case));
    std::erase_if(changes.removed, is_written);
    // From the first of these on a solver asks for the key.
    std::stable_partition(written.begin(), written.end(), [](const fs::path& file) {
        return file.filename() == "fvOptions" || file.filename() == "fvModels";
    });
    changes.written = std::move(written);
    return changes;
}

double volume_of(const std::vector<int>& cells, const FoamMesh& mesh)
{
    double volume = 0.0;
    for (const int cell : cells)
        volume += mesh.cell_volumes[static_cast<std::size_t>(cell)];
    return volume;
}

/// Refuses a mesh that createBaffles has cut along the device.
void require_no_baffles(const FoamMesh& mesh, const fs::path& foam_case)
{
    for (const FoamPatch& patch : mesh.patches)
        if (patch.type == "cyclic" && patch.name.starts_with("FD_"))
            throw InputError(
                fmt::format("{}: the mesh holds the baffles of an earlier call (patch {}); give it "
                            "the mesh as it was before createBaffles",
                            foam_case.string(), patch.name));
}

/// Refuses a mesh in millimetres: the device in metres would be lost in one of its cells.
void require_metres(const FoamMesh& mesh, const ResistanceSheet& sheet)
{
    const auto extent = [](const std::vector<Vec3>& points) {
        const Box box = bounding_box({points, {}});
        return (box.upper - box.lower).norm();
    };
    const double mesh_extent = extent(mesh.points), device_extent = extent(sheet.surface.points);
    if (mesh_extent <= 300.0 * device_extent) return;
    throw GeometryError(fmt::format(
        "the mesh is {:.4g} m across and the device {:.4g} m: is the mesh in millimetres? OpenFOAM "
        "reads metres; transformPoints -scale \"(0.001 0.001 0.001)\" makes them of millimetres",
        mesh_extent, device_extent));
}

/// What is wrong with the viscosity of the case, if anything.
std::optional<std::string> viscosity_warning(const fs::path& foam_case, const Fluid& fluid)
{
    const std::optional<double> found = case_viscosity(foam_case);
    const double expected = fluid.viscosity / fluid.density;
    if (!found || std::abs(*found - expected) <= 1e-3 * expected) return std::nullopt;
    return fmt::format(
        "the case has a kinematic viscosity of {:.6g} m^2/s and the resistance belongs to {:.6g} "
        "m^2/s ({:.6g} Pa s over {:.6g} kg/m^3): set fluid.viscosity and fluid.density, or "
        "constant/transportProperties",
        *found, expected, fluid.viscosity, fluid.density);
}

/// A decomposed copy of the mesh does not get the device.
std::optional<std::string> decomposition_warning(const fs::path& foam_case)
{
    if (!fs::exists(foam_case / "processor0")) return std::nullopt;
    return "processor0, ... hold the case without what is written now: run decomposePar -force "
           "again";
}

}  // namespace

FoamApplication apply_to_foam_case(const fs::path& foam_case, const ResistanceSheet& sheet,
                                   const FoamApplyOptions& options)
{
    restore_foam_case(foam_case);
    const FoamMesh mesh = read_foam_mesh(foam_case);
    require_no_baffles(mesh, foam_case);
    require_metres(mesh, sheet);
    const CellResistance resistance = deposit(sheet, mesh, options.deposit);
    const FoamDevice device = make_foam_device(
        sheet, resistance, mesh, {options.form, options.most_zones, options.shear_thinning});
    const std::vector<std::vector<int>> sacs = find_sacs(resistance, mesh);
    const FoamSacZones of_sacs = sac_zones(sacs, mesh);

    FoamApplication result;
    result.num_cells = mesh.num_cells();
    result.num_resistant_cells = static_cast<int>(resistance.cells.size());
    result.num_zones = static_cast<int>(device.zones.size() + device.baffles.size());
    result.integral_sheet = resistance_integral(sheet);
    result.integral_mesh = device.integral;
    for (const std::vector<int>& sac : sacs)
        result.sac_volumes.push_back(volume_of(sac, mesh));
    result.warnings = resistance.warnings;
    append(result.warnings, device.notes);
    for (const auto& warning :
         {viscosity_warning(foam_case, sheet.fluid), decomposition_warning(foam_case)})
        if (warning) result.warnings.push_back(*warning);

    // All that can be wrong with the input has been found; from here on there are files.
    FoamUpdate update(foam_case);
    const fs::path& staging = update.staging();
    prepare_staging(foam_case, staging);
    append(result.files, write_zones(foam_case, staging, device, of_sacs));
    append(result.files, write_porous_sources(staging, device.sources));
    append(result.files, write_directed_fields(staging, device.fields, resistance, mesh,
                                               sheet.fluid.viscosity / sheet.fluid.density));
    const std::string baffles = device.baffles.empty() ? "" : baffle_dict(device.baffles);
    append(result.files, write_unless_empty(staging, "system/fdBaffles", baffles));
    append(result.files,
           write_unless_empty(staging, "system/fdFunctions", device.functions + of_sacs.functions));
    append(result.files, write_inspection_fields(staging, mesh, resistance, device.zones));
    result.files.emplace_back("fd_export.json");
    write_text_file(staging / "fd_export.json",
                    foam_report(result, device, resistance, sheet, options.deposit));
    update.commit(changes_of(foam_case, result.files));
    return result;
}

}  // namespace braidzone
