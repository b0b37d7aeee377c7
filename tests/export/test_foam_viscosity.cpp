#include "export/foam_viscosity.hpp"
#include "support/temporary_folder.hpp"

#include <gtest/gtest.h>

namespace braidzone {
namespace {

constexpr const char* header = "FoamFile { version 2.0; format ascii; class dictionary; }\n";

TEST(CaseViscosity, ReadsEverySpelling)
{
    for (const char* entry : {"nu 3.3e-6;", "nu [0 2 -1 0 0 0 0] 3.3e-6;",
                              "nu nu [ 0 2 -1 0 0 0 0 ] 3.3e-6 ;", "nu [0 2 -1 0 0 0 0]3.3e-6;"}) {
        const test::TemporaryFolder folder;
        folder.write("constant/transportProperties",
                     std::string(header) + "transportModel  Newtonian;\n" + entry + "\n");
        EXPECT_EQ(case_viscosity(folder.path()), 3.3e-6) << entry;
    }
}

TEST(CaseViscosity, ReadsThePhysicalPropertiesOfOpenfoamOrg)
{
    const test::TemporaryFolder folder;
    folder.write("constant/physicalProperties",
                 std::string(header) + "viscosityModel constant;\nnu 2e-6;\n");
    EXPECT_EQ(case_viscosity(folder.path()), 2e-6);
}

TEST(CaseViscosity, IsAbsentWhereItIsNoNumberOfTheCase)
{
    const test::TemporaryFolder folder;
    EXPECT_FALSE(case_viscosity(folder.path()).has_value());
    for (const char* text :
         {"transportModel BirdCarreau;\nnu 3e-6;\nBirdCarreauCoeffs { nu0 1e-5; inner { a 1; } }\n",
          "transportModel Newtonian;\nCoeffs { nu 3e-6; }\n", "nu $viscosity;\n", "nu\n", "{\n"}) {
        folder.write("constant/transportProperties", std::string(header) + text);
        EXPECT_FALSE(case_viscosity(folder.path()).has_value()) << text;
    }
}

}  // namespace
}  // namespace braidzone
