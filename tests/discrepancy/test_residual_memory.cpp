#include "core/error.hpp"
#include "discrepancy/explanation.hpp"
#include "discrepancy/residual_memory.hpp"
#include "support/linear_problem.hpp"
#include "support/temporary_folder.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <limits>
#include <stdexcept>

namespace braidzone {
namespace {

namespace fs = std::filesystem;

const std::string key(64, 'a');

/// A problem that counts its simulations, and is interrupted after some of them.
struct Counted {
    DiagnosisProblem problem;
    std::shared_ptr<std::atomic<int>> count = std::make_shared<std::atomic<int>>(0);
};

Counted counted(int allowed = std::numeric_limits<int>::max())
{
    Counted result{test::three_bumps(12.0, 0.0, 3.0, 5).problem()};
    result.problem.residuals = [inner = result.problem.residuals, count = result.count,
                                allowed](const std::vector<ActiveEffect>& effects) {
        if (++*count > allowed) throw std::runtime_error("interrupted");
        return inner(effects);
    };
    return result;
}

/// Everything that the fits found, exactly.
std::vector<double> numbers_of(const Explanation& explanation)
{
    std::vector<double> numbers = {explanation.log_evidence_unknown, explanation.chi_square};
    for (const EffectFit& fit : explanation.fits) {
        numbers.push_back(fit.log_evidence);
        numbers.insert(numbers.end(), fit.x.begin(), fit.x.end());
        numbers.insert(numbers.end(), fit.residuals.begin(), fit.residuals.end());
    }
    return numbers;
}

int simulations_of_all()
{
    const Counted whole = counted();
    explain(whole.problem);
    return *whole.count;
}

}  // namespace

TEST(ResidualMemory, MakesNoSimulationTwiceAndChangesNoBit)
{
    const test::TemporaryFolder folder;
    const fs::path file = folder.path() / "kept";
    const std::vector<double> expected = numbers_of(explain(counted().problem));
    {
        ResidualMemory memory(file, key);
        EXPECT_EQ(memory.num_found(), 0U);
        EXPECT_EQ(numbers_of(explain(memory.around(counted().problem))), expected);
    }
    ResidualMemory memory(file, key);
    EXPECT_GT(memory.num_found(), 10U);
    const Counted again = counted();
    EXPECT_EQ(numbers_of(explain(memory.around(again.problem))), expected);
    EXPECT_EQ(*again.count, 0);
    memory.forget();
    EXPECT_FALSE(fs::exists(file));
}

TEST(ResidualMemory, GoesOnWhereItWasInterrupted)
{
    const test::TemporaryFolder folder;
    const fs::path file = folder.path() / "kept";
    constexpr int allowed = 9;
    {
        ResidualMemory memory(file, key);
        EXPECT_THROW(explain(memory.around(counted(allowed).problem)), std::runtime_error);
    }
    ResidualMemory memory(file, key);
    EXPECT_EQ(memory.num_found(), static_cast<std::size_t>(allowed));
    const Counted rest = counted();
    EXPECT_EQ(numbers_of(explain(memory.around(rest.problem))),
              numbers_of(explain(counted().problem)));
    EXPECT_LE(*rest.count, simulations_of_all() - allowed);
}

TEST(ResidualMemory, DropsARecordThatIsTornOrDamaged)
{
    const test::TemporaryFolder folder;
    const fs::path file = folder.path() / "kept";
    const auto simulate = [&](double value) {
        ResidualMemory memory(file, key);
        return memory.around(counted().problem).residuals({{1, {value}}});
    };
    simulate(1.0);
    const auto one = fs::file_size(file);
    const Eigen::VectorXd second = simulate(2.0);
    fs::resize_file(file, fs::file_size(file) - 5);
    EXPECT_EQ(ResidualMemory(file, key).num_found(), 1U);
    EXPECT_EQ(fs::file_size(file), one);
    EXPECT_EQ(simulate(2.0), second);
    EXPECT_EQ(ResidualMemory(file, key).num_found(), 2U);
    {
        std::fstream damaged(file, std::ios::in | std::ios::out | std::ios::binary);
        damaged.seekp(static_cast<std::streamoff>(one) + 40);
        damaged.put('x');
    }
    EXPECT_EQ(ResidualMemory(file, key).num_found(), 1U);
}

TEST(ResidualMemory, BeginsAnewForAnotherKey)
{
    const test::TemporaryFolder folder;
    const fs::path file = folder.path() / "kept";
    {
        ResidualMemory memory(file, key);
        memory.around(counted().problem).residuals({});
    }
    EXPECT_EQ(ResidualMemory(file, std::string(64, 'b')).num_found(), 0U);
    EXPECT_FALSE(fs::exists(file)) << "it holds nothing";
}

TEST(ResidualMemory, RemembersWhatFailedAndHow)
{
    const test::TemporaryFolder folder;
    const fs::path file = folder.path() / "kept";
    DiagnosisProblem failing = counted().problem;
    failing.residuals = [](const std::vector<ActiveEffect>&) -> Eigen::VectorXd {
        throw ConvergenceError("no rest at 3 mm");
    };
    {
        ResidualMemory memory(file, key);
        EXPECT_THROW(memory.around(failing).residuals({{0, {1.0}}}), ConvergenceError);
    }
    ResidualMemory memory(file, key);
    try {
        memory.around(counted().problem).residuals({{0, {1.0}}});
        FAIL() << "it was simulated again";
    } catch (const Error& error) {
        EXPECT_STREQ(error.what(), "no rest at 3 mm");
        EXPECT_EQ(error.exit_status(), 4);
    }
}

// Another process that diagnoses the same: the second one keeps nothing.
TEST(ResidualMemory, IsOneProcesssAtATime)
{
    const test::TemporaryFolder folder;
    const fs::path file = folder.path() / "kept";
    ResidualMemory first(file, key), second(file, key);
    first.around(counted().problem).residuals({});
    const auto size = fs::file_size(file);
    second.around(counted().problem).residuals({{0, {1.0}}});
    EXPECT_EQ(fs::file_size(file), size);
}

}  // namespace braidzone
