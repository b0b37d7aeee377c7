#pragma once

#include "core/vector.hpp"
#include "discrepancy/imaging_chain.hpp"

namespace braidzone {

/// How a measured device surface came about: where the scan lies in the vessel's frame, and how
/// much thicker the device looks than it is.
struct Imaging {
    ImagingChain chain;  ///< of the volume in which the device was segmented
    /// By which the segmented surface lies outside what the chain shows of the wires, which is
    /// their mid-surface where no chain is known [m].
    double blooming = 0.0;
    /// The motion that brings the scan into the vessel's frame: a turn about `pivot` by the length
    /// of `rotation` [rad] about its direction, then `shift` [m].
    Vec3 shift = Vec3::Zero();
    Vec3 rotation = Vec3::Zero();
    Vec3 pivot = Vec3::Zero();  ///< [m]
};

/// A point of the scan in the vessel's frame:  p' = R (p - pivot) + pivot + shift  [m].
Vec3 in_vessel_frame(const Imaging& imaging, const Vec3& point);

/// The same with the scan moved on, in the vessel's frame: a turn about `middle` by the length of
/// `rotation` [rad] about its direction, then `shift` [m].
Imaging moved_on(const Imaging& imaging, const Vec3& shift, const Vec3& rotation,
                 const Vec3& middle);

}  // namespace braidzone
