#pragma once

#include "cli/deployment_keys.hpp"
#include "core/carreau_yasuda.hpp"
#include "core/fluid.hpp"
#include "core/length_unit.hpp"
#include "core/opening_orders.hpp"
#include "core/surface_repair.hpp"
#include "core/vector.hpp"
#include "core/vessel_straightening.hpp"
#include "deploy/flow_diverter.hpp"
#include "discrepancy/imaging.hpp"
#include "export/foam_case.hpp"
#include "export/lattice_export.hpp"
#include "export/surfaces_export.hpp"
#include "porous/porous_field.hpp"
#include "porous/resistance_law.hpp"
#include "porous/resistance_sheet.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace braidzone {

/// An end of a centerline: the number of an opening (0: the largest), or a point [m].
using CenterlineEnd = std::variant<int, Vec3>;

/// Where a vessel comes from: [vessel].
struct VesselSource {
    std::filesystem::path surface;
    LengthUnit unit;
    Repairs repair;                      ///< which defects are mended instead of refused
    std::vector<OpeningOrder> openings;  ///< to keep, cap or cut
    /// By which the wall is moved outwards along its normals [m].
    double wall_offset = 0.0;
    VesselStraightening straightening;                ///< after the wall has been moved
    std::optional<std::filesystem::path> centerline;  ///< computed if absent
    int centerline_line = -1;         ///< which line of the file; -1: there must be one only
    bool reverse_centerline = false;  ///< the file's first point is the distal end
    /// Proximal and distal end of a computed centerline. Absent: the two openings, if there are
    /// two. Two points also open a closed surface with rounded ends, see `VesselOptions::ends`.
    std::optional<CenterlineEnd> from, to;
};

/// What to write for solvers: [[export]]. The VTK and OpenVDB files are always written; naming
/// them is allowed.
struct Exports {
    std::optional<FoamCaseOptions> openfoam;  ///< openfoam/; on by default, without any [[export]]
    std::optional<LatticeExportOptions> lattice = {};  ///< lattice/
    std::optional<SurfacesOptions> surfaces = {};      ///< surfaces/
};

/// A device that is deployed inside the first one: [second_device]. Its other options are those of
/// [deployment].
struct SecondDevice {
    FlowDiverter device;
    std::vector<std::string> notes;  ///< as `Case::device_notes`
    PlaceOnCenterline landing_distal = 0.0;
    ReleaseSchedule schedule;
};

/// A case file's content, in SI units.
struct Case {
    std::filesystem::path file;
    VesselSource vessel;
    FlowDiverter device;
    std::vector<std::string> device_notes;  ///< values that are extrapolated or uncertain
    PlaceOnCenterline landing_distal = 0.0;
    ReleaseSchedule schedule;
    DeployOptions deployment;
    std::optional<ArcRange> neck;  ///< found if absent
    std::optional<SecondDevice> second_device;
    Fluid fluid;
    std::optional<CarreauYasuda> rheology;  ///< of the exported flow; Newtonian if absent
    ResistanceLaw law;
    SheetOptions sheet;
    DepositOptions deposit;
    Exports exports;
    Imaging measurement;  ///< how a measured device surface came about; for `diagnose`
};

/// Reads a case file strictly; the README lists its keys.
///
/// @param overrides  "section.key=value", which win over the file
/// @throws IoError if the file cannot be read; ConfigError, with file, line and key, for anything
///         in it that is unknown, missing, of the wrong type or unit, or out of range
Case read_case(const std::filesystem::path& file, const std::vector<std::string>& overrides = {});

}  // namespace braidzone
