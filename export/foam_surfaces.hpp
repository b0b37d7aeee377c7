#pragma once

#include "core/vessel.hpp"
#include "porous/resistance_sheet.hpp"

#include <string>
#include <vector>

namespace braidzone {

/// Names of the openings as patches, in the vessel's order: "inlet" and "outlet_1", "outlet_2", ...
std::vector<std::string> patch_names(const Vessel& vessel, int inlet);

/// The closed lumen as one ASCII STL with a named solid for the wall and each opening, in metres,
/// with the digits that give the same values when read again.
std::string vessel_stl(const Vessel& vessel, const std::vector<std::string>& opening_names);

/// The part of the device that meets flow (two triangles a rhombus) as ASCII STL in metres; empty
/// text if there is none.
std::string acting_device_stl(const ResistanceSheet& sheet);

}  // namespace braidzone
