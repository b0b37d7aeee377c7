#include "core/error.hpp"
#include "porous/pressure_curve.hpp"
#include "support/temporary_folder.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace braidzone {
namespace {

std::string message_of(const std::string& text)
{
    const test::TemporaryFolder folder;
    try {
        read_pressure_curve(folder.write("drop.csv", text));
    } catch (const Error& error) {
        return error.what();
    }
    return "no error";
}

}  // namespace

TEST(PressureCurve, IsInSiUnitsAndTheMeanOfItsRepeats)
{
    const test::TemporaryFolder folder;
    const RepeatCurve curve =
        read_pressure_curve(folder.write("drop.csv",
                                         "velocity_cm_s,pressure_drop_1_Pa,pressure_drop_2_mmHg\n"
                                         "5,25,0\n10,50,0\n15,80,0\n20,110,1\n"));
    EXPECT_EQ(curve.num_repeats, 2);
    EXPECT_DOUBLE_EQ(curve.abscissae[1], 0.10);
    EXPECT_NEAR(curve.means[3], 0.5 * (110.0 + 133.322387415), 1e-9);
}

TEST(PressureCurve, RefusesWhatIsNoPressureCurve)
{
    using testing::HasSubstr;
    EXPECT_THAT(message_of("v,p\n0,0\n"), HasSubstr("not the header of a pressure-drop curve"));
    EXPECT_THAT(message_of("velocity_m_s,pressure_drop_Pa\n0.1,x\n"),
                HasSubstr("drop.csv:2: \"0.1,x\" is not a point"));
    EXPECT_THAT(message_of("velocity_m_s,pressure_drop_Pa\n0.2,9\n0.1,4\n"),
                HasSubstr("drop.csv:3: velocity 100 mm/s does not follow"));
    EXPECT_THAT(message_of("velocity_m_s,pressure_drop_Pa\n0.1,0\n0.2,0\n0.3,-1\n0.4,0\n"),
                HasSubstr("no mean pressure drop is above zero"));
}

}  // namespace braidzone
