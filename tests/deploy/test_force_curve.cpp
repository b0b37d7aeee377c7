#include "core/error.hpp"
#include "deploy/force_curve.hpp"
#include "support/temporary_folder.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

namespace braidzone {

namespace {

std::string message_of(const std::string& text)
{
    const test::TemporaryFolder folder;
    try {
        read_force_curve(folder.write("curve.csv", text));
    } catch (const Error& error) {
        return error.what();
    }
    return "no error";
}

}  // namespace

// Repeats 1, 2, 3 mN and so on: mean 2, squares about it 1 + 0 + 1 for each of four points, over
// 4 * 2 degrees of freedom: a deviation of 1 mN.
TEST(ForceCurve, IsTheMeanOfItsRepeatsWithTheirPooledDeviation)
{
    const test::TemporaryFolder folder;
    const ForceCurve curve =
        read_force_curve(folder.write("curve.csv",
                                      "displacement_mm,force_1_mN,force_2_mN,force_3_mN\n"
                                      "0,1,2,3\n0.5,11,12,13\n1,22,21,23\n1.5,33,32,31\n"));
    ASSERT_EQ(curve.points.size(), 4U);
    EXPECT_EQ(curve.num_repeats, 3);
    EXPECT_NEAR(curve.points[1].displacement, 0.5e-3, 1e-18);
    EXPECT_NEAR(curve.points[1].force, 12e-3, 1e-15);
    EXPECT_NEAR(curve.deviation, 1e-3, 1e-12);
}

TEST(ForceCurve, TakesOtherUnitsAndASingleCurve)
{
    const test::TemporaryFolder folder;
    const ForceCurve curve = read_force_curve(folder.write(
        "curve.csv", "displacement_um, force_N\r\n0,0\r\n100,0.1\r\n200,0.2\r\n300,0.3\r\n"));
    EXPECT_NEAR(curve.points[3].displacement, 300e-6, 1e-15);
    EXPECT_EQ(curve.points[3].force, 0.3);
    EXPECT_EQ(curve.deviation, 0.0);
}

TEST(ForceCurve, RefusesWhatIsNoForceCurve)
{
    using testing::HasSubstr;
    EXPECT_THAT(message_of("x,y\n0,0\n"), HasSubstr("not the header of a force curve"));
    EXPECT_THAT(message_of("displacement_mm,force_kN\n"), HasSubstr("not the header"));
    EXPECT_THAT(message_of("displacement_mm,force_mN\n0,0\n1,nan\n"),
                HasSubstr("curve.csv:3: \"1,nan\" is not a point"));
    EXPECT_THAT(message_of("displacement_mm,force_mN\n0,0\n1,2,3\n"), HasSubstr("are 2 numbers"));
    EXPECT_THAT(message_of("displacement_mm,force_mN\n0,0\n1,2\n1,3\n"),
                HasSubstr("curve.csv:4: displacement 1 mm does not follow"));
    EXPECT_THAT(message_of("displacement_mm,force_mN\n0,0\n1,2\n2,3\n"),
                HasSubstr("3 points; at least 4"));
    EXPECT_THAT(message_of("displacement_mm,force_mN\n0,0\n1,0\n2,-1\n3,0\n"),
                HasSubstr("curve.csv: no mean force is above zero"));
}

}  // namespace braidzone
