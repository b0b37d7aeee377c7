#pragma once

#include "core/fluid.hpp"
#include "deploy/flow_diverter.hpp"
#include "porous/resistance_law.hpp"
#include "porous/rhombus.hpp"
#include "porous/sheet_loss.hpp"

namespace braidzone {

/// A bench on which a fluid is driven through the wall of a device: a piece of its braid across a
/// round channel.
struct PressureBench {
    FlowDiverter device;
    Fluid fluid;
    ResistanceLaw law;
    double diameter = 0.0;           ///< of the device as it is held on the bench [m]
    double channel_diameter = 4e-3;  ///< of the channel that the braid closes [m]
    /// Pores a unit area over those of the free braid at that diameter, less 1 [-]; > -1. The
    /// rings are that much closer, along the axis.
    double density_increase = 0.0;
    double gap_width = 0.0;     ///< of an open slit all around the braid's edge [m]
    double second_layer = 0.0;  ///< loss of a second layer over the first one's; 0: there is none
    /// Quadratic loss besides the law's, over that of braid-stokes (`braid_stokes_quadratic`) [-].
    double added_inertia = 0.0;
};

/// The braid's cell on the bench. Its rings have the spacing of the free braid at that diameter
/// (`length_ratio`) over 1 + `density_increase`.
/// @throws InputError if the diameter is beyond what the braid allows
Rhombus bench_rhombus(const PressureBench& bench);

/// Loss of the braid itself, with the second layer and the added inertia:
///
///     (a, b) = (1 + second_layer) (a_law, b_law + added_inertia b_braid-stokes)
///
/// @throws InputError if the braid is jammed, or the quadratic loss comes out negative
SheetLoss bench_loss(const PressureBench& bench);

/// Pressure drop on the bench at a mean velocity over the channel's section [Pa]. The gap is a
/// parallel path (`parallel_pressure_drop`) of the share 4 h / D of the section, D that of the
/// channel, and as long as the braid is thick, two wires.
/// @param velocity  [m/s]
/// @throws InputError if the gap is no slit, 4 h >= D; else what `bench_loss` throws
double bench_pressure_drop(const PressureBench& bench, double velocity);

}  // namespace braidzone
