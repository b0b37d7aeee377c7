#pragma once

#include "cli/apposition_notes.hpp"
#include "cli/case_file.hpp"
#include "cli/pipeline.hpp"
#include "core/centerline.hpp"
#include "deploy/deployment.hpp"
#include "deploy/neck.hpp"
#include "porous/resistance_law.hpp"
#include "porous/resistance_sheet.hpp"

#include <string>
#include <vector>

namespace braidzone {

/// What is allowed, and more often a slip than meant:
///
/// - viscosity above 0.1 Pa s (blood has 3.5e-3; 3.5 Pa s is mPa s forgotten), density below
///   500 kg/m^3 (1.056 is g/cm^3 forgotten)
/// - inflow faster than 5 m/s: faster than in any artery
/// - voxels coarser than a tenth of the vessel's mean diameter
/// - a tangential ratio below 1: wires resist along the sheet at least as much as across it
///
/// @param centerline  with the vessel's inscribed radii
/// @return sentences for a person, with key and value
std::vector<std::string> unit_slip_notes(const Case& job, const Centerline& centerline);

/// How many nodes lie outside the vessel, if any do.
/// @param wall  of the vessel, without other devices
std::vector<std::string> outside_notes(const PlacedDevice& placed, const WallTree& wall);

/// How many of the braid's rhombi are turned over, and where the first of them lies on the vessel;
/// none for a sound braid.
/// @param unit  of the place
std::vector<std::string> inversion_notes(const Deployment& deployment, const LengthUnit& unit);

/// How many rhombi are jammed, so that no law holds and that of the nearest cell which is not is
/// taken (`opened_to_limit`): their number, those at the neck, and where the first lies.
/// @param sheet     of the deployment, with the law's losses; none if no law was applied
/// @param openings  behind the device, the neck first
std::vector<std::string> jam_notes(const ResistanceLaw& law, const ResistanceSheet& sheet,
                                   const Deployment& deployment,
                                   const std::vector<WallOpening>& openings,
                                   const LengthUnit& unit);

/// All that a person must know of a case that has been run, as far as the chain went: likely slips
/// of a unit, and for each device how it lies (`apposition_notes`), turned and jammed rhombi, and
/// rhombi outside the law's range.
std::vector<std::string> chain_notes(const Case& job, const Chain& chain);

}  // namespace braidzone
