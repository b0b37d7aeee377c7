#include "discrepancy/effect.hpp"

namespace braidzone {

const std::vector<Effect>& effect_catalogue()
{
    static const std::vector<Effect> all = {
        registration_effect(),
        blooming_effect(),
        vessel_offset_effect(),
        wall_compliance_effect(),
        vessel_straightening_effect(),
        landing_offset_effect(),
        nominal_diameter_effect(),
        braid_ratio_effect(),
        local_push_effect(),
        local_pull_effect(),
        sliding_effect(),
        axial_twist_effect(),
        incomplete_opening_proximal_effect(),
        incomplete_opening_distal_effect(),
        free_hub_effect(),
    };
    return all;
}

}  // namespace braidzone
