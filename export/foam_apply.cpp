#include "export/foam_apply.hpp"

#include "core/error.hpp"
#include "core/triangle_mesh.hpp"
#include "export/foam_baffles.hpp"
#include "export/foam_cell_zones.hpp"
#include "export/foam_face_zones.hpp"
#include "export/foam_inspection.hpp"
#include "export/foam_neck.hpp"
#include "export/foam_per_cell.hpp"
#include "export/foam_porous_source.hpp"
#include "export/foam_sac.hpp"
#include "export/foam_sac_zones.hpp"
#include "export/foam_thin_layer.hpp"
#include "export/foam_viscosity.hpp"
#include "export/foam_zones.hpp"
#include "export/text_file.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <optional>

namespace braidzone {

namespace {

using Json = nlohmann::ordered_json;

const std::filesystem::path functions_file = std::filesystem::path("system") / "fdFunctions";
const std::filesystem::path baffles_file = std::filesystem::path("system") / "fdBaffles";

template <typename Item>
void append(std::vector<Item>& list, const std::vector<Item>& more)
{
    list.insert(list.end(), more.begin(), more.end());
}

Json quantity(double value, const char* unit)
{
    return {{"value", value}, {"unit", unit}};
}

/// Zones that a call writes and the next one replaces.
bool is_device_zone(const std::string& name)
{
    return name == per_cell_zone || name.starts_with("FD_") || name == sac_cells_zone ||
           name == sac_neck_zone || name == sac_wall_zone;
}

/// Those of the mesh, then those of the device.
template <typename Zone>
std::vector<Zone> merged(std::vector<Zone> zones, const std::vector<Zone>& device_zones)
{
    std::erase_if(zones, [](const Zone& zone) { return is_device_zone(zone.name); });
    zones.insert(zones.end(), device_zones.begin(), device_zones.end());
    return zones;
}

/// Refuses a mesh that createBaffles has cut along the device.
void require_no_baffles(const FoamMesh& mesh, const std::filesystem::path& foam_case)
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

/// What a form puts into a case.
struct DeviceInCase {
    std::vector<FoamZone> zones;
    Json groups = Json::array();  ///< zones or baffles, for the report
    std::vector<FoamCellZone> cell_zones;
    std::vector<FoamFaceZone> face_zones;
    std::vector<FoamPorousSource> sources;
    std::string functions;
    double integral = 0.0;  ///< of what is written [m]
    std::vector<std::filesystem::path> files;
    std::vector<std::string> notes;
};

DeviceInCase in_zones(const CellResistance& resistance, const FoamMesh& mesh, int most_zones)
{
    DeviceInCase device;
    device.zones = cluster(resistance, mesh, most_zones);
    device.cell_zones = named_zones(device.zones);
    device.sources = zone_sources(device.zones, resistance.tangential_ratio);
    device.integral = resistance_integral(device.zones);
    for (std::size_t i = 0; i < device.zones.size(); ++i) {
        const FoamZone& zone = device.zones[i];
        device.groups.push_back({{"name", foam_zone_name(i)},
                                 {"num_cells", zone.cells.size()},
                                 {"volume", quantity(zone.volume, "m^3")},
                                 {"darcy", quantity(zone.darcy, "1/m^2")},
                                 {"forchheimer", quantity(zone.forchheimer, "1/m")},
                                 {"normal", {zone.normal.x(), zone.normal.y(), zone.normal.z()}}});
    }
    return device;
}

/// The linear part in every cell; the quadratic part, for which stock solvers know no field, in
/// zones.
DeviceInCase in_cells(const std::filesystem::path& foam_case, const CellResistance& resistance,
                      const FoamMesh& mesh, const Fluid& fluid, int most_zones)
{
    CellResistance quadratic = resistance;
    std::fill(quadratic.darcy.begin(), quadratic.darcy.end(), 0.0);
    quadratic.tangential_ratio.linear = resistance.tangential_ratio.quadratic;
    DeviceInCase device = in_zones(quadratic, mesh, most_zones);

    const auto fields = directed_fields(resistance);
    if (!fields.empty()) device.cell_zones.push_back({per_cell_zone, resistance.cells});
    const auto sources = per_cell_sources(fields);
    append(device.sources, sources);
    const double viscosity = fluid.viscosity / fluid.density;
    device.files = write_directed_fields(foam_case, fields, resistance, mesh, viscosity);
    device.functions = directed_field_functions(fields);
    device.integral = resistance_integral(resistance, mesh);
    device.notes.push_back(
        fmt::format("the fields hold the viscosity {:.6g} m^2/s: export again if it changes. They "
                    "are for OpenFOAM of openfoam.com, whose controlDict must have functions {{ "
                    "#includeIfPresent \"fdFunctions\" }}",
                    viscosity));
    return device;
}

/// The device as pressure jumps; nothing of it is in the cells.
DeviceInCase on_faces(const std::filesystem::path& foam_case, const ResistanceSheet& sheet,
                      const FoamMesh& mesh, int most_zones)
{
    DeviceInCase device;
    const auto [baffles, step_ratio] = make_baffles(sheet, mesh, most_zones);
    for (const FoamBaffle& baffle : baffles) {
        device.face_zones.push_back(baffle.faces);
        device.integral += baffle.integral;
        device.groups.push_back({{"name", baffle.faces.name},
                                 {"num_faces", baffle.faces.faces.size()},
                                 {"area", quantity(baffle.area, "m^2")},
                                 {"darcy", quantity(baffle.darcy, "1/m^2")},
                                 {"forchheimer", quantity(baffle.inertia, "1/m")}});
    }
    write_text_file(foam_case / baffles_file, baffle_dict(baffles));
    device.files = {baffles_file};
    device.notes.push_back(
        "the baffles come into the mesh by createBaffles -overwrite -dict system/fdBaffles; they "
        "have no resistance along the braid, and simpleFoam needs relaxation factors of 0.3 for p "
        "and 0.7 for U without SIMPLEC");
    if (step_ratio > 1.1)
        device.notes.push_back(fmt::format(
            "the mesh does not follow the device: its faces there have {:.3g} times the device's "
            "area, and such steps hinder the flow along the braid to an unknown degree. Let the "
            "mesher make a face zone of the device's surface, or take form = \"zones\"",
            step_ratio));
    return device;
}

DeviceInCase put(const FoamApplyOptions& options, const ResistanceSheet& sheet,
                 const CellResistance& resistance, const FoamMesh& mesh,
                 const std::filesystem::path& foam_case)
{
    switch (options.form) {
        case FoamForm::per_cell:
            return in_cells(foam_case, resistance, mesh, sheet.fluid, options.most_zones);
        case FoamForm::baffles:
            return on_faces(foam_case, sheet, mesh, options.most_zones);
        case FoamForm::zones:
            break;
    }
    return in_zones(resistance, mesh, options.most_zones);
}

/// What is wrong with the viscosity of the case, if anything.
std::optional<std::string> viscosity_warning(const std::filesystem::path& foam_case,
                                             const Fluid& fluid)
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
std::optional<std::string> decomposition_warning(const std::filesystem::path& foam_case)
{
    if (!std::filesystem::exists(foam_case / "processor0")) return std::nullopt;
    return "processor0, ... hold the case without what is written now: run decomposePar -force "
           "again";
}

/// The expected error of the pressure drop at some velocities through the device's mean resistance.
Json thin_layer_errors(double cells_across, const ResistanceSheet& sheet)
{
    auto errors = Json::array();
    const std::optional<SheetLoss> loss = mean_acting_loss(sheet);
    if (!loss || !(cells_across > 0.0)) return errors;
    for (const double velocity : {0.01, 0.03, 0.1}) {
        const double loss_factor =
            2.0 * (loss->linear / velocity + loss->quadratic) / sheet.fluid.density;
        if (!(loss_factor > 0.0)) continue;
        errors.push_back({{"velocity_m_s", velocity},
                          {"loss_factor", loss_factor},
                          {"relative_error", thin_layer_error(cells_across, loss_factor)}});
    }
    return errors;
}

std::string report(const FoamApplication& result, const DeviceInCase& device,
                   const CellResistance& resistance, const ResistanceSheet& sheet,
                   const FoamApplyOptions& options)
{
    const FoamFormTraits& form = traits_of(options.form);
    Json json;
    json["form"] = {{"name", form.name}, {"keeps", form.keeps}, {"loses", form.loses}};
    json["convention"] =
        "S = -(mu D + 1/2 rho |U| F) U per volume; D, F along the zone's normal, and "
        "tangential_ratio times that along the sheet (F: tangential_ratio_quadratic times)";
    json["tangential_ratio"] = sheet.tangential_ratio.linear;
    json["tangential_ratio_quadratic"] = sheet.tangential_ratio.quadratic;
    json["viscosity"] = quantity(sheet.fluid.viscosity, "Pa s");
    json["density"] = quantity(sheet.fluid.density, "kg/m^3");
    json["kernel_half_width_cells"] = options.deposit.kernel_half_width;
    json["num_cells"] = result.num_cells;
    json["num_resistant_cells"] = result.num_resistant_cells;
    json["resistance_integral_surface"] = quantity(result.integral_sheet, "m");
    json["resistance_integral_mesh"] = quantity(result.integral_mesh, "m");
    json["relative_difference"] =
        result.integral_sheet > 0.0 ? result.integral_mesh / result.integral_sheet - 1.0 : 0.0;
    json["cells_across"] = resistance.cells_across;
    json["thin_layer_error"] = thin_layer_errors(resistance.cells_across, sheet);
    json["sac_volume"] = result.sac_volume ? quantity(*result.sac_volume, "m^3") : Json(nullptr);
    json["zones"] = device.groups;
    json["warnings"] = result.warnings;
    return json.dump(2) + "\n";
}

}  // namespace

FoamApplication apply_to_foam_case(const std::filesystem::path& foam_case,
                                   const ResistanceSheet& sheet, const FoamApplyOptions& options)
{
    const FoamMesh mesh = read_foam_mesh(foam_case);
    require_no_baffles(mesh, foam_case);
    require_metres(mesh, sheet);
    const CellResistance resistance = deposit(sheet, mesh, options.deposit);
    const std::vector<int> sac = find_sac(resistance, mesh);

    remove_directed_fields(foam_case);
    std::filesystem::remove(foam_case / baffles_file);
    DeviceInCase device = put(options, sheet, resistance, mesh, foam_case);
    const FoamSacZones of_sac = sac_zones(sac, mesh);
    append(device.cell_zones, of_sac.cells);
    append(device.face_zones, of_sac.faces);
    device.functions += of_sac.functions;
    write_cell_zones(foam_case, merged(read_cell_zones(foam_case), device.cell_zones));
    const std::vector<FoamFaceZone> mesh_faces = read_face_zones(foam_case);
    if (!mesh_faces.empty() || !device.face_zones.empty())
        write_face_zones(foam_case, merged(mesh_faces, device.face_zones));

    FoamApplication result;
    result.num_cells = mesh.num_cells();
    result.num_resistant_cells = static_cast<int>(resistance.cells.size());
    result.num_zones = static_cast<int>(device.groups.size());
    result.integral_sheet = resistance_integral(sheet);
    result.integral_mesh = device.integral;
    result.warnings = resistance.warnings;
    append(result.warnings, device.notes);
    if (device.groups.empty() && device.sources.empty())
        result.warnings.push_back(
            "the device meets no flow: it lies on the wall everywhere, and no zone is written");
    for (const auto& warning :
         {viscosity_warning(foam_case, sheet.fluid), decomposition_warning(foam_case)})
        if (warning) result.warnings.push_back(*warning);

    result.files = {"constant/polyMesh/cellZones"};
    if (!device.face_zones.empty()) result.files.emplace_back("constant/polyMesh/faceZones");
    append(result.files, write_porous_sources(foam_case, device.sources));
    append(result.files, device.files);
    if (!sac.empty()) {
        double volume = 0.0;
        for (const int cell : sac)
            volume += mesh.cell_volumes[static_cast<std::size_t>(cell)];
        result.sac_volume = volume;
    }
    if (device.functions.empty()) {
        std::filesystem::remove(foam_case / functions_file);
    } else {
        write_text_file(foam_case / functions_file, device.functions);
        result.files.push_back(functions_file);
    }
    append(result.files, write_inspection_fields(foam_case, mesh, resistance, device.zones));
    result.files.emplace_back("fd_export.json");
    write_text_file(foam_case / "fd_export.json",
                    report(result, device, resistance, sheet, options));
    return result;
}

}  // namespace braidzone
