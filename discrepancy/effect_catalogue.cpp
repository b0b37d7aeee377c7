#include "discrepancy/effect.hpp"

namespace braidzone {

const std::vector<Effect>& effect_catalogue()
{
    static const std::vector<Effect> all = {
        registration_effect(),    blooming_effect(),       vessel_offset_effect(),
        wall_compliance_effect(), landing_offset_effect(), nominal_diameter_effect(),
        braid_ratio_effect(),     local_push_effect(),     local_pull_effect(),
    };
    return all;
}

}  // namespace braidzone
