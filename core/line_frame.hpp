#pragma once

#include "core/centerline.hpp"
#include "core/vessel.hpp"
#include "core/wall_tree.hpp"

#include <string>
#include <vector>

namespace braidzone {

/// What must be done to a line that lies off the vessel, to bring it there.
///
/// Tried are the frames that are mixed up in practice, alone and together: x and y negated (RAS and
/// LPS, the frames of 3D Slicer and of DICOM, VMTK and ITK), each axis mirrored, and the factors
/// 10, 1000 and 25.4 of length units (cm, m and inch against mm) and their inverses. One fits if
/// nine tenths of its length lie in the lumen then; of several, the one whose ends come nearest to
/// openings. Nothing is changed.
///
/// @return words for a person, such as "with x and y negated it lies in the lumen: ..."; empty if
///         none fits
std::string fitting_frame(const std::vector<Vec3>& points, const Vessel& vessel,
                          const WallTree& wall);

/// @throws GeometryError if each of the lines is in the lumen for less than half of its length and
///         a frame fits the longest, which is named; or if none of them comes into the lumen
void require_same_frame(const std::vector<Polyline>& lines, const Vessel& vessel,
                        const WallTree& wall);

}  // namespace braidzone
