#include "discrepancy/blind/case_folder.hpp"
#include "discrepancy/hub_slopes.hpp"
#include "discrepancy/planned_measurement.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace braidzone {
namespace {

/// A 4 mm device in a bend with a sac on its outer side, or without the sac.
std::vector<Patch> patches_with_slopes(bool has_sac, bool has_hoop_migration = false)
{
    hidden::Belief belief = hidden::sidewall_belief(BRAIDZONE_SOURCE_DIR);
    if (!has_sac) belief.phantom.sacs.clear();
    const Lumen lumen = blind::believed_lumen(belief.phantom);
    Model model = blind::believed_model(belief);
    const Simulation base = simulate(model, lumen);
    model.options.hoop_migration = has_hoop_migration;
    Observations observations = planned_observations(base, {});
    set_hub_slopes(observations, model, base, lumen);
    return observations.field.patches;
}

}  // namespace

// A hub takes its ring along where nothing holds it: at most as far as it moves itself, less for
// the wires to neighbours on the wall. The wall is as stiff to it as without.
TEST(HubSlopes, AreThoseOfAFreeRingInFrontOfTheNeckOnly)
{
    double largest = 0.0;
    for (const Patch& patch : patches_with_slopes(true)) {
        if (patch.contact_share > 0.99) {
            EXPECT_LT(std::abs(patch.hub_slope), 0.1) << patch.arc_length << " " << patch.angle;
        }
        largest = std::max(largest, patch.hub_slope);
        EXPECT_GT(patch.hub_slope, -0.1);
    }
    EXPECT_LT(largest, 1.05);
    EXPECT_GT(largest, 0.3);
}

TEST(HubSlopes, AreNoneWithoutANeckOrWhereRingsFindTheirOwnPlace)
{
    for (const Patch& patch : patches_with_slopes(false))
        EXPECT_EQ(patch.hub_slope, 0.0);
    for (const Patch& patch : patches_with_slopes(true, true))
        EXPECT_EQ(patch.hub_slope, 0.0);
}

}  // namespace braidzone
