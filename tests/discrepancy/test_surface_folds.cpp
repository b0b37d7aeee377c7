#include "discrepancy/surface_folds.hpp"
#include "support/patch_grid.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace braidzone {

// Seven rows of twelve patches: blocks of 3, 3 and 1 rows times 3 columns.
TEST(SurfaceFolds, HoldEachPatchOnce)
{
    const auto folds = surface_folds(test::cylinder_field(7, 2e-3));
    ASSERT_EQ(folds.size(), 12u);
    std::vector<int> all;
    for (const auto& fold : folds)
        all.insert(all.end(), fold.begin(), fold.end());
    std::sort(all.begin(), all.end());
    for (int i = 0; i < 84; ++i)
        EXPECT_EQ(all[static_cast<std::size_t>(i)], i);
    EXPECT_THAT(folds.front(), testing::ElementsAre(0, 1, 2, 12, 13, 14, 24, 25, 26));
    EXPECT_THAT(folds.back(), testing::ElementsAre(81, 82, 83));
}

}  // namespace braidzone
