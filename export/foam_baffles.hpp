#pragma once

#include "export/foam_face_zones.hpp"
#include "export/foam_mesh.hpp"
#include "porous/resistance_sheet.hpp"

#include <string>
#include <vector>

namespace braidzone {

/// Faces with one law of the pressure jump, dp = (mu D + 1/2 rho I |u|) u times a length of 1 m, u
/// the velocity through the face (OpenFOAM's porousBafflePressure).
struct FoamBaffle {
    FoamFaceZone faces;     ///< turned as the normals of the braid
    double darcy = 0.0;     ///< D [1/m^2]
    double inertia = 0.0;   ///< I [1/m]
    double area = 0.0;      ///< of the sheet that the faces stand for [m^2]
    double integral = 0.0;  ///< of the sheet's Darcy coefficient over that area [m]
};

/// The whole device as baffles.
struct FoamBaffles {
    std::vector<FoamBaffle> groups;
    /// k over all faces: 1 where the mesh follows the device, up to sqrt(3) where it forms steps.
    double step_ratio = 1.0;
};

/// The acting part of the sheet as jumps on faces of the mesh.
///
/// A face belongs to the device if the segment between the centres of its two cells crosses the
/// sheet, so that no path through cells passes it unhindered. On a mesh that does not follow the
/// sheet these faces form steps, with more area than the sheet: flow that passes the sheet at v
/// passes the faces at v / k, with
///
///     k = sum |S| / sum |S . n|
///
/// over the faces S of the rhombi around (n their normals). So that the jump is a v + b v^2, the
/// face of a rhombus with D_s and F_s (integrated along the normal) has
///
///     D = k D_s,   I = k^2 F_s.
///
/// Faces are sorted by D and grouped by equal areas of the sheet. Two devices one inside the other
/// add where a segment crosses both.
///
/// Exact for flow across the sheet whatever the mesh's fineness. There is no resistance along it on
/// a mesh that follows the sheet; steps hinder the flow along it as a rough wall does, to an
/// unknown degree (sidewall phantom: 1.5 mm/s in the sac with steps of k = 1.5, 9.1 without, 13.7
/// untreated).
///
/// @param most_groups  >= 1
/// @throws GeometryError if the sheet acts somewhere but no face lies across it
FoamBaffles make_baffles(const ResistanceSheet& sheet, const FoamMesh& mesh, int most_groups);

/// Text of system/fdBaffles, for `createBaffles -overwrite -dict system/fdBaffles`: a pair of
/// cyclic patches FD_0000_front, FD_0000_back for each group, with the boundary condition for p.
std::string baffle_dict(const std::vector<FoamBaffle>& baffles);

}  // namespace braidzone
