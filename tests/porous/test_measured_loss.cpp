#include "core/error.hpp"
#include "porous/braid_stokes.hpp"
#include "porous/measured_loss.hpp"
#include "support/temporary_folder.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <string>

namespace braidzone {
namespace {

const Fluid water{998.0, 1e-3};
const Fluid blood;
constexpr const char* header = "metal_coverage,wire_spacing_um,velocity_mm_s,pressure_drop_Pa\n";

/// A square cell of a coverage and a spacing.
Rhombus cell(double coverage, double spacing)
{
    return measure_rhombus(spacing * Vec3::UnitX(), spacing * Vec3::UnitY(),
                           (1.0 - std::sqrt(1.0 - coverage)) * spacing, Vec3(1, 1, 0));
}

class MeasuredLoss : public ::testing::Test {
protected:
    /// Rows of a bench on which a braid loses a v + b v^2.
    static std::string rows(double coverage, double spacing_um, const SheetLoss& loss)
    {
        std::string text;
        for (const double velocity : {0.01, 0.02, 0.05, 0.1}) {
            text += fmt::format("{},{},{},{}\n", coverage, spacing_um, 1e3 * velocity,
                                pressure_drop(loss, velocity));
        }
        return text;
    }

    MeasuredLaw read(const std::string& text)
    {
        std::ofstream(table()) << text;
        return read_measured_law(table(), water);
    }

    std::filesystem::path table() const { return folder_.path() / "loss.csv"; }

    void expect_refused(const std::string& text, const std::string& part_of_message)
    {
        try {
            read(text);
            ADD_FAILURE() << "accepted: " << text;
        } catch (const InputError& error) {
            EXPECT_THAT(error.what(), ::testing::HasSubstr(part_of_message));
            EXPECT_THAT(error.what(), ::testing::HasSubstr("loss.csv"));
        }
    }

private:
    test::TemporaryFolder folder_;
};

TEST_F(MeasuredLoss, FitsEachBraidOfTheTable)
{
    const MeasuredLaw law =
        read(header + rows(0.4, 180, {260.0, 320.0}) + rows(0.3, 190, {140.0, 300.0}));
    ASSERT_EQ(law.braids.size(), 2U);
    EXPECT_DOUBLE_EQ(law.braids[0].metal_coverage, 0.3);
    EXPECT_NEAR(law.braids[0].wire_spacing, 190e-6, 1e-15);
    EXPECT_NEAR(law.braids[0].loss.linear, 140.0, 1e-6);
    EXPECT_NEAR(law.braids[0].loss.quadratic, 300.0, 1e-4);
    EXPECT_NEAR(law.braids[1].loss.linear, 260.0, 1e-6);
    EXPECT_LT(law.braids[1].fit_error, 1e-9);
    EXPECT_DOUBLE_EQ(law.braids[1].highest_velocity, 0.1);
}

// The measured cell itself in the bench's fluid; in blood the linear part is 3.5 times as large
// (viscosity), the quadratic one 1056 / 998 times (density).
TEST_F(MeasuredLoss, GivesBackWhatWasMeasured)
{
    const MeasuredLaw law = read(header + rows(0.3, 190, {140.0, 300.0}));
    const SheetLoss in_water = sheet_loss(law, cell(0.3, 190e-6), water);
    EXPECT_NEAR(in_water.linear, 140.0, 1e-6);
    EXPECT_NEAR(in_water.quadratic, 300.0, 1e-4);
    const SheetLoss in_blood = sheet_loss(law, cell(0.3, 190e-6), blood);
    EXPECT_NEAR(in_blood.linear, 3.5 * 140.0, 1e-5);
    EXPECT_NEAR(in_blood.quadratic, 300.0 * 1056.0 / 998.0, 1e-4);
}

// At the same coverage a braid of twice the spacing has half of a and the same b.
TEST_F(MeasuredLoss, ScalesWithTheWireSpacing)
{
    const MeasuredLaw law = read(header + rows(0.3, 190, {140.0, 300.0}));
    const SheetLoss wide = sheet_loss(law, cell(0.3, 380e-6), water);
    EXPECT_NEAR(wide.linear, 70.0, 1e-6);
    EXPECT_NEAR(wide.quadratic, 300.0, 1e-4);
}

// Two braids at 1.2 and 1.4 times the recommended law: half-way between their coverages 1.3 times,
// beyond them the nearer one's factor.
TEST_F(MeasuredLoss, InterpolatesTheFactorOverTheCoverage)
{
    const auto times_law = [](double factor, double coverage) {
        const SheetLoss loss = sheet_loss(BraidStokesLaw{}, cell(coverage, 190e-6), water);
        return SheetLoss{factor * loss.linear, factor * loss.quadratic};
    };
    const MeasuredLaw law = read(header + rows(0.25, 190, times_law(1.2, 0.25)) +
                                 rows(0.35, 190, times_law(1.4, 0.35)));
    const auto expect_factor = [&](double coverage, double factor) {
        const SheetLoss expected = times_law(factor, coverage);
        const SheetLoss loss = sheet_loss(law, cell(coverage, 190e-6), water);
        EXPECT_NEAR(loss.linear / expected.linear, 1.0, 1e-8) << coverage;
        EXPECT_NEAR(loss.quadratic / expected.quadratic, 1.0, 1e-6) << coverage;
    };
    expect_factor(0.25, 1.2);
    expect_factor(0.30, 1.3);
    expect_factor(0.35, 1.4);
    expect_factor(0.20, 1.2);
    expect_factor(0.50, 1.4);
}

TEST_F(MeasuredLoss, WarnsBeyondTheMeasuredCoverages)
{
    const MeasuredLaw law = read(header + rows(0.3, 190, {140.0, 300.0}));
    const auto checks = range_checks(law, cell(0.45, 190e-6), blood);
    EXPECT_STREQ(checks[0].quantity, "metal coverage");
    EXPECT_GT(checks[0].value, checks[0].highest);
    EXPECT_LT(cell(0.31, 190e-6).metal_coverage, checks[0].highest);
}

TEST_F(MeasuredLoss, RefusesTablesThatHoldNoLoss)
{
    expect_refused("coverage,v,dp\n0.3,1,2\n", ":1: \"coverage,v,dp\" is not the header");
    expect_refused(header, "holds no measurement");
    expect_refused(std::string(header) + "0.3,190,10\n", ":2: \"0.3,190,10\" is no measurement");
    expect_refused(std::string(header) + "0.3,190,10,4\n0.3,190,nan,4\n", ":3: ");
    expect_refused(std::string(header) + "1.3,190,10,4\n", "a coverage between 0 and 1");
    expect_refused(std::string(header) + "0.3,190,-10,4\n", "all positive");
    expect_refused(std::string(header) + "0.3,190,10,4\n", "measured at one velocity only");
    expect_refused(header + rows(0.3, 190, {140, 300}) + rows(0.3, 150, {150, 300}),
                   "another braid of the same coverage");
    expect_refused(std::string(header) + "0.3,190,10,0.1\n0.3,190,20,10\n", "negative linear part");
}

TEST_F(MeasuredLoss, RefusesAMissingTable)
{
    EXPECT_THROW(read_measured_law(table(), water), IoError);
}

}  // namespace
}  // namespace braidzone
