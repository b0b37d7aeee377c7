#pragma once

#include "core/centerline.hpp"
#include "core/length_unit.hpp"

#include <filesystem>
#include <vector>

namespace braidzone {

/// Reads the centerlines of a file: VTP or legacy VTK as VMTK writes them, or a plain polyline.
///
/// `MaximumInscribedSphereRadius` (point data) is taken if present; VMTK's branch arrays are
/// ignored. Cells of one line that continue each other are joined.
///
/// @param path  .vtp, .vtk, or .csv with x, y, z and optionally radius in columns
/// @param unit  length unit of the coordinates and radii
/// @return at least one line, each with two points or more
/// @throws IoError if the file is missing or unreadable; InputError if there is no line, or a value
///         is not finite
std::vector<Polyline> read_centerlines(const std::filesystem::path& path, const LengthUnit& unit);

/// One of them.
/// @param line  which one to take if there are several; -1: there must be one only
/// @throws InputError also if there is more than one and `line` is -1, or none of that number
Polyline read_centerline(const std::filesystem::path& path, const LengthUnit& unit, int line = -1);

/// Writes a centerline as VTP, as VMTK would: one polyline, MaximumInscribedSphereRadius in point
/// data, coordinates in `unit`. Reading it back gives the same values to double precision.
void write_centerline(const std::filesystem::path& path, const Polyline& polyline,
                      const LengthUnit& unit);

}  // namespace braidzone
