#pragma once

namespace braidzone {

/// By how much a stock collocated solver under-predicts the pressure drop of a layer of resistance,
/// relative to its own [-]; negative: the drop comes out too low.
///
/// Interpolated in a table measured with simpleFoam of OpenFOAM v1912 on a uniform layer (1 to 3
/// cells) and on one spread by the cosine kernel (4 to 8 cells), at dp = K rho U^2 / 2 with K of 2
/// to 300: linear in log K, and in 1 / n^2 between the numbers of cells; beyond 8 cells it falls
/// with 1 / n^2. Below one cell, and for K outside the table, the nearest value.
///
/// @param cells_across  n, cells across the layer; > 0
/// @param loss_factor   K = dp / (rho U^2 / 2) [-]; > 0
double thin_layer_error(double cells_across, double loss_factor);

}  // namespace braidzone
