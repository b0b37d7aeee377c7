#pragma once

#include "core/length_unit.hpp"
#include "deploy/deployment.hpp"
#include "porous/resistance_sheet.hpp"

#include <filesystem>

namespace braidzone {

/// Writes `device.vtp`: the braid surface in the vessel's length unit, points the wire crossings,
/// cells the rhombic pores (quadrilaterals, anticlockwise from outside).
///
/// Point fields: wall_contact (0/1), wall_distance [m], contact_force [N], contact_pressure [Pa],
/// radial_expansion [m], surface_coordinates (2: around and along the force-free device [m]).
/// Cell fields: metal_coverage, surface_porosity, surface_density_increase, pore_density [1/m^2],
/// pore_area [m^2], inscribed_diameter, hydraulic_diameter [m], wire_spacing_a, wire_spacing_b [m],
/// densest_solidity (1: jammed), wire_length_per_area [1/m], metal_volume_per_area [m],
/// braid_angle [rad, from the circumference], crossing_angle, jamming_angle [rad],
/// pressure_loss_linear [Pa s/m], pressure_loss_quadratic [Pa s^2/m^2], resistance_acting (0 on the
/// wall to 1), contact_pressure [Pa], normal; see `Rhombus` and `ResistanceSheet`.
/// Field data: `length_unit` and, as strings `unit:<array>`, the unit of each array.
/// @throws IoError if the file cannot be written
void write_device(const std::filesystem::path& path, const Deployment& deployment,
                  const ResistanceSheet& sheet, const LengthUnit& unit);

}  // namespace braidzone
