#include "core/error.hpp"
#include "core/length_unit.hpp"

#include <gtest/gtest.h>

namespace braidzone {
namespace {

TEST(LengthUnit, KnowsTheUnitsOfSurfaceFiles)
{
    EXPECT_EQ(length_unit("m").metres, 1.0);
    EXPECT_EQ(length_unit("cm").metres, 1e-2);
    EXPECT_EQ(length_unit("mm").metres, 1e-3);
    EXPECT_EQ(length_unit("um").metres, 1e-6);
    EXPECT_EQ(length_unit("um").name, "um");
}

TEST(LengthUnit, RefusesAnyOtherNameAndListsTheAllowedOnes)
{
    for (const std::string name : {"", "MM", "inch", "mm "}) {
        try {
            length_unit(name);
            FAIL() << name << " was accepted";
        } catch (const ConfigError& error) {
            EXPECT_EQ(std::string(error.what()),
                      "\"" + name + "\" is not a length unit; allowed are m, cm, mm, um");
        }
    }
}

}  // namespace
}  // namespace braidzone
