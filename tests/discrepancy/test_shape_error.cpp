#include "discrepancy/shape_error.hpp"
#include "support/linear_problem.hpp"

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include <cmath>

namespace braidzone {
namespace {

/// ln N(d; 0, D + 100 F F') - ln N(d; 0, I), D = I + (ratio m m') exp(-distance / 3) with the
/// fitted change m.
double exact_evidence(const test::LinearProblem& linear, const EffectFit& fit, double ratio)
{
    const Eigen::VectorXd& d = linear.data;
    const Eigen::Index n = d.size();
    const Eigen::VectorXd bump = linear.fingerprints.col(1);
    const Eigen::VectorXd size = ratio * std::abs(fit.effects.front().values.front()) * bump;
    Eigen::MatrixXd covariance = Eigen::MatrixXd::Identity(n, n) + 100.0 * bump * bump.transpose();
    for (Eigen::Index i = 0; i < n; ++i) {
        for (Eigen::Index j = 0; j < n; ++j) {
            covariance(i, j) +=
                size[i] * size[j] * std::exp(-std::abs(static_cast<double>(i - j)) / 3.0);
        }
    }
    const Eigen::LLT<Eigen::MatrixXd> factor(covariance);
    return -0.5 * d.dot(factor.solve(d)) - factor.matrixLLT().diagonal().array().log().sum() +
           0.5 * d.squaredNorm();
}

}  // namespace

TEST(EvidenceWithShapeError, IsThatOfNormalDataWithTheErrorInTheirCovariance)
{
    const test::LinearProblem linear = test::three_bumps(0.0, 8.0, 0.0, 5);
    const DiagnosisProblem problem = linear.problem();
    const Whitening whitening(problem.covariance);
    const EffectFit fit = fit_effect(problem, whitening, linear.data, 1, {});
    for (const double ratio : {0.0, 0.1, 0.5}) {
        EXPECT_NEAR(evidence_with_shape_error(problem, whitening, linear.data, fit, ratio),
                    exact_evidence(linear, fit, ratio), 1e-6)
            << ratio;
    }
    EXPECT_NEAR(evidence_with_shape_error(problem, whitening, linear.data, fit, 0.0),
                fit.log_evidence, 1e-4);
}

// Data of a wider bump than that of the effect: an error of its shape makes the effect more
// probable, none less.
TEST(EvidenceWithShapeError, IsGreaterForAnEffectOfNotQuiteItsShape)
{
    test::LinearProblem linear = test::three_bumps(0.0, 0.0, 0.0, 5);
    linear.data += 40.0 * test::bump(linear.data.size(), 30.0, 4.5);
    const DiagnosisProblem problem = linear.problem();
    const Whitening whitening(problem.covariance);
    const EffectFit fit = fit_effect(problem, whitening, linear.data, 1, {});
    EXPECT_GT(evidence_with_shape_error(problem, whitening, linear.data, fit, 0.1),
              fit.log_evidence + 3.0);
}

}  // namespace braidzone
