#include "verification/siphons/outcome.hpp"

#include <gtest/gtest.h>

namespace braidzone::test {
namespace {

class RandomSiphon : public testing::TestWithParam<unsigned> {};

// A braid does not turn inside out and does not leave its vessel, whatever the bends; each mouth
// that lies wholly behind it is there by construction.
TEST_P(RandomSiphon, HoldsTheDevice)
{
    const Outcome outcome = outcome_of(random_siphon(GetParam()));
    EXPECT_EQ(outcome.unmade, "");
    EXPECT_EQ(outcome.refused, "");
    EXPECT_EQ(outcome.inverted, 0);
    EXPECT_EQ(outcome.outside, 0);
    EXPECT_EQ(outcome.found, outcome.mouths);
    EXPECT_EQ(outcome.invented, 0);
}

// With and without a push, nominal and force-free; more of them: siphons/README.md.
INSTANTIATE_TEST_SUITE_P(Seeds, RandomSiphon, testing::Values(5u, 6u, 7u, 8u, 10u, 12u));

}  // namespace
}  // namespace braidzone::test
