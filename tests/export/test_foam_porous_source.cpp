#include "export/foam_format.hpp"
#include "export/foam_porous_source.hpp"
#include "support/temporary_folder.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>

namespace braidzone {
namespace {

std::string text_of(const std::filesystem::path& file)
{
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

const FoamPorousSource source{.name = "FD_0000",
                              .cell_zone = "FD_0000",
                              .darcy = Vec3(4e8, 1e8, 1e8),
                              .forchheimer = Vec3(5000.0, 500.0, 500.0),
                              .e1 = Vec3::UnitZ()};

TEST(PorousSources, StatesTensorAlongTheZonesAxes)
{
    const std::string text = porous_sources({source});
    EXPECT_NE(text.find("cellZone        FD_0000;"), std::string::npos);
    EXPECT_NE(text.find("d [0 -2 0 0 0 0 0] (400000000 100000000 100000000);"), std::string::npos);
    EXPECT_NE(text.find("f [0 -1 0 0 0 0 0] (5000 500 500);"), std::string::npos);
    EXPECT_NE(text.find("e1              (0 0 1);"), std::string::npos);
    EXPECT_EQ(text.find(" nu "), std::string::npos);
}

TEST(PorousSources, NamesAnotherViscosityField)
{
    FoamPorousSource other = source;
    other.viscosity_field = "fdNuD_x";
    EXPECT_NE(porous_sources({other}).find("        nu              fdNuD_x;\n"),
              std::string::npos);
}

// nu D = 4e-6 m^2/s times D, and half of F.
TEST(PorousSources, KeepAViscosityWithFixedCoefficients)
{
    FoamPorousSource fixed = source;
    fixed.viscosity = 4e-6;
    const std::string text = porous_sources({fixed});
    EXPECT_EQ(text.find("DarcyForchheimer"), std::string::npos);
    EXPECT_NE(text.find("fixedCoeff;"), std::string::npos);
    EXPECT_NE(text.find("alpha [0 0 -1 0 0 0 0] (1600 400 400);"), std::string::npos) << text;
    EXPECT_NE(text.find("beta [0 -1 0 0 0 0 0] (2500 250 250);"), std::string::npos) << text;
}

TEST(WritePorousSources, MakesBothDictionaries)
{
    const test::TemporaryFolder folder;
    const auto files = write_porous_sources(folder.path(), {source});
    EXPECT_EQ(files.size(), 3U);
    EXPECT_EQ(text_of(folder.path() / "constant/fdPorosity"), porous_sources({source}));
    for (const char* name : {"fvOptions", "fvModels"}) {
        const auto file = folder.path() / "constant" / name;
        EXPECT_EQ(FoamReader(file).header().class_name, "dictionary");
        EXPECT_NE(text_of(file).find("#include \"fdPorosity\""), std::string::npos);
    }
}

// A user's own source stays, and a second call adds nothing.
TEST(WritePorousSources, KeepsWhatACaseHas)
{
    const test::TemporaryFolder folder;
    const std::string own = "FoamFile { class dictionary; }\nheater { type x; }";
    folder.write("constant/fvOptions", own);
    write_porous_sources(folder.path(), {source});
    const std::string once = text_of(folder.path() / "constant/fvOptions");
    EXPECT_EQ(once.find(own + "\n"), 0U);
    EXPECT_NE(once.find("#include \"fdPorosity\""), std::string::npos);
    const auto files = write_porous_sources(folder.path(), {source});
    EXPECT_EQ(files.size(), 1U);
    EXPECT_EQ(text_of(folder.path() / "constant/fvOptions"), once);
}

// OpenFOAM reads system/fvOptions only where constant/fvOptions is missing.
TEST(WritePorousSources, DoesNotHideOptionsInSystem)
{
    const test::TemporaryFolder folder;
    folder.write("system/fvOptions", "FoamFile { class dictionary; }\nheater { type x; }\n");
    write_porous_sources(folder.path(), {source});
    EXPECT_FALSE(std::filesystem::exists(folder.path() / "constant/fvOptions"));
    EXPECT_NE(
        text_of(folder.path() / "system/fvOptions").find("#include \"../constant/fdPorosity\""),
        std::string::npos);
}

}  // namespace
}  // namespace braidzone
