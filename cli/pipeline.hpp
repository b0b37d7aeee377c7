#pragma once

#include "cli/case_file.hpp"
#include "cli/progress.hpp"
#include "core/centerline.hpp"
#include "core/vessel.hpp"
#include "core/wall_tree.hpp"
#include "deploy/deployment.hpp"
#include "deploy/neck.hpp"
#include "porous/porous_field.hpp"
#include "porous/resistance_sheet.hpp"

#include <optional>
#include <string>
#include <vector>

namespace braidzone {

/// How far the chain goes. `check` ends where the device lies: no resistance law is applied.
enum class Stage { check, deploy, porous, exports };

/// A device that was deployed inside the first one.
struct SecondDeployment {
    Deployment deployment;  ///< wall distances through the first device to the vessel's wall
    std::vector<WallOpening> openings;
    ResistanceSheet sheet;
};

/// The values of the chain, each made from those before it.
struct Chain {
    Vessel vessel;
    WallTree wall;
    Centerline centerline;
    Deployment deployment;
    std::vector<WallOpening> openings;  ///< as `told_apart` sorts them, the neck first
    ResistanceSheet sheet;              ///< of the device; this and the next empty after `check`
    std::optional<SecondDeployment> second;
    ResistanceSheet resistance;                 ///< of all devices
    std::optional<PorousField> field;           ///< absent if the chain ends before
    std::vector<std::string> centerline_notes;  ///< what was changed of a given centerline
};

/// Deploys the device of a case, measures its braid, and applies the resistance law:
///
///     Vessel + Centerline + FlowDiverter -> Deployment -> BraidSurface -> ResistanceSheet
///         -> PorousField
///
/// A vessel that is straightened (`VesselSource::straightening`) is so before the device is
/// deployed; places on its centerline are those on the vessel as it is given.
///
/// A second device comes to rest on the vessel's wall and on the inner surface of the first one
/// (`device_lining.hpp`), which it does not move.
///
/// @throws ConvergenceError if the deployment does not come to rest; else what the steps throw
Chain run_chain(const Case& job, Stage last, Progress& progress);

/// The vessel's opening where the centerline begins.
int inlet_of(const Chain& chain);

/// Distance from the wall above which a device counts as free of it [m]: three wire diameters,
/// where its resistance acts in full (`ResistanceSheet::acting`).
double wall_gap(const FlowDiverter& device);

}  // namespace braidzone
