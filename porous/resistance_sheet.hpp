#pragma once

#include "porous/braid_surface.hpp"
#include "porous/resistance_law.hpp"

#include <optional>
#include <vector>

namespace braidzone {

/// On which part of the device the flow meets resistance.
enum class ResistanceRegion {
    free_of_wall,  ///< neck, branch ostia, malapposed parts: where flow passes through the braid
    whole_device,
};

/// On which part of the velocity the quadratic drag acts.
enum class QuadraticDrag {
    /// b |u| u, tangential part with the tangential ratio: what stock porous zones do. A fast flow
    /// along the sheet adds b |u| to the resistance against the slow flow through it: b |u| is 100
    /// Pa
    /// s/m at 0.3 m/s in the parent vessel, beside a = 490.
    whole_velocity,
    /// b |u| u_n along the normal only: no quadratic drag along the sheet, where wires in slow flow
    /// have none. A solver that multiplies with |u| still adds b |u| to the normal resistance;
    /// where
    /// that matters, leave the quadratic part out (`BraidStokesLaw::inertia`).
    normal_only,
};

/// Tangential over normal resistance [-]. Wires are no-slip along the sheet too: the flow meets a
/// wall within a wire diameter of the device (wire-resolved: 0.2 to 0.7), so the linear ratio is 1
/// at least.
struct TangentialRatio {
    double linear = 1.0;
    double quadratic = 1.0;

    bool operator==(const TangentialRatio&) const = default;
};

struct SheetOptions {
    double tangential_ratio = 1.0;  ///< tangential over normal resistance [-]; >= 0
    QuadraticDrag quadratic = QuadraticDrag::whole_velocity;
    ResistanceRegion region = ResistanceRegion::free_of_wall;
};

/// The braid surface with its flow resistance: one entry a rhombus.
struct ResistanceSheet {
    BraidSurface surface;
    std::vector<SheetLoss> losses;  ///< of the local braid, whether it acts or not
    /// 0 where the braid lies on the wall, 1 where it is free of it: smooth step of the distance
    /// from one to three wire diameters.
    std::vector<double> acting;
    TangentialRatio tangential_ratio;
    Fluid fluid;
};

ResistanceSheet make_resistance_sheet(const BraidSurface& surface, const ResistanceLaw& law,
                                      const Fluid& fluid, const SheetOptions& options = {});

/// Two sheets as one, for one device inside another: flow that passes through both meets one
/// resistance after the other, and where both deposit into a cell their coefficients add. Holds for
/// layers a wire spacing apart; layers in touch lose some 10 to 20 % more than the sum.
/// @throws InputError if the sheets differ in fluid or tangential ratio
ResistanceSheet joined(const ResistanceSheet& first, const ResistanceSheet& second);

/// Darcy coefficient of a rhombus, integrated along its normal: acting a / mu [1/m].
double sheet_darcy(const ResistanceSheet& sheet, int rhombus);

/// Forchheimer coefficient integrated along the normal: acting 2 b / rho [-] (the factor 1/2 is
/// OpenFOAM's convention, S = -(mu D + 1/2 rho F |U|) U).
double sheet_forchheimer(const ResistanceSheet& sheet, int rhombus);

/// Integral of the Darcy coefficient over the sheet: sum of a / mu times the area [m].
double resistance_integral(const ResistanceSheet& sheet);

/// Mean loss of the sheet where it acts, by area; none if it acts nowhere.
std::optional<SheetLoss> mean_acting_loss(const ResistanceSheet& sheet);

}  // namespace braidzone
