#pragma once

#include "core/opening.hpp"
#include "core/triangle_mesh.hpp"

#include <string>
#include <vector>

namespace braidzone {

/// A surface as a file holds it: its triangles, and what the file says of them.
struct LabelledSurface {
    TriangleMesh mesh;               ///< [m]
    std::vector<int> labels;         ///< one a triangle, or none: the file's regions
    std::string label_name;          ///< what the file calls them: "CellEntityIds", ...
    std::vector<std::string> notes;  ///< what reading changed: polygons triangulated, ...
};

/// A region of one label that closes an end of the vessel.
struct LabelledCap {
    int label = 0;
    std::vector<int> triangles;
    Opening opening;  ///< its rim, in the surface's points
};

/// What the labels of a surface tell.
struct LabelledCaps {
    std::vector<LabelledCap> caps;
    std::vector<std::string> notes;  ///< regions of a label that are no caps
};

/// Finds the caps that a surface's labels name: VMTK and Gmsh write them as `CellEntityIds`,
/// SimVascular as `ModelFaceID` and `CapID`, an ASCII STL as several solids. Programs number the
/// wall differently, so it is the label of the largest area.
///
/// A connected region of another label is a cap, of any shape, if it is a disc (one rim, Euler
/// characteristic 1) whose area is at most 2.5 times that of its rim's polygon (a half sphere has
/// 2; a sac with a neck has more) and if a tube lies behind its rim (`lumen_behind`). Other
/// regions, a sac or a branch with a label of its own, belong to the wall.
///
/// @param surface  normals out of the lumen
LabelledCaps labelled_caps(const LabelledSurface& surface);

}  // namespace braidzone
