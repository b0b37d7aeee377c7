#pragma once

#include "export/foam_resistance.hpp"

#include <vector>

namespace braidzone {

/// Cells of the sacs: those that the device closes off from every inlet and outlet.
///
/// The cells with resistance are taken out of the mesh; what remains falls into connected parts.
/// Parts that touch no patch of type `patch` (inlets, outlets) lie behind the device. Those with at
/// least a quarter of the volume of the cells with resistance are sacs; smaller ones are pockets
/// between the braid and the wall. There is none if the device leaves the wall at an end (flow goes
/// around it) or if a branch leaves behind it, such as the other daughter at a bifurcation.
/// @return of each sac the cell indices, increasing; the largest volume first
std::vector<std::vector<int>> find_sacs(const CellResistance& resistance, const FoamMesh& mesh);

}  // namespace braidzone
