#include "discrepancy/blind/detectability.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace braidzone::blind {
namespace {

std::vector<double> of_effects(const std::vector<hidden::EffectChoice>& effects, std::uint32_t seed)
{
    return detectability(hidden::random_case(effects, seed), effects);
}

}  // namespace

// Another landing moves both ends by o and hardly the surface. The ends' covariance is, in mm^2,
// [a c; c b] of a = 0.3^2 + 0.125^2, b = a + 0.061^2 and c = 0.125^2 (markers, landing, length),
// and d'^2 = o^2 (a + b - 2 c) / (a b - c^2) = (4.04 o)^2.
TEST(Detectability, OfALandingIsThatOfItsEnds)
{
    const std::array effects = {hidden::EffectChoice{"landing_offset", hidden::EffectSize::strong}};
    const hidden::HiddenCase made = hidden::random_case(effects, 21);
    const double offset = 1e3 * std::abs(made.effects.front().values.at("offset"));
    const double of_ends = 4.04 * offset;
    const double index = detectability(made, effects).front();
    EXPECT_GT(of_ends, 4.0);
    EXPECT_GT(index, 0.97 * of_ends);
    EXPECT_LT(index, std::hypot(of_ends, 3.0));
}

// A braid ratio at the nominal spacing moves the surface by a few micrometres, a vessel that is
// 0.1 mm narrower all of it: each beside the other as alone.
TEST(Detectability, TellsWhatHidesBesideWhatShows)
{
    const std::vector<double> both = of_effects({{"vessel_offset", hidden::EffectSize::strong},
                                                 {"braid_ratio", hidden::EffectSize::strong}},
                                                22);
    ASSERT_EQ(both.size(), 2u);
    EXPECT_GT(both[0], 8.0);
    EXPECT_LT(both[1], 2.0);
}

TEST(Detectability, IsNoNumberWithoutAnEffect)
{
    EXPECT_TRUE(of_effects({}, 23).empty());
}

TEST(CleanCase, DiffersByTheEffectThatIsLeftOutAlone)
{
    const std::array pair = {hidden::EffectChoice{"local_push", hidden::EffectSize::strong},
                             hidden::EffectChoice{"blooming", hidden::EffectSize::strong}};
    const hidden::HiddenCase all = hidden::clean_case(pair, 24);
    // Blooming is the scan's: the device below it is the same. A push makes it shorter.
    EXPECT_EQ(all.device.points, hidden::clean_case(pair, 24, 1).device.points);
    EXPECT_EQ(all.device.points, hidden::random_case(pair, 24).device.points);
    const hidden::ScannedDevice unpushed = hidden::clean_case(pair, 24, 0).scan;
    EXPECT_GT(all.scan.ends.values[1]->value, unpushed.ends.values[1]->value + 0.5e-3);
    EXPECT_EQ(all.scan.shift.norm(), 0.0);
}

}  // namespace braidzone::blind
