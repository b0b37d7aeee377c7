#include "core/error.hpp"
#include "export/foam_mesh.hpp"
#include "support/foam_box.hpp"
#include "support/temporary_folder.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <cstring>

namespace braidzone {
namespace {

std::string header(const std::string& class_name, const std::string& format = "ascii")
{
    return "FoamFile { version 2.0; format " + format + "; class " + class_name +
           "; arch \"LSB;label=32;scalar=64\"; }\n";
}

const std::string polymesh = "constant/polyMesh/";

/// Two cells on top of each other: the unit cube, and a pyramid of height 3 on its top (z = 1).
void write_cube_with_pyramid(const test::TemporaryFolder& folder)
{
    folder.write(
        polymesh + "points",
        header("vectorField") +
            "9((0 0 0) (1 0 0) (1 1 0) (0 1 0) (0 0 1) (1 0 1) (1 1 1) (0 1 1) (0.5 0.5 4))");
    folder.write(
        polymesh + "faces",
        header("faceList") +
            "10\n(\n4(4 5 6 7)\n4(0 3 2 1)\n4(0 1 5 4)\n4(1 2 6 5)\n4(2 3 7 6)\n4(3 0 4 7)\n"
            "3(4 5 8)\n3(5 6 8)\n3(6 7 8)\n3(7 4 8)\n)");
    folder.write(polymesh + "owner", header("labelList") + "10(0 0 0 0 0 0 1 1 1 1)");
    folder.write(polymesh + "neighbour", header("labelList") + "1(1)");
    folder.write(polymesh + "boundary",
                 header("polyBoundaryMesh") +
                     "2\n(\ninlet { type patch; nFaces 1; startFace 1; }\n"
                     "wall { type wall; inGroups 1(wall); nFaces 8; startFace 2; }\n)");
}

std::string message_of_reading(const std::filesystem::path& folder)
{
    try {
        read_foam_mesh(folder);
    } catch (const Error& error) {
        return error.what();
    }
    return "no error";
}

// Volumes 1 and 1/3 base height = 1; the centroid of a pyramid is a quarter of its height up.
TEST(ReadFoamMesh, MeasuresCubeAndPyramid)
{
    const test::TemporaryFolder folder;
    write_cube_with_pyramid(folder);
    const FoamMesh mesh = read_foam_mesh(folder.path());
    ASSERT_EQ(mesh.num_cells(), 2);
    EXPECT_NEAR(mesh.cell_volumes[0], 1.0, 1e-14);
    EXPECT_NEAR(mesh.cell_volumes[1], 1.0, 1e-14);
    EXPECT_LT((mesh.cell_centres[0] - Vec3(0.5, 0.5, 0.5)).norm(), 1e-14);
    EXPECT_LT((mesh.cell_centres[1] - Vec3(0.5, 0.5, 1.75)).norm(), 1e-14);
    ASSERT_EQ(mesh.patches.size(), 2U);
    EXPECT_EQ(mesh.patches[1].name, "wall");
    EXPECT_EQ(mesh.patches[1].type, "wall");
    EXPECT_EQ(mesh.patches[1].start_face, 2);
    EXPECT_EQ(mesh.patches[1].num_faces, 8);
}

TEST(ReadFoamMesh, ReadsTheSameMeshFromBinary)
{
    const test::TemporaryFolder folder;
    write_cube_with_pyramid(folder);
    const FoamMesh ascii = read_foam_mesh(folder.path());

    const auto raw = [](const auto& numbers) {
        std::string bytes(numbers.size() * sizeof numbers[0], '\0');
        std::memcpy(bytes.data(), numbers.data(), bytes.size());
        return std::to_string(numbers.size()) + "\n(" + bytes + ")\n";
    };
    std::vector<double> coordinates;
    for (const Vec3& p : ascii.points)
        coordinates.insert(coordinates.end(), {p.x(), p.y(), p.z()});
    std::string points = raw(coordinates);
    points.replace(0, points.find('\n'), "9");  // vectors, not numbers
    std::vector<std::int32_t> starts{0}, corners;
    for (const auto& face : ascii.faces) {
        corners.insert(corners.end(), face.begin(), face.end());
        starts.push_back(static_cast<std::int32_t>(corners.size()));
    }
    folder.write(polymesh + "points", header("vectorField", "binary") + points);
    folder.write(polymesh + "faces",
                 header("faceCompactList", "binary") + raw(starts) + raw(corners));
    folder.write(polymesh + "owner", header("labelList", "binary") + raw(ascii.owner));
    folder.write(polymesh + "neighbour", header("labelList", "binary") + raw(ascii.neighbour));

    const FoamMesh binary = read_foam_mesh(folder.path());
    EXPECT_EQ(binary.points, ascii.points);
    EXPECT_EQ(binary.faces, ascii.faces);
    EXPECT_EQ(binary.owner, ascii.owner);
    EXPECT_EQ(binary.neighbour, ascii.neighbour);
    EXPECT_EQ(binary.cell_volumes, ascii.cell_volumes);
}

TEST(ReadFoamMesh, RefusesDecomposedCase)
{
    const test::TemporaryFolder folder;
    folder.write("processor0/constant/polyMesh/points", "");
    EXPECT_THROW(read_foam_mesh(folder.path()), InputError);
    EXPECT_NE(message_of_reading(folder.path()).find("the mesh is decomposed"), std::string::npos);
}

TEST(ReadFoamMesh, RefusesMissingMesh)
{
    const test::TemporaryFolder folder;
    EXPECT_THROW(read_foam_mesh(folder.path()), IoError);
    EXPECT_NE(message_of_reading(folder.path()).find("mesh the case first"), std::string::npos);
}

TEST(ReadFoamMesh, RefusesContentThatIsNoMesh)
{
    const test::TemporaryFolder folder;
    write_cube_with_pyramid(folder);
    folder.write(polymesh + "owner", header("labelList") + "9(0 0 0 0 0 0 1 1 1)");
    EXPECT_NE(message_of_reading(folder.path()).find("10 faces but 9 owners"), std::string::npos);
    folder.write(polymesh + "owner", header("labelList") + "10(0 0 0 0 0 0 1 1 1 3)");
    EXPECT_NE(message_of_reading(folder.path()).find("cell 2 has 0 faces"), std::string::npos);

    write_cube_with_pyramid(folder);
    folder.write(polymesh + "neighbour", header("labelList") + "1(-1)");
    EXPECT_NE(
        message_of_reading(folder.path()).find("face 0 has cell -1; allowed 0 to 4, for 10 faces"),
        std::string::npos);

    write_cube_with_pyramid(folder);
    folder.write(polymesh + "boundary",
                 header("polyBoundaryMesh") + "1(wall { type wall; nFaces 20; startFace 1; })");
    EXPECT_NE(message_of_reading(folder.path()).find("patch wall has faces 1 to 20; there are 10"),
              std::string::npos);
}

// The pyramid turned inside out: its top below its base.
TEST(ReadFoamMesh, RefusesCellsWithoutVolume)
{
    const test::TemporaryFolder folder;
    write_cube_with_pyramid(folder);
    folder.write(
        polymesh + "points",
        header("vectorField") +
            "9((0 0 0) (1 0 0) (1 1 0) (0 1 0) (0 0 1) (1 0 1) (1 1 1) (0 1 1) (0.5 0.5 -2))");
    EXPECT_NE(message_of_reading(folder.path()).find("cell 1 has volume -1"), std::string::npos);
}

TEST(CellGeometry, BlockOfCubes)
{
    const FoamMesh mesh = test::foam_box({3, 2, 2}, 0.5, Vec3(1, 2, 3));
    ASSERT_EQ(mesh.num_cells(), 12);
    for (const double volume : mesh.cell_volumes)
        EXPECT_NEAR(volume, 0.125, 1e-15);
    // Cell (2, 1, 0).
    EXPECT_LT((mesh.cell_centres[5] - Vec3(2.25, 2.75, 3.25)).norm(), 1e-14);
}

}  // namespace
}  // namespace braidzone
