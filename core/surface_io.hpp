#pragma once

#include "core/length_unit.hpp"
#include "core/surface_labels.hpp"
#include "core/triangle_mesh.hpp"

#include <filesystem>

namespace braidzone {

/// Reads a triangulated surface: STL (ASCII, binary), VTP, legacy VTK, PLY or OBJ, by the ending
/// of the file name.
///
/// Coincident points are merged (STL repeats each corner). Polygons and strips are triangulated.
/// Nothing is repaired.
///
/// @param path  .stl, .vtp, .vtk, .ply or .obj, upper or lower case
/// @param unit  length unit of the coordinates in the file
/// @return points in metres
/// @throws IoError if the file is missing, unreadable or truncated; InputError if the ending is
///         none of these, there are no triangles, or a coordinate is not finite (with its index)
TriangleMesh read_surface(const std::filesystem::path& path, const LengthUnit& unit);

/// The same with what the file says of its triangles: the first of the cell data `CellEntityIds`
/// (VMTK, Gmsh), `ModelFaceID` and `CapID` (SimVascular) that has two values or more, or the solids
/// of an ASCII STL, numbered from 0. A grid of volume elements gives its boundary, unless it holds
/// surface elements as well (VMTK's meshes do), which then are the surface. Notes say how many
/// polygons and strips were triangulated, and where a boundary was taken.
LabelledSurface read_labelled_surface(const std::filesystem::path& path, const LengthUnit& unit);

/// Writes a binary STL, coordinates in the given unit (single precision).
/// @throws IoError if the file cannot be written
void write_stl(const std::filesystem::path& path, const TriangleMesh& mesh, const LengthUnit& unit);

}  // namespace braidzone
