#include "core/error.hpp"
#include "export/foam_apply.hpp"
#include "export/foam_cell_zones.hpp"
#include "export/foam_face_zones.hpp"
#include "export/foam_format.hpp"
#include "support/braids.hpp"
#include "support/foam_box.hpp"
#include "support/foam_poly_mesh.hpp"
#include "support/temporary_folder.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <cstring>
#include <fstream>
#include <iterator>

namespace braidzone {
namespace {

std::string text_of(const std::filesystem::path& file)
{
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

/// A sheet over the whole block at height z.
ResistanceSheet sheet_at(double z)
{
    const auto surface = test::flat_braid(Vec3(0, 0, z), Vec3::UnitX() * 0.2e-3, 10,
                                          Vec3::UnitY() * 0.2e-3, 10, 30e-6);
    return make_resistance_sheet(surface, ConstantLaw{{490.0, 330.0}}, Fluid{});
}

class ApplyToFoamCase : public ::testing::Test {
protected:
    // A vessel of 0.8 mm under a sac of 2.2 mm: 2 x 2 x 3 mm in cells of 0.1 mm.
    void SetUp() override
    {
        FoamMesh mesh = test::foam_box({20, 20, 30}, 0.1e-3);
        for (const char* patch : {"inlet", "outlet"})
            test::split_patch(mesh, patch, {std::string(patch) + "_rest", "wall"},
                              [](const Vec3& centre) { return centre.z() > 0.8e-3; });
        test::write_poly_mesh(folder_.path(), mesh);
    }
    test::TemporaryFolder folder_;
};

// The sheet's integral by hand: 490 / 3.5e-3 1/m over 4 mm^2 is 0.56 m.
TEST_F(ApplyToFoamCase, WritesZonesWhoseIntegralIsTheSheets)
{
    const FoamApplication applied = apply_to_foam_case(folder_.path(), sheet_at(1.23e-3));
    EXPECT_EQ(applied.num_cells, 12000);
    EXPECT_NEAR(applied.integral_sheet, 0.56, 1e-12);
    EXPECT_NEAR(applied.integral_mesh, 0.56, 1e-12);

    const auto zones = read_cell_zones(folder_.path());
    ASSERT_EQ(zones.size(), static_cast<std::size_t>(applied.num_zones) + 1);
    std::size_t num_resistant = 0;
    for (const auto& zone : zones)
        if (zone.name != "sac") num_resistant += zone.cells.size();
    EXPECT_EQ(num_resistant, static_cast<std::size_t>(applied.num_resistant_cells));
    for (const auto& file : applied.files)
        EXPECT_FALSE(text_of(folder_.path() / file).empty()) << file;
}

// The kernel reaches 0.3 mm up from 1.23 mm: cells with centres above 1.53 mm are the sac.
TEST_F(ApplyToFoamCase, FindsTheSacAndReportsItsSpeed)
{
    const FoamApplication applied = apply_to_foam_case(folder_.path(), sheet_at(1.23e-3));
    ASSERT_EQ(applied.sac_volumes.size(), 1U);
    EXPECT_NEAR(applied.sac_volumes[0], 4e-6 * 1.5e-3, 1e-14);
    EXPECT_EQ(read_cell_zones(folder_.path()).back().name, "sac");
    EXPECT_NE(text_of(folder_.path() / "system/fdFunctions").find("volFieldValue"),
              std::string::npos);
    // A neck of 20 x 20 faces; around the sac four sides of 15 layers and a roof.
    const auto faces = read_face_zones(folder_.path());
    ASSERT_EQ(faces.size(), 2U);
    EXPECT_EQ(faces[0].name, "sac_neck");
    EXPECT_EQ(faces[0].faces.size(), 400U);
    EXPECT_EQ(faces[1].name, "sac_wall");
    EXPECT_EQ(faces[1].faces.size(), 4U * 20U * 15U + 400U);
}

// Applied again where it closes nothing off: the old zones, and the report on the sac, are gone.
TEST_F(ApplyToFoamCase, ReplacesWhatItWroteBefore)
{
    apply_to_foam_case(folder_.path(), sheet_at(1.23e-3));
    ResistanceSheet sheet = sheet_at(1.23e-3);
    for (double& acting : sheet.acting)
        acting = 0.0;
    const FoamApplication applied = apply_to_foam_case(folder_.path(), sheet);
    EXPECT_EQ(applied.num_zones, 0);
    EXPECT_TRUE(applied.sac_volumes.empty());
    EXPECT_TRUE(read_cell_zones(folder_.path()).empty());
    EXPECT_TRUE(read_face_zones(folder_.path()).empty());
    EXPECT_FALSE(std::filesystem::exists(folder_.path() / "system/fdFunctions"));
    ASSERT_EQ(applied.warnings.size(), 1U);
    EXPECT_NE(applied.warnings[0].find("the device meets no flow"), std::string::npos);
}

TEST_F(ApplyToFoamCase, InspectionFieldHoldsTheDepositedResistance)
{
    const FoamApplication applied = apply_to_foam_case(folder_.path(), sheet_at(1.23e-3));
    FoamReader reader(folder_.path() / "0/fdDarcy");
    EXPECT_EQ(reader.header().class_name, "volScalarField");
    while (reader.word() != "internalField")
        reader.entry();
    EXPECT_EQ(reader.word(), "nonuniform");
    EXPECT_EQ(reader.word(), "List<scalar>");
    double sum = 0.0;
    for (const double darcy : reader.scalars())
        sum += darcy * 1e-12;
    EXPECT_NEAR(sum / applied.integral_sheet, 1.0, 1e-8);  // written with nine digits
}

// A case whose start fields are kept in 0.orig: `cp -r 0.orig 0` must not find a folder 0.
TEST_F(ApplyToFoamCase, PutsFieldsBesideTheStartFieldsOfTheCase)
{
    folder_.write("0.orig/U", "");
    apply_to_foam_case(folder_.path(), sheet_at(1.23e-3));
    EXPECT_TRUE(std::filesystem::exists(folder_.path() / "0.orig/fdZone"));
    EXPECT_FALSE(std::filesystem::exists(folder_.path() / "0"));
}

// As OpenFOAM writes zones in binary: the labels are raw, the rest is text.
TEST_F(ApplyToFoamCase, KeepsZonesOfTheMeshAndReplacesItsOwn)
{
    const std::vector<std::int32_t> labels{40, 41};
    std::string raw(8, '\0');
    std::memcpy(raw.data(), labels.data(), raw.size());
    folder_.write("constant/polyMesh/cellZones",
                  "FoamFile { version 2.0; format binary; class regIOobject; arch "
                  "\"LSB;label=32;scalar=64\"; }\n2\n(\nrotor\n{\ntype cellZone;\ncellLabels      "
                  "List<label> \n2\n(" +
                      raw +
                      ");\n}\n\nFD_0999\n{\ntype cellZone;\ncellLabels List<label> 0;\n}\n)\n");
    apply_to_foam_case(folder_.path(), sheet_at(1.23e-3));
    const auto zones = read_cell_zones(folder_.path());
    EXPECT_EQ(zones.front().name, "rotor");
    EXPECT_EQ(zones.front().cells, (std::vector<int>{40, 41}));
    for (const auto& zone : zones)
        EXPECT_NE(zone.name, "FD_0999");
}

// Each form leaves nothing of the others behind.
TEST_F(ApplyToFoamCase, ChangesFromFormToForm)
{
    const auto apply = [&](FoamForm form) {
        return apply_to_foam_case(folder_.path(), sheet_at(1.23e-3), {.form = form});
    };
    const auto is_there = [&](const char* file) {
        return std::filesystem::exists(folder_.path() / file);
    };
    const FoamApplication cells = apply(FoamForm::per_cell);
    EXPECT_NEAR(cells.integral_mesh, 0.56, 1e-12);
    EXPECT_TRUE(is_there("0/fdNuD_z"));
    EXPECT_NE(text_of(folder_.path() / "system/fdFunctions").find("readFields"), std::string::npos);
    ASSERT_EQ(cells.warnings.size(), 1U);
    EXPECT_NE(cells.warnings[0].find("3.31439e-06 m^2/s"), std::string::npos);

    const FoamApplication faces = apply(FoamForm::baffles);
    EXPECT_NEAR(faces.integral_mesh, 0.56, 1e-12);
    EXPECT_FALSE(is_there("0/fdNuD_z"));
    EXPECT_TRUE(is_there("system/fdBaffles"));
    EXPECT_EQ(text_of(folder_.path() / "constant/fdPorosity").find("explicitPorositySource"),
              std::string::npos);
    EXPECT_FALSE(read_face_zones(folder_.path()).empty());

    apply(FoamForm::zones);
    EXPECT_FALSE(is_there("system/fdBaffles"));
    for (const auto& zone : read_face_zones(folder_.path()))
        EXPECT_FALSE(zone.name.starts_with("FD_"));
    EXPECT_NE(text_of(folder_.path() / "constant/fdPorosity").find("explicitPorositySource"),
              std::string::npos);
}

TEST_F(ApplyToFoamCase, SaysThatTheCaseHasAnotherViscosity)
{
    folder_.write("constant/transportProperties",
                  "FoamFile { class dictionary; }\ntransportModel Newtonian;\nnu 4e-6;\n");
    const FoamApplication applied = apply_to_foam_case(folder_.path(), sheet_at(1.23e-3));
    ASSERT_EQ(applied.warnings.size(), 1U);
    EXPECT_NE(applied.warnings[0].find("viscosity of 4e-06 m^2/s"), std::string::npos);
}

TEST_F(ApplyToFoamCase, SaysThatDecomposedCopiesAreOld)
{
    folder_.write("processor0/constant/polyMesh/points", "");
    const FoamApplication applied = apply_to_foam_case(folder_.path(), sheet_at(1.23e-3));
    ASSERT_EQ(applied.warnings.size(), 1U);
    EXPECT_NE(applied.warnings[0].find("run decomposePar -force again"), std::string::npos);
}

TEST(ApplyToFoamMesh, RefusesMillimetres)
{
    const test::TemporaryFolder folder;
    test::write_poly_mesh(folder.path(), test::foam_box({20, 20, 30}, 0.1));
    try {
        apply_to_foam_case(folder.path(), sheet_at(1.23e-3));
        FAIL();
    } catch (const GeometryError& error) {
        EXPECT_NE(std::string(error.what()).find("is the mesh in millimetres?"), std::string::npos);
    }
    EXPECT_FALSE(std::filesystem::exists(folder.path() / "constant/fdPorosity"));
}

TEST(ApplyToFoamMesh, RefusesBafflesOfAnEarlierCall)
{
    const test::TemporaryFolder folder;
    FoamMesh mesh = test::foam_box({20, 20, 30}, 0.1e-3);
    mesh.patches.back().name = "FD_0000_front";
    mesh.patches.back().type = "cyclic";
    test::write_poly_mesh(folder.path(), mesh);
    EXPECT_THROW(apply_to_foam_case(folder.path(), sheet_at(1.23e-3)), InputError);
}

TEST_F(ApplyToFoamCase, GivesTheSameBytesAgain)
{
    apply_to_foam_case(folder_.path(), sheet_at(1.23e-3));
    const std::string first = text_of(folder_.path() / "constant/fdPorosity");
    const std::string zones = text_of(folder_.path() / "constant/polyMesh/cellZones");
    apply_to_foam_case(folder_.path(), sheet_at(1.23e-3));
    EXPECT_EQ(text_of(folder_.path() / "constant/fdPorosity"), first);
    EXPECT_EQ(text_of(folder_.path() / "constant/polyMesh/cellZones"), zones);
}

}  // namespace
}  // namespace braidzone
