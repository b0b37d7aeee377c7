#pragma once

#include "core/centerline.hpp"
#include "core/length_unit.hpp"

#include <filesystem>

namespace braidzone {

/// Reads a centerline: VTP or legacy VTK as VMTK writes them, or a plain polyline.
///
/// `MaximumInscribedSphereRadius` (point data) is taken if present; VMTK's branch arrays are
/// ignored. A file with several lines (VMTK writes one from the inlet to each outlet) needs
/// `line`; cells of one line that continue each other are joined.
///
/// @param path  .vtp, .vtk, or .csv with x, y, z and optionally radius in columns
/// @param unit  length unit of the coordinates and radii
/// @param line  which line to take if there are several; -1: there must be one only
/// @throws IoError if the file is missing or unreadable; InputError if there is no line, more than
///         one and `line` is -1, or a value is not finite
Polyline read_centerline(const std::filesystem::path& path, const LengthUnit& unit, int line = -1);

/// Writes a centerline as VTP, as VMTK would: one polyline, MaximumInscribedSphereRadius in point
/// data, coordinates in `unit`. Reading it back gives the same values to double precision.
void write_centerline(const std::filesystem::path& path, const Polyline& polyline,
                      const LengthUnit& unit);

}  // namespace braidzone
