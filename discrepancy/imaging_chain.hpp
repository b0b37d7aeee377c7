#pragma once

#include "core/vector.hpp"
#include "deploy/deployment.hpp"

#include <vector>

namespace braidzone {

/// How a volume was made in which the device was segmented. All 0: the surface was not segmented in
/// a volume, or not in one that is known.
struct ImagingChain {
    double voxel_size = 0.0;  ///< edge of a voxel [m]; >= 0
    /// Full width at half maximum of the scanner's point spread, reconstruction kernel included
    /// [m]; >= 0
    double blur = 0.0;
    /// Grey value of the segmented surface above the background, over the largest that a flat piece
    /// of the device has in the volume [-]; above 0, below 1.
    double threshold = 0.5;

    bool is_known() const { return voxel_size > 0.0 || blur > 0.0; }
};

/// @throws ConfigError if a length is negative or not finite, or the threshold not between 0 and 1
void validate(const ImagingChain& chain);

/// Standard deviation of the blur of point spread and voxel together [m]:
///
///     sigma^2 = (blur^2 / (8 ln 2)) + h^2 / 12
///
/// with h the voxel's edge. A voxel's value is the mean over its box, which has the variance
/// h^2 / 12 along each axis and, oblique to them, along any direction; its shape matters only from
/// the fourth moment on.
double blur_deviation(const ImagingChain& chain);

/// Standard deviation s of what the segmented surface is drawn in [m]. Between voxels a contouring
/// like marching cubes takes the grey value as linear along their edges, which on average over
/// positions and orientations of the surface adds the variance h^2 / 12:
///
///     s^2 = sigma^2 + h^2 / 12
double drawn_deviation(const ImagingChain& chain);

/// How far the segmented surface of a flat sheet lies from its middle [m]: the u > 0 at which its
/// blurred grey profile has fallen to the threshold,
///
///     P(u, s) = threshold P(0, sigma),   P(u, s) = Phi((u + T/2) / s) - Phi((u - T/2) / s)
///
/// with Phi the normal distribution, T the sheet's thickness, sigma that of `blur_deviation` and s
/// that of `drawn_deviation`.
///
/// A sheet far thinner than sigma has u = s sqrt(2 ln(sigma / (threshold s))), which is half the
/// full width at half maximum, 1.18 sigma, at a threshold of a half and small voxels; one far
/// thicker has u = T / 2 there. A threshold near 1 that no voxel between two others reaches gives
/// u = 0.
/// @param thickness  T [m]; > 0
double apparent_half_thickness(const ImagingChain& chain, double thickness);

/// By which blurring moves a curved sheet along its normals [m], negative towards the hollow side.
///
/// At lateral distances x, y from a point of the sheet, the sheet lies h = -(k1 x^2 + k2 y^2) / 2
/// off the tangent plane, so that a blur of deviation s has there the profile of a flat sheet,
/// moved by the mean of h under the blur's weight:
///
///     shift = -s^2 (k1 + k2) / 2
///
/// to first order in s times the curvatures k1, k2: -s^2 / (2 R) on a cylinder and -s^2 / R on a
/// sphere of radius R, on both faces alike. That is 5 um for s = 0.14 mm on a braid of 2 mm, and
/// several times as much on the shoulder of a neck. The mean is taken over the crossings of the
/// wires around each, weighted by their area and exp(-d^2 / (2 s^2)), d the distance: no curvature
/// of a lattice of flat rhombi is needed.
/// @param deviation   s [m]; > 0. Of the contour's share of `drawn_deviation` only half acts here,
///                    which is below a micrometre for voxels up to 0.2 mm.
/// @param deployment  on the lattice of the crossings
/// @return |N| shift of each node along its normal (`node_normals.hpp`)
std::vector<double> blur_shifts(const Deployment& deployment, double deviation);

/// A device's surface as it shows in a volume.
struct ImagedSheet {
    std::vector<Vec3> middle;     ///< |N| x 3 nodes, where the blurred sheet's middle lies [m]
    double half_thickness = 0.0;  ///< of what is segmented, from there to the outer face [m]
};

/// The device in a volume: a sheet around the wires' mid-surface, two wires thick, blurred and cut
/// at the threshold; the face towards the wall is what is seen. Its middle is the crossings and its
/// thickness 0 where no volume is known.
///
/// The sheet is taken as equally dense everywhere, so that a denser braid does not look thicker.
/// @param wire_diameter  [m]; > 0
ImagedSheet imaged_sheet(const Deployment& deployment, double wire_diameter,
                         const ImagingChain& chain);

}  // namespace braidzone
