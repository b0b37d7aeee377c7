#pragma once

#include "core/centerline.hpp"
#include "core/wall_tree.hpp"

#include <vector>

namespace braidzone {

/// Normals for the planes of rings that do not cross within the lumen.
///
/// Planes across a vessel meet at the centre of its bend, inside the lumen where that is as wide as
/// the bend. Rings of a braid do not: their wires jam, and they lag behind the bend, tilted. With t
/// the tangents at the rings, h from a ring to the one distal of it and r the reach, how far from
/// the hubs nodes lie where the planes lean towards each other, the normals are those that
///
///     minimise  sum |u_k - t_k|^2   subject to   |u_k - u_k+1| <= (h . (u_k + u_k+1) / 2 - g) / r
///
/// over unit vectors: then no node within the reach is nearer than g to the next ring's plane
/// (to second order in the tilt). In a bend of radius R rings at spacing L stay across the vessel
/// where r / R < 1 - g / L; else they turn by (L - g) / r each, ahead of the bend in its first half
/// and behind in its second.
///
/// The constraint acts by a penalty that lets it be passed by about a thousandth of the turn, so
/// that the normals are continuously differentiable in hubs and tangents. Newton's method, whose
/// systems are block tridiagonal. Where no constraint is active the normals are the tangents
/// themselves.
///
/// @param rings        hubs and tangents, distal first
/// @param reaches      r, from each ring to the next [m]; > 0
/// @param least_gaps   g, from each ring to the next [m]
std::vector<Vec3> uncrossed_normals(const std::vector<CrossSection>& rings,
                                    const std::vector<double>& reaches,
                                    const std::vector<double>& least_gaps);

/// How far nodes of each ring lie towards the next ring's plane, between each ring and the next
/// [m]: the lumen's extent from the hub towards the inside of the bend, the largest over directions
/// e of min(wall distance, R0) e . e_in, smoothed along the vessel over a quarter of the nominal
/// radius. R0 where the vessel is straight.
/// @param nominal_radius  R0 [m]
std::vector<double> inner_reaches(const std::vector<CrossSection>& rings, const WallTree& wall,
                                  double nominal_radius);

/// The rings in planes that do not cross within the lumen: each turned about its hub by the least
/// rotation that takes its tangent to its place in `uncrossed_normals`. Where no plane can cross
/// another within the nominal radius, the rings as they are, at no cost.
/// @param nominal_radius  R0 [m]
/// @param least_gaps      from each ring to the next [m]
std::vector<CrossSection> uncrossed_rings(std::vector<CrossSection> rings, const WallTree& wall,
                                          double nominal_radius,
                                          const std::vector<double>& least_gaps);

}  // namespace braidzone
