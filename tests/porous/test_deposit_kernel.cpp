#include "core/error.hpp"
#include "porous/deposit_kernel.hpp"
#include "support/braids.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace braidzone {
namespace {

TEST(CosineKernel, SumsToOneOverTheIntegersForAnyShift)
{
    for (const int half_width : {1, 2, 3}) {
        for (double shift = 0.0; shift < 1.0; shift += 0.0625) {
            double sum = 0.0;
            for (int i = -half_width - 1; i <= half_width + 1; ++i) {
                sum += cosine_kernel(i + shift, half_width);
            }
            EXPECT_NEAR(sum, 1.0, 1e-14) << half_width << " " << shift;
        }
    }
}

// The trapezium rule is exact for a period of the cosine.
TEST(CosineKernel, IntegratesToOneForAnyWidth)
{
    for (const double half_width : {0.5, 1.0, 2.5, 3.0}) {
        constexpr int steps = 64;
        double integral = 0.0;
        for (int i = 0; i < steps; ++i) {
            const double distance = half_width * (2.0 * i / steps - 1.0);
            integral += cosine_kernel(distance, half_width) * 2.0 * half_width / steps;
        }
        EXPECT_NEAR(integral, 1.0, 1e-14) << half_width;
    }
}

TEST(CosineKernel, IsEvenAndEndsAtItsHalfWidth)
{
    EXPECT_DOUBLE_EQ(cosine_kernel(0.0, 2.0), 0.5);
    EXPECT_DOUBLE_EQ(cosine_kernel(0.7, 2.0), cosine_kernel(-0.7, 2.0));
    EXPECT_EQ(cosine_kernel(2.0, 2.0), 0.0);
    EXPECT_EQ(cosine_kernel(-5.0, 2.0), 0.0);
    EXPECT_EQ(cosine_kernel(std::nan(""), 2.0), 0.0);
}

TEST(CosineWeights, AreTheKernelAtTheIntegersAround)
{
    for (const int half_width : {1, 2, 3}) {
        CosineWeights weights(half_width);
        for (const double position : {7.0, 7.3, 7.999, -2.4}) {
            weights.evaluate(position);
            EXPECT_EQ(weights.first(), static_cast<int>(std::floor(position)) - half_width + 1);
            for (int i = 0; i < 2 * half_width; ++i) {
                EXPECT_NEAR(weights[i], cosine_kernel(position - weights.first() - i, half_width),
                            1e-15);
            }
        }
    }
}

// Cells of 0.4 x 0.1 mm and pieces of at most 0.15 mm: 3 x 3 pieces of a ninth of the area, at the
// middles of thirds.
TEST(CutIntoPieces, SharesTheAreaAmongEqualPieces)
{
    const BraidSurface surface =
        test::flat_braid(Vec3(0, 0, 1e-3), Vec3(0.4e-3, 0, 0), 2, Vec3(0, 0.1e-3, 0), 1, 20e-6);
    const std::vector<SheetPiece> pieces = test::pieces_of(surface, 0.15e-3);
    ASSERT_EQ(pieces.size(), 18U);
    for (const SheetPiece& piece : pieces)
        EXPECT_NEAR(piece.area, 4e-8 / 9.0, 1e-20);
    EXPECT_EQ(pieces[8].rhombus, 0);
    EXPECT_EQ(pieces[9].rhombus, 1);
    EXPECT_NEAR((pieces[0].position - Vec3(0.4e-3 / 6, 0.1e-3 / 6, 1e-3)).norm(), 0.0, 1e-15);
    EXPECT_NEAR((pieces[17].position - Vec3(0.8e-3 - 0.4e-3 / 6, 0.5e-3 / 6, 1e-3)).norm(), 0.0,
                1e-15);
}

TEST(CutIntoPieces, LeavesSmallRhombiWhole)
{
    const BraidSurface surface =
        test::flat_braid(Vec3::Zero(), Vec3(1e-4, 0, 0), 3, Vec3(0, 1e-4, 0), 2, 20e-6);
    const std::vector<SheetPiece> pieces = test::pieces_of(surface, 1e-3);
    ASSERT_EQ(pieces.size(), 6U);
    for (std::size_t i = 0; i < 6; ++i) {
        EXPECT_NEAR((pieces[i].position - surface.centres[i]).norm(), 0.0, 1e-18);
    }
}

TEST(CutIntoPieces, RefusesPiecesWithoutSize)
{
    const BraidSurface surface =
        test::flat_braid(Vec3::Zero(), Vec3(1e-4, 0, 0), 1, Vec3(0, 1e-4, 0), 1, 20e-6);
    EXPECT_THROW(cut_into_pieces(surface, 0, 0.0), InputError);
    EXPECT_THROW(cut_into_pieces(surface, 0, std::nan("")), InputError);
}

}  // namespace
}  // namespace braidzone
