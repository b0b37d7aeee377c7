#pragma once

#include "export/lattice_files.hpp"
#include "export/lattice_nodes.hpp"
#include "export/lattice_units.hpp"

#include <filesystem>
#include <vector>

namespace braidzone {

inline constexpr double hemoflow_viscosity = 3.22e-6;  ///< kinematic [m^2/s], its nuInf
inline constexpr double hemoflow_velocity_lu = 0.05;   ///< mean at the inlet, its U_AVG_LB
inline constexpr double hemoflow_most_drag_lu = 0.9;   ///< above, its explicit force diverges

/// Writes what HemoFlow reads (github.com/gzavo/hemoflow): case.npz, setup.xml and flow.txt.
///
/// The device's resistance there is one pair of constants with a whole-numbered weight a node, so
/// that with S = 1000
///
///     weight = round(S mu D dx / a),   linCoeff = a / S,   quadCoeff = b / S
///
/// a and b the sheet's constants, mean over its area. The weight carries the local linear part to a
/// thousandth; the quadratic part follows in the same ratio, and acts on each component of the
/// velocity by itself.
///
/// HemoFlow has blood of its own (nu = 3.22e-6 m^2/s, 1055 kg/m^3) and a mean inlet velocity of
/// 0.05 in lattice units. The Reynolds number in setup.xml is that of half the peak velocity, the
/// mean of a parabolic profile, and the inlet's diameter. Its force is explicit: stable while nu D
/// dt is below 0.9. Node arrays are written plane by plane.
///
/// @throws ConfigError if an opening is not flat on a face of the box, where HemoFlow wants it, or
/// the
///         resistance is too large for its explicit force; IoError if a file cannot be written
std::vector<LatticeFile> write_hemoflow(const std::filesystem::path& folder,
                                        const LatticeNodes& nodes, const Vessel& vessel,
                                        const Fluid& fluid, const LatticeFlowOptions& flow);

}  // namespace braidzone
