#include "export/foam_device.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace braidzone {

namespace {

FoamDevice in_zones(const CellResistance& resistance, const FoamMesh& mesh, int most_zones)
{
    FoamDevice device;
    device.zones = cluster(resistance, mesh, most_zones);
    device.cell_zones = named_zones(device.zones);
    device.sources = zone_sources(device.zones, resistance.tangential_ratio);
    device.integral = resistance_integral(device.zones);
    return device;
}

/// The linear part in every cell; the quadratic part, for which stock solvers know no field, in
/// zones.
FoamDevice in_cells(const CellResistance& resistance, const FoamMesh& mesh, const Fluid& fluid,
                    int most_zones)
{
    CellResistance quadratic = resistance;
    std::fill(quadratic.darcy.begin(), quadratic.darcy.end(), 0.0);
    quadratic.tangential_ratio.linear = resistance.tangential_ratio.quadratic;
    FoamDevice device = in_zones(quadratic, mesh, most_zones);

    device.fields = directed_fields(resistance);
    if (!device.fields.empty()) device.cell_zones.push_back({per_cell_zone, resistance.cells});
    for (const FoamPorousSource& source : per_cell_sources(device.fields))
        device.sources.push_back(source);
    device.functions = directed_field_functions(device.fields);
    device.integral = resistance_integral(resistance, mesh);
    device.notes.push_back(
        fmt::format("the fields hold the viscosity {:.6g} m^2/s: export again if it changes. They "
                    "are for OpenFOAM of openfoam.com, whose controlDict must have functions {{ "
                    "#includeIfPresent \"fdFunctions\" }}",
                    fluid.viscosity / fluid.density));
    return device;
}

/// Pressure jumps; nothing of the device is in the cells.
FoamDevice on_faces(const ResistanceSheet& sheet, const FoamMesh& mesh, int most_groups)
{
    FoamDevice device;
    FoamBaffles baffles = make_baffles(sheet, mesh, most_groups);
    for (const FoamBaffle& baffle : baffles.groups) {
        device.face_zones.push_back(baffle.faces);
        device.integral += baffle.integral;
    }
    device.notes.push_back(
        "the baffles come into the mesh by createBaffles -overwrite -dict system/fdBaffles; they "
        "have no resistance along the braid, and simpleFoam needs relaxation factors of 0.3 for p "
        "and 0.7 for U without SIMPLEC");
    if (baffles.step_ratio > 1.1)
        device.notes.push_back(fmt::format(
            "the mesh does not follow the device: its faces there have {:.3g} times the device's "
            "area, and such steps hinder the flow along the braid to an unknown degree. Let the "
            "mesher make a face zone of the device's surface, or take form = \"zones\"",
            baffles.step_ratio));
    device.baffles = std::move(baffles.groups);
    return device;
}

FoamDevice in_form(const ResistanceSheet& sheet, const CellResistance& resistance,
                   const FoamMesh& mesh, const FoamDeviceOptions& options)
{
    switch (options.form) {
        case FoamForm::per_cell:
            return in_cells(resistance, mesh, sheet.fluid, options.most_zones);
        case FoamForm::baffles:
            return on_faces(sheet, mesh, options.most_zones);
        case FoamForm::zones:
            break;
    }
    return in_zones(resistance, mesh, options.most_zones);
}

void keep_viscosity(FoamDevice& device, const Fluid& fluid)
{
    for (FoamPorousSource& source : device.sources)
        if (source.viscosity_field.empty()) source.viscosity = fluid.viscosity / fluid.density;
    if (!device.baffles.empty())
        device.notes.push_back(
            "blood is shear-thinning and baffles take the viscosity of the flow beside them, which "
            "knows nothing of the shear between the wires: their resistance comes out too high");
}

}  // namespace

FoamDevice make_foam_device(const ResistanceSheet& sheet, const CellResistance& resistance,
                            const FoamMesh& mesh, const FoamDeviceOptions& options)
{
    FoamDevice device = in_form(sheet, resistance, mesh, options);
    device.form = options.form;
    if (options.shear_thinning) keep_viscosity(device, sheet.fluid);
    if (device.sources.empty() && device.baffles.empty())
        device.notes = {
            "the device meets no flow: it lies on the wall everywhere, and no zone is written"};
    return device;
}

}  // namespace braidzone
