#include "core/error.hpp"
#include "export/foam_face_zones.hpp"
#include "support/temporary_folder.hpp"

#include <gtest/gtest.h>

#include <string>

namespace braidzone {
namespace {

constexpr const char* file = "constant/polyMesh/faceZones";

TEST(FaceZones, AreReadBackAsWritten)
{
    const test::TemporaryFolder folder;
    EXPECT_TRUE(read_face_zones(folder.path()).empty());
    write_face_zones(folder.path(), {{"neck", {3, 5, 8}, {0, 1, 1}}, {"wall", {9}, {0}}});
    const auto zones = read_face_zones(folder.path());
    ASSERT_EQ(zones.size(), 2U);
    EXPECT_EQ(zones[0].name, "neck");
    EXPECT_EQ(zones[0].faces, (std::vector<int>{3, 5, 8}));
    EXPECT_EQ(zones[0].flipped, (std::vector<int>{0, 1, 1}));
    EXPECT_EQ(zones[1].faces, (std::vector<int>{9}));
}

// As OpenFOAM writes it: labels of four bytes and sides of one, raw; equal ones as 2{0}.
TEST(FaceZones, AreReadFromBinaryFiles)
{
    const test::TemporaryFolder folder;
    std::string text =
        "FoamFile { version 2.0; format binary; class regIOobject; arch "
        "\"LSB;label=32;scalar=64\"; }\n2\n(\nrotor\n{\ntype faceZone;\nfaceLabels      "
        "List<label> \n3\n(";
    for (const char value : {7, 8, 9})
        text += std::string{value, 0, 0, 0};
    text += ");\nflipMap         List<bool> \n3\n(";
    text += std::string{1, 0, 1};
    text +=
        ");\n}\nstator\n{\ntype faceZone;\nfaceLabels List<label> 2{4};\nflipMap List<bool> "
        "2{0};\n}\n)\n";
    folder.write(file, text);
    const auto zones = read_face_zones(folder.path());
    ASSERT_EQ(zones.size(), 2U);
    EXPECT_EQ(zones[0].faces, (std::vector<int>{7, 8, 9}));
    EXPECT_EQ(zones[0].flipped, (std::vector<int>{1, 0, 1}));
    EXPECT_EQ(zones[1].faces, (std::vector<int>{4, 4}));
    EXPECT_EQ(zones[1].flipped, (std::vector<int>{0, 0}));
}

TEST(FaceZones, RefuseASideThatIsNone)
{
    const test::TemporaryFolder folder;
    folder.write(file,
                 "FoamFile { version 2.0; format ascii; class regIOobject; }\n1(a { type faceZone; "
                 "faceLabels List<label> 1(4); flipMap List<bool> 1(2); })\n");
    try {
        read_face_zones(folder.path());
        FAIL() << "accepted";
    } catch (const InputError& error) {
        EXPECT_NE(std::string(error.what()).find("faceZones:2: 2 where 0 or 1 is expected"),
                  std::string::npos)
            << error.what();
    }
}

}  // namespace
}  // namespace braidzone
