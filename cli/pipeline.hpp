#pragma once

#include "cli/case_file.hpp"
#include "cli/progress.hpp"
#include "core/centerline.hpp"
#include "core/vessel.hpp"
#include "core/wall_tree.hpp"
#include "deploy/deployment.hpp"
#include "porous/porous_field.hpp"
#include "porous/resistance_sheet.hpp"

#include <optional>

namespace braidzone {

/// How far the chain goes.
enum class Stage { deploy, porous, exports };

/// The values of the chain, each made from those before it.
struct Chain {
    Vessel vessel;
    WallTree wall;
    Centerline centerline;
    Deployment deployment;
    ResistanceSheet sheet;
    std::optional<PorousField> field;  ///< absent if the chain ends with the deployment
};

/// Deploys the device of a case, measures its braid, and applies the resistance law:
///
///     Vessel + Centerline + FlowDiverter -> Deployment -> BraidSurface -> ResistanceSheet
///         -> PorousField
///
/// @throws ConvergenceError if the deployment does not come to rest; else what the steps throw
Chain run_chain(const Case& job, Stage last, Progress& progress);

/// Distance from the wall above which a device counts as free of it [m]: three wire diameters,
/// where its resistance acts in full (`ResistanceSheet::acting`).
double neck_gap(const FlowDiverter& device);

}  // namespace braidzone
