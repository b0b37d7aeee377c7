#pragma once

#include "core/fluid.hpp"
#include "porous/sheet_loss.hpp"

namespace braidzone {

/// Loss of a narrow slit between the edge of a sheet and the wall of its channel, with v the mean
/// velocity in the slit of width h and length t along the flow:
///
///     dp = mu (32 / (pi h) + 12 t / h^2) v + rho / (2 Cd^2) v^2,   Cd = 0.61
///
/// The first part is that of slow flow through a slit in a thin wall (Hasimoto 1958, J. Phys. Soc.
/// Japan 13:633, doi 10.1143/JPSJ.13.633), the second that of slow flow between plates; their sum
/// for a slit of some length is what Dagan et al. 1982 (J. Fluid Mech. 115:505) found within 1 %
/// for round holes. The last is that of a sharp-edged orifice of free discharge, Cd = pi / (pi +
/// 2). Joining the laws of slow and of fast flow by a sum is an estimate, good to some 20 % between
/// them.
/// @param width   h [m]; > 0
/// @param length  t [m]; >= 0
/// @throws InputError if the width is not positive
SheetLoss slit_loss(double width, double length, const Fluid& fluid);

/// Velocity at which a loss takes a pressure drop, both positive [m/s]; the positive root of
/// b v^2 + a v = dp.
double velocity_at(const SheetLoss& loss, double pressure_drop);

/// Pressure drop over two parallel paths, of a sheet and of a gap beside it, at a mean velocity v:
///
///     dp = dp_sheet(v_s) = dp_gap(v_g),   (1 - g) v_s + g v_g = v
///
/// with g the gap's share of the channel's section. Found by bisection to the last digit.
/// @param gap_share  g [-]; 0 <= g < 1
/// @param velocity   v [m/s]; odd in it
/// @return dp [Pa]
/// @throws InputError if g is out of range
double parallel_pressure_drop(const SheetLoss& sheet, const SheetLoss& gap, double gap_share,
                              double velocity);

}  // namespace braidzone
