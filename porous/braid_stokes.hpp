#pragma once

#include "core/fluid.hpp"
#include "porous/range_check.hpp"
#include "porous/rhombus.hpp"
#include "porous/sheet_loss.hpp"

#include <vector>

namespace braidzone {

/// The recommended law: drags of two rows of cylinders, superposed, times a crossing factor.
struct BraidStokesLaw {
    static constexpr const char* name = "braid-stokes";
    bool inertia = true;  ///< with its quadratic part
};

/// Drag of one cylinder of an infinite row across slow flow, over viscosity and mean velocity: the
/// force per length is D = mu v lambda(s), with s the diameter over the spacing.
///
///     lambda = 8 pi / (1 - 2 ln(2 tau) + 2/3 tau^2 - 1/9 tau^4 + 8/135 tau^6 - 53/1350 tau^8),
///     tau = pi s / 2                                     for s <= 0.5
///     lambda = 9 pi / (2 sqrt 2) (1 - s)^(-5/2)          for s >= 0.6
///
/// and between them ln(lambda) linear in s from the series at 0.5 to the lubrication limit at 0.6.
/// The series is that of Tamada and Fujikawa 1957 (Q. J. Mech. Appl. Math. 10:425, doi
/// 10.1093/qjmam/10.4.425) and Miyagi 1958 (doi 10.1143/JPSJ.13.493), the limit that of Keller 1964
/// (J. Fluid Mech. 18:94, doi 10.1017/S0022112064000064). Against a wire-resolved lattice-Boltzmann
/// solution the series is within 1 % to s = 0.5, the limit within 4 % from s = 0.6.
///
/// @param solidity  s [-]; 0 < s < 1
/// @throws InputError outside that range
double row_drag(double solidity);

/// Factor chi by which two crossing rows in touch resist more than two rows far apart:
///
///     chi = 1.020 + 1.07 s - 1.28 s^2,   limited to 1 ... 1.25
///
/// Fit to wire-resolved Stokes flow through orthogonal rows in touch, within 1.5 % for
/// 0.10 <= s <= 0.60. With it the law is within 1.4 % of the finest grids of
/// tests/verification/unit_cell, crossing angles of 42 to 90 degrees. Weave, with wires that
/// interpenetrate each other's layer, would add 1.5 % at s = 0.10, 5 % at 0.18 and 18 % at 0.3.
/// @param mean_solidity  s, mean of both families [-]
double crossing_factor(double mean_solidity);

/// Linear loss of the braid-stokes law: drags of both rows, superposed, times the crossing factor.
///
///     a = mu chi ( lambda(s_a) / p_a + lambda(s_b) / p_b )
///
/// Holds for slow flow (Re_d -> 0) along the normal through one layer of round wires that is flat
/// on the scale of a pore.
/// @param viscosity  mu [Pa s]
/// @return a [Pa s/m]
/// @throws InputError if a family's solidity is 1 or more
double braid_stokes_linear(const Rhombus& rhombus, double viscosity);

/// Quadratic loss of the braid-stokes law:
///
///     b = rho / 2 K_q,   K_q = 0.285 + 1.78 s
///
/// with s the mean solidity. The inertial correction of a screen begins with the cube of the
/// velocity; this is the secant that meets wire-resolved flow at Re_d = 2 (0.2 m/s through the
/// braid): within 12 % for s <= 0.3, 26 % too large at 0.4. At Re_d = 1 it is 1.4 to 2.5 times too
/// large, the whole loss by 3.4 % at most. At 0.05 m/s the quadratic part is some 4 % of the loss.
/// @param density  rho [kg/m^3]
/// @return b [Pa s^2/m^2]
double braid_stokes_quadratic(const Rhombus& rhombus, double density);

/// Both parts; the quadratic one is 0 without `inertia`.
SheetLoss sheet_loss(const BraidStokesLaw& law, const Rhombus& rhombus, const Fluid& fluid);

/// Compared with wire-resolved flow for solidities of each family of 0.10 to 0.40 (metal coverage
/// 0.19 to 0.64) and Re_d up to 4.
std::vector<RangeCheck> range_checks(const BraidStokesLaw& law, const Rhombus& rhombus,
                                     const Fluid& fluid);

}  // namespace braidzone
