#include "export/foam_report.hpp"

#include "export/foam_thin_layer.hpp"

#include <nlohmann/json.hpp>

#include <optional>

namespace braidzone {

namespace {

using Json = nlohmann::ordered_json;

Json quantity(double value, const char* unit)
{
    return {{"value", value}, {"unit", unit}};
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

/// Zones or baffles with their coefficients.
Json groups(const FoamDevice& device)
{
    Json all = Json::array();
    for (std::size_t i = 0; i < device.zones.size(); ++i) {
        const FoamZone& zone = device.zones[i];
        all.push_back({{"name", foam_zone_name(i)},
                       {"num_cells", zone.cells.size()},
                       {"volume", quantity(zone.volume, "m^3")},
                       {"darcy", quantity(zone.darcy, "1/m^2")},
                       {"forchheimer", quantity(zone.forchheimer, "1/m")},
                       {"normal", {zone.normal.x(), zone.normal.y(), zone.normal.z()}}});
    }
    for (const FoamBaffle& baffle : device.baffles)
        all.push_back({{"name", baffle.faces.name},
                       {"num_faces", baffle.faces.faces.size()},
                       {"area", quantity(baffle.area, "m^2")},
                       {"darcy", quantity(baffle.darcy, "1/m^2")},
                       {"forchheimer", quantity(baffle.inertia, "1/m")}});
    return all;
}

}  // namespace

std::string foam_report(const FoamApplication& result, const FoamDevice& device,
                        const CellResistance& resistance, const ResistanceSheet& sheet,
                        const FoamDepositOptions& deposit)
{
    const FoamFormTraits& form = traits_of(device.form);
    Json json;
    json["form"] = {{"name", form.name}, {"keeps", form.keeps}, {"loses", form.loses}};
    json["convention"] =
        "S = -(mu D + 1/2 rho |U| F) U per volume; D, F along the zone's normal, and "
        "tangential_ratio times that along the sheet (F: tangential_ratio_quadratic times)";
    json["tangential_ratio"] = sheet.tangential_ratio.linear;
    json["tangential_ratio_quadratic"] = sheet.tangential_ratio.quadratic;
    json["viscosity"] = quantity(sheet.fluid.viscosity, "Pa s");
    json["density"] = quantity(sheet.fluid.density, "kg/m^3");
    json["kernel_half_width_cells"] = deposit.kernel_half_width;
    json["num_cells"] = result.num_cells;
    json["num_resistant_cells"] = result.num_resistant_cells;
    json["resistance_integral_surface"] = quantity(result.integral_sheet, "m");
    json["resistance_integral_mesh"] = quantity(result.integral_mesh, "m");
    json["relative_difference"] =
        result.integral_sheet > 0.0 ? result.integral_mesh / result.integral_sheet - 1.0 : 0.0;
    json["cells_across"] = resistance.cells_across;
    json["thin_layer_error"] = thin_layer_errors(resistance.cells_across, sheet);
    // Of the largest sac, and of all.
    json["sac_volume"] =
        result.sac_volumes.empty() ? Json(nullptr) : quantity(result.sac_volumes.front(), "m^3");
    json["sac_volumes"] = {{"value", result.sac_volumes}, {"unit", "m^3"}};
    json["zones"] = groups(device);
    json["warnings"] = result.warnings;
    return json.dump(2) + "\n";
}

}  // namespace braidzone
