#include "core/error.hpp"
#include "discrepancy/separability.hpp"
#include "support/linear_problem.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

namespace braidzone {
namespace {

std::vector<int> all_rows()
{
    std::vector<int> rows(60);
    std::iota(rows.begin(), rows.end(), 0);
    return rows;
}

}  // namespace

// Of typical size 10 the data are 10 F_i; what candidate j leaves of them is their part across F_j,
// 10 |F_i| sin(angle), up to the prior's pull on its size.
TEST(Separability, IsTheSineBetweenFingerprints)
{
    test::LinearProblem linear = test::three_bumps(0.0, 0.0, 0.0, 1);
    linear.fingerprints.col(2) = linear.fingerprints.col(1) + 0.3 * linear.fingerprints.col(0);
    const Separability found = separability(linear.problem(), all_rows());
    const Eigen::VectorXd b = linear.fingerprints.col(1), c = linear.fingerprints.col(2);
    EXPECT_NEAR(found.detection[1], 10.0 * b.norm(), 1e-9);
    const double cosine = b.dot(c) / (b.norm() * c.norm());
    EXPECT_NEAR(found.separation(1, 2), 10.0 * b.norm() * std::sqrt(1.0 - cosine * cosine), 0.02);
    EXPECT_EQ(found.separation(1, 1), 0.0);
    EXPECT_GT(found.separation(0, 1), least_separation);
}

TEST(Separability, SeesOnlyTheRowsThatAreMeasured)
{
    const test::LinearProblem linear = test::three_bumps(0.0, 0.0, 0.0, 1);
    const Separability found = separability(linear.problem(), {0, 1, 2, 3, 4, 5});
    EXPECT_LT(found.detection[2], 1e-6);  // its bump lies elsewhere
    EXPECT_NEAR(found.detection[0], 10.0 * linear.fingerprints.col(0).head(6).norm(), 1e-9);
}

TEST(Separability, IsUnknownOfACandidateThatCannotBeSimulated)
{
    DiagnosisProblem problem = test::three_bumps(0.0, 0.0, 0.0, 1).problem();
    const auto residuals = problem.residuals;
    problem.residuals = [residuals](const std::vector<ActiveEffect>& effects) {
        if (!effects.empty() && effects.front().candidate == 1)
            throw GeometryError("the device breaks");
        return residuals(effects);
    };
    const Separability found = separability(problem, all_rows());
    EXPECT_TRUE(std::isnan(found.detection[1]));
    EXPECT_TRUE(std::isnan(found.separation(0, 1)));
    EXPECT_TRUE(std::isnan(found.separation(1, 0)));
    EXPECT_FALSE(std::isnan(found.separation(0, 2)));
}

}  // namespace braidzone
