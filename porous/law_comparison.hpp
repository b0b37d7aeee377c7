#pragma once

#include "porous/resistance_sheet.hpp"

#include <string>
#include <vector>

namespace braidzone {

/// What one law makes of a deployed braid.
struct LawComparison {
    std::string law;
    std::vector<SheetLoss> losses;      ///< one a rhombus
    SheetLoss mean;                     ///< over the area where the resistance acts
    double ratio = 1.0;                 ///< linear part of the mean over the recommended law's [-]
    double resistance_integral = 0.0;   ///< of the Darcy coefficient over the acting sheet [m]
    std::vector<std::string> warnings;  ///< on rhombi outside the law's range
};

/// Applies every law to the sheet's braid: the recommended one first, then those of the literature,
/// and `own` last if it needs data (measured values, given constants); if it is one of them, it
/// counts with its own options.
///
/// Means are weighted with the area and with how far the resistance acts, so they are those of the
/// neck and of other free parts; of the whole device if it acts nowhere.
std::vector<LawComparison> compare_laws(const ResistanceSheet& sheet, const ResistanceLaw& own);

}  // namespace braidzone
