#pragma once

namespace braidzone {

/// Length of a force-free braid over its nominal length, at radius R:
///
///     L / L0 = sqrt(t^2 + 1 - (R/R0)^2) / t
///
/// Zavodszky et al. 2020, Figure 2: surface springs at rest length. It is also the law of a braid
/// of inextensible helical wires whose ends do not turn.
///
/// @param braid_ratio   t [-]; > 0
/// @param radius_ratio  R / R0 [-]; 0 to sqrt(1 + t^2), where the length becomes 0
/// @throws InputError outside that range
double length_ratio(double braid_ratio, double radius_ratio);

/// Radius of a force-free braid over its nominal radius, when its rings are held at lambda times
/// their nominal spacing:
///
///     R / R0 = sqrt(1 + t^2 (1 - lambda^2))
///
/// @param braid_ratio    t [-]; > 0
/// @param spacing_ratio  lambda [-]; 0 to sqrt(1 + t^2) / t
/// @throws InputError outside that range
double radius_ratio(double braid_ratio, double spacing_ratio);

}  // namespace braidzone
