#pragma once

#include "export/lattice_files.hpp"
#include "export/lattice_nodes.hpp"
#include "export/lattice_units.hpp"

#include <filesystem>
#include <vector>

namespace braidzone {

/// Quadratic over linear part of the drag in LBPM, b K^(1/2) with K in node spacings squared: the
/// constant 1.75 / sqrt(150) of Ergun's correlation at a porosity of 1, which no input changes.
inline constexpr double lbpm_ergun_constant = 0.14288690166235206;

/// Sum of LBPM's own quadratic drag over the device's nodes, over the sum of the sheet's:
///
///     sum 0.1429 sqrt(D) dx / sum (F dx / 2)
///
/// @return 0 if there is none; infinite if the sheet has no quadratic part
double lbpm_quadratic_ratio(const LatticeNodes& nodes);

/// Writes what LBPM's greyscale simulator reads (github.com/OPM/LBPM, models/GreyscaleModel.cpp,
/// common/Domain.cpp), of the part of the lattice between the openings, x fastest: labels_u8.raw (0
/// solid, 1 fluid and openings, 2 device), porosity_f64.raw, permeability_vox2_f64.raw, input.db.
///
/// Drag there is nu eps / K and acts only where the porosity eps is not 1; a porosity that changes
/// would change the pressure with it. So in the device's nodes eps = 0.999999 and
///
///     K = eps / (D dx^2)   [node spacings squared]
///
/// elsewhere both are 1. The linear part is exact; the quadratic one is LBPM's own
/// (`lbpm_quadratic_ratio`), and both are the same along and across the sheet.
///
/// The collision is MRT: the default IMRT diverges between two densities (tried with relaxation
/// times of 0.52 to 1). Measured with LBPM 2c31340 on an exported sheet of 490 Pa s/m in plug flow:
/// the pressure is (a + b |u|) u within 0.005 %, b being LBPM's own.
///
/// Flow is driven by the density at the first and the last plane of z, which are the openings; the
/// density in input.db is that of Poiseuille flow through the inlet's radius over the length of
/// the box with half the peak velocity for a mean. Files hold one plane at a time.
///
/// @throws ConfigError if the openings do not lie flat on the lower and the upper face across z,
///         the inlet alone on one of them; IoError if a file cannot be written
std::vector<LatticeFile> write_lbpm(const std::filesystem::path& folder, const LatticeNodes& nodes,
                                    const Vessel& vessel, const LatticeUnits& units,
                                    const LatticeFlowOptions& flow);

}  // namespace braidzone
