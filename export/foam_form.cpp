#include "export/foam_form.hpp"

namespace braidzone {

const std::vector<FoamFormTraits>& foam_forms()
{
    static const std::vector<FoamFormTraits> forms = {
        {FoamForm::zones, "zones",
         "the sum over the cells; linear and quadratic part along and across the braid; every "
         "OpenFOAM",
         "differences within a zone"},
        {FoamForm::per_cell, "per_cell",
         "the linear resistance tensor of every cell, along and across the braid",
         "differences of the quadratic part within a zone; OpenFOAM of openfoam.org"},
        {FoamForm::baffles, "baffles",
         "a device without thickness; linear and quadratic part across the braid",
         "all resistance along the braid; differences within a zone"},
    };
    return forms;
}

const FoamFormTraits& traits_of(FoamForm form)
{
    return foam_forms()[static_cast<std::size_t>(form)];
}

}  // namespace braidzone
