#pragma once

#include "porous/braid_surface.hpp"
#include "porous/resistance_law.hpp"

#include <vector>

namespace braidzone {

/// On which part of the device the flow meets resistance.
enum class ResistanceRegion {
    free_of_wall,  ///< neck, branch ostia, malapposed parts: where flow passes through the braid
    whole_device,
};

struct SheetOptions {
    double tangential_ratio = 1.0;  ///< tangential over normal resistance [-]; >= 0
    ResistanceRegion region = ResistanceRegion::free_of_wall;
};

/// The braid surface with its flow resistance: one entry a rhombus.
struct ResistanceSheet {
    BraidSurface surface;
    std::vector<SheetLoss> losses;  ///< of the local braid, whether it acts or not
    /// 0 where the braid lies on the wall, 1 where it is free of it: smooth step of the distance
    /// from one to three wire diameters.
    std::vector<double> acting;
    double tangential_ratio = 1.0;
    Fluid fluid;
};

ResistanceSheet make_resistance_sheet(const BraidSurface& surface, const ResistanceLaw& law,
                                      const Fluid& fluid, const SheetOptions& options = {});

/// Two sheets as one, for one device inside another: flow that passes through both meets one
/// resistance after the other, and where both deposit into a cell their coefficients add.
/// @throws InputError if the sheets differ in fluid or tangential ratio
ResistanceSheet joined(const ResistanceSheet& first, const ResistanceSheet& second);

/// Darcy coefficient of a rhombus, integrated along its normal: acting a / mu [1/m].
double sheet_darcy(const ResistanceSheet& sheet, int rhombus);

/// Forchheimer coefficient integrated along the normal: acting 2 b / rho [-] (the factor 1/2 is
/// OpenFOAM's convention, S = -(mu D + 1/2 rho F |U|) U).
double sheet_forchheimer(const ResistanceSheet& sheet, int rhombus);

/// Integral of the Darcy coefficient over the sheet: sum of a / mu times the area [m].
double resistance_integral(const ResistanceSheet& sheet);

}  // namespace braidzone
