#pragma once

#include <string>
#include <vector>

namespace braidzone {

/// How the device's resistance is put into an OpenFOAM case.
enum class FoamForm {
    zones,     ///< cell zones of uniform resistance (`foam_zones.hpp`)
    per_cell,  ///< the resistance tensor of every cell (`foam_per_cell.hpp`)
    baffles,   ///< pressure jumps on faces (`foam_baffles.hpp`)
};

/// What a form makes of the resistance.
struct FoamFormTraits {
    FoamForm form;
    const char* name;   ///< in case files
    const char* keeps;  ///< a sentence
    const char* loses;  ///< a sentence
};

/// Every form, in the order of `FoamForm`.
const std::vector<FoamFormTraits>& foam_forms();

const FoamFormTraits& traits_of(FoamForm form);

}  // namespace braidzone
