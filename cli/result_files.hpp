#pragma once

#include "cli/pipeline.hpp"

#include <filesystem>

namespace braidzone {

/// Writes the result files of a run, except its summary: vessel.vtp, view.py (`paraview_view.hpp`),
/// device.vtp, wires.vtp, unrolled.vtp, unrolled.png and residuals.csv (largest force on a free
/// node against the step) always, second_device.vtp and second_wires.vtp for a second device,
/// frames.pvd with its frames if the first device's motion was recorded, the fields if the chain
/// holds one, the OpenFOAM case, the lattice and the surfaces after the last stage; the latter
/// three as far as the case asks for them.
///
/// `openfoam/braidzone` holds a copy of the case with its vessel and centerline, so that the
/// OpenFOAM folder can be taken elsewhere and its Allrun still applies this device.
///
/// @return sentences about what an export cannot express
/// @throws IoError if a file cannot be written
std::vector<std::string> write_results(const Case& job, const Chain& chain, Stage last,
                                       const std::filesystem::path& folder);

/// The files below a folder, relative to it, sorted.
std::vector<std::string> files_in(const std::filesystem::path& folder);

}  // namespace braidzone
