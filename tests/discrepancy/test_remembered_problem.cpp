#include "discrepancy/remembered_problem.hpp"
#include "support/linear_problem.hpp"

#include <gtest/gtest.h>

namespace braidzone {

// Copies share what is remembered; sets of several effects are simulated each time.
TEST(Remembered, SimulatesACandidateAloneOnce)
{
    DiagnosisProblem problem = test::three_bumps(1.0, 2.0, 3.0, 1).problem();
    int num_runs = 0;
    problem.residuals = [&,
                         residuals = problem.residuals](const std::vector<ActiveEffect>& effects) {
        ++num_runs;
        return residuals(effects);
    };
    const DiagnosisProblem memory = remembered(problem), copy = memory;
    const Eigen::VectorXd first = memory.residuals({{0, {0.5}}});
    EXPECT_EQ(copy.residuals({{0, {0.5}}}), first);
    EXPECT_EQ(num_runs, 1);
    EXPECT_NE(memory.residuals({{1, {0.5}}}), first);
    EXPECT_NE(memory.residuals({{0, {0.6}}}), first);
    EXPECT_EQ(num_runs, 3);
    memory.residuals({{0, {0.5}}, {1, {0.5}}});
    memory.residuals({{0, {0.5}}, {1, {0.5}}});
    EXPECT_EQ(num_runs, 5);
}

}  // namespace braidzone
