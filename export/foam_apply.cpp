#include "export/foam_apply.hpp"

#include "export/foam_inspection.hpp"
#include "export/foam_sac.hpp"
#include "export/foam_sac_zones.hpp"
#include "export/foam_zones.hpp"
#include "export/text_file.hpp"

#include <nlohmann/json.hpp>

namespace braidzone {

namespace {

nlohmann::json quantity(double value, const char* unit)
{
    return {{"value", value}, {"unit", unit}};
}

std::string report(const FoamApplication& result, const std::vector<FoamZone>& zones,
                   const ResistanceSheet& sheet, const FoamApplyOptions& options)
{
    nlohmann::json json;
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
    json["resistance_integral_zones"] = quantity(result.integral_zones, "m");
    json["relative_difference"] =
        result.integral_sheet > 0.0 ? result.integral_zones / result.integral_sheet - 1.0 : 0.0;
    json["sac_volume"] =
        result.sac_volume ? quantity(*result.sac_volume, "m^3") : nlohmann::json(nullptr);
    json["zones"] = nlohmann::json::array();
    for (std::size_t i = 0; i < zones.size(); ++i) {
        const FoamZone& zone = zones[i];
        json["zones"].push_back({{"name", foam_zone_name(i)},
                                 {"num_cells", zone.cells.size()},
                                 {"volume", quantity(zone.volume, "m^3")},
                                 {"darcy", quantity(zone.darcy, "1/m^2")},
                                 {"forchheimer", quantity(zone.forchheimer, "1/m")},
                                 {"normal", {zone.normal.x(), zone.normal.y(), zone.normal.z()}}});
    }
    json["warnings"] = result.warnings;
    return json.dump(2) + "\n";
}

}  // namespace

FoamApplication apply_to_foam_case(const std::filesystem::path& foam_case,
                                   const ResistanceSheet& sheet, const FoamApplyOptions& options)
{
    const FoamMesh mesh = read_foam_mesh(foam_case);
    const CellResistance resistance = deposit(sheet, mesh, options.deposit);
    const std::vector<FoamZone> zones = cluster(resistance, mesh, options.most_zones);
    const std::vector<int> sac = find_sac(resistance, mesh);

    FoamApplication result;
    result.num_cells = mesh.num_cells();
    result.num_resistant_cells = static_cast<int>(resistance.cells.size());
    result.num_zones = static_cast<int>(zones.size());
    result.integral_sheet = resistance_integral(sheet);
    result.integral_zones = resistance_integral(zones);
    result.warnings = resistance.warnings;
    if (zones.empty())
        result.warnings.push_back(
            "the device meets no flow: it lies on the wall everywhere, and no zone is written");

    write_foam_zones(foam_case, zones, sheet.tangential_ratio,
                     options.shear_thinning ? std::optional(sheet.fluid) : std::nullopt);
    const auto sac_files = write_sac_zones(foam_case, mesh, sac);
    result.files = {"constant/polyMesh/cellZones", "constant/fvOptions", "constant/fvModels"};
    result.files.insert(result.files.end(), sac_files.begin(), sac_files.end());
    if (!sac.empty()) {
        double volume = 0.0;
        for (const int cell : sac)
            volume += mesh.cell_volumes[static_cast<std::size_t>(cell)];
        result.sac_volume = volume;
    }
    for (const auto& file : write_inspection_fields(foam_case, mesh, resistance, zones))
        result.files.push_back(file);
    result.files.emplace_back("fd_export.json");
    write_text_file(foam_case / "fd_export.json", report(result, zones, sheet, options));
    return result;
}

}  // namespace braidzone
