#pragma once

#include "core/length_unit.hpp"
#include "deploy/deployment.hpp"
#include "porous/resistance_sheet.hpp"

#include <array>
#include <filesystem>
#include <vector>

namespace braidzone {

/// A shape in which the braid's rhombi are drawn: deployed or unrolled.
struct BraidLayout {
    std::vector<Vec3> points;                 ///< [m]
    std::vector<int> node_of_point;           ///< lattice node whose values each point shows
    std::vector<std::array<int, 4>> corners;  ///< points of each rhombus
};

/// The nodes where they lie in the vessel.
BraidLayout deployed_layout(const Deployment& deployment, const BraidSurface& surface);

/// The unfolded surface of the force-free device: x around (0 to pi D0), y along from the distal
/// end. Rhombi across the cut at x = 0 keep their shape and reach beyond it, so that a node may
/// have two points.
BraidLayout unrolled_layout(const BraidLattice& lattice);

/// Coordinates of a node on the surface of the force-free device: around, 0 to pi D0, and along
/// from the distal end [m].
Vec2 surface_coordinates(const BraidLattice& lattice, int ring, int column);

/// Writes the rhombi in a layout as VTP with the fields that `write_device` lists.
/// @throws IoError if the file cannot be written
void write_braid_cells(const std::filesystem::path& path, const BraidLayout& layout,
                       const Deployment& deployment, const ResistanceSheet& sheet,
                       const LengthUnit& unit);

}  // namespace braidzone
