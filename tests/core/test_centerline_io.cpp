#include "core/centerline_io.hpp"
#include "core/error.hpp"

#include <gtest/gtest.h>
#include <vtkDataArray.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkXMLPolyDataReader.h>

#include <filesystem>
#include <fstream>
#include <limits>
#include <string>

namespace braidzone {
namespace {

namespace fs = std::filesystem;
const LengthUnit mm{"mm", 1e-3};

fs::path scratch(const std::string& name)
{
    const std::string test = testing::UnitTest::GetInstance()->current_test_info()->name();
    const fs::path folder = fs::path(testing::TempDir()) / ("centerline_io_" + test);
    fs::create_directories(folder);
    return folder / name;
}

fs::path written(const std::string& name, const std::string& text)
{
    const fs::path path = scratch(name);
    std::ofstream(path) << text;
    return path;
}

Polyline example()
{
    Polyline line;
    line.points = {Vec3(0.1e-3, 0.2e-3, 0.3e-3), Vec3(1.0 / 3.0, -2e-7, 7e-3), Vec3(0, 0, 9e-3)};
    line.inscribed_radii = {1.9e-3, 1.0 / 700.0, 1.7e-3};
    return line;
}

TEST(WriteCenterline, ReadingBackGivesTheSameValues)
{
    const Polyline line = example();
    for (const LengthUnit& unit : {mm, LengthUnit{"m", 1.0}, LengthUnit{"cm", 1e-2}}) {
        write_centerline(scratch("line.vtp"), line, unit);
        const Polyline read = read_centerline(scratch("line.vtp"), unit);
        ASSERT_EQ(read.points.size(), 3u);
        for (std::size_t i = 0; i < 3; ++i) {
            for (int axis = 0; axis < 3; ++axis) {
                EXPECT_DOUBLE_EQ(read.points[i][axis], line.points[i][axis]);
            }
            EXPECT_DOUBLE_EQ(read.inscribed_radii[i], line.inscribed_radii[i]);
        }
    }
}

TEST(WriteCenterline, IsWhatVmtkWouldWrite)
{
    write_centerline(scratch("line.vtp"), example(), mm);
    const auto reader = vtkSmartPointer<vtkXMLPolyDataReader>::New();
    reader->SetFileName(scratch("line.vtp").c_str());
    reader->Update();
    vtkPolyData* data = reader->GetOutput();
    ASSERT_EQ(data->GetNumberOfPoints(), 3);
    EXPECT_EQ(data->GetNumberOfLines(), 1);
    EXPECT_EQ(data->GetNumberOfCells(), 1);
    EXPECT_DOUBLE_EQ(data->GetPoint(2)[2], 9.0);
    vtkDataArray* radii = data->GetPointData()->GetArray("MaximumInscribedSphereRadius");
    ASSERT_NE(radii, nullptr);
    EXPECT_DOUBLE_EQ(radii->GetTuple1(0), 1.9);
}

TEST(WriteCenterline, RefusesAnUnwritablePlace)
{
    EXPECT_THROW(write_centerline("/no/such/folder/line.vtp", example(), mm), IoError);
}

TEST(WriteCenterline, WithoutRadiiReadsBackWithoutRadii)
{
    Polyline line = example();
    line.inscribed_radii.clear();
    write_centerline(scratch("line.vtp"), line, mm);
    EXPECT_TRUE(read_centerline(scratch("line.vtp"), mm).inscribed_radii.empty());
}

// Points 0 to 3 are a line along x, points 4 and 5 another one from its start.
const std::string points = R"(# vtk DataFile Version 3.0
lines
ASCII
DATASET POLYDATA
POINTS 6 float
0 0 0  1 0 0  2 0 0  3 0 0  0 0 0  0 5 0
)";

TEST(ReadCenterline, LegacyVtkWithRadii)
{
    const Polyline line =
        read_centerline(written("line.vtk", points + "LINES 1 5\n4 0 1 2 3\nPOINT_DATA 6\n"
                                                     "SCALARS MaximumInscribedSphereRadius double\n"
                                                     "LOOKUP_TABLE default\n"
                                                     "2 1.9 1.8 1.7 2 2\n"),
                        mm);
    ASSERT_EQ(line.points.size(), 4u);
    EXPECT_NEAR(line.points[3].x(), 3e-3, 1e-12);
    ASSERT_EQ(line.inscribed_radii.size(), 4u);
    EXPECT_NEAR(line.inscribed_radii[1], 1.9e-3, 1e-12);
}

// As VMTK's branch extraction writes them: cells that continue each other, with branch numbers.
TEST(ReadCenterline, JoinsCellsOfOneLineAndIgnoresBranchArrays)
{
    const Polyline line = read_centerline(
        written("line.vtk", points + "LINES 2 7\n2 0 1\n3 1 2 3\nCELL_DATA 2\n"
                                     "SCALARS GroupIds int\nLOOKUP_TABLE default\n0 1\n"),
        mm);
    ASSERT_EQ(line.points.size(), 4u);
    EXPECT_NEAR(line.points[1].x(), 1e-3, 1e-12);
    EXPECT_NEAR(line.points[2].x(), 2e-3, 1e-12);
    EXPECT_TRUE(line.inscribed_radii.empty());
}

// The pieces may have points of their own at the place where they meet.
TEST(ReadCenterline, JoinsCellsThatMeetInRepeatedPoints)
{
    const Polyline line =
        read_centerline(written("line.vtk", points + "LINES 2 8\n2 5 4\n4 0 1 2 3\n"), mm);
    ASSERT_EQ(line.points.size(), 5u);
    EXPECT_NEAR(line.points[0].y(), 5e-3, 1e-12);
    EXPECT_NEAR(line.points[4].x(), 3e-3, 1e-12);
}

void expect_refused(const fs::path& path, const std::string& words, int line = -1)
{
    try {
        read_centerline(path, mm, line);
        FAIL() << "not refused: " << words;
    } catch (const Error& error) {
        EXPECT_NE(std::string(error.what()).find(words), std::string::npos) << error.what();
    }
}

TEST(ReadCenterline, OneOfSeveralLinesIsChosen)
{
    const fs::path path = written("lines.vtk", points + "LINES 2 8\n4 0 1 2 3\n2 4 5\n");
    EXPECT_EQ(read_centerline(path, mm, 0).points.size(), 4u);
    EXPECT_NEAR(read_centerline(path, mm, 1).points.at(1).y(), 5e-3, 1e-12);
    expect_refused(path, "holds 2 lines; say which one, 0 to 1");
    expect_refused(path, "line 2 is wanted", 2);
    expect_refused(path, "line -3 is wanted", -3);
}

TEST(ReadCenterline, CsvWithAndWithoutNames)
{
    const Polyline plain = read_centerline(written("a.csv", "0, 0, 0\n1.5, 2, 3\n\n"), mm);
    ASSERT_EQ(plain.points.size(), 2u);
    EXPECT_NEAR((plain.points[1] - Vec3(1.5e-3, 2e-3, 3e-3)).norm(), 0.0, 1e-15);
    EXPECT_TRUE(plain.inscribed_radii.empty());

    const Polyline with_radius = read_centerline(written("b.csv", "0,0,0,2\n1,2,3,1.5\n"), mm);
    EXPECT_NEAR(with_radius.inscribed_radii.at(1), 1.5e-3, 1e-15);

    const Polyline named = read_centerline(
        written("c.csv", "# from a viewer\n\"Radius\";X;Y;Z;name\n2;0;0;0;a\r\n1.5;1;2;3;b\r\n"),
        mm);
    ASSERT_EQ(named.points.size(), 2u);
    EXPECT_NEAR((named.points[1] - Vec3(1e-3, 2e-3, 3e-3)).norm(), 0.0, 1e-15);
    EXPECT_NEAR(named.inscribed_radii.at(0), 2e-3, 1e-15);
}

TEST(ReadCenterline, RefusesWhatIsNoCenterline)
{
    expect_refused(scratch("missing.vtp"), "no such file");
    expect_refused(scratch("missing.vtp").parent_path(), "not a file");
    expect_refused(written("line.txt", "0 0 0\n"), "ending \".txt\" is not .vtp, .vtk or .csv");
    expect_refused(written("a.vtp", "no XML"), "malformed or truncated");
    expect_refused(written("a.vtk", "no VTK"), "POLYDATA is needed");
    expect_refused(written("none.vtk", points), "holds no line");
    expect_refused(written("short.csv", "0,0,0\n"), "1 points; a line has at least 2");
    expect_refused(written("names.csv", "x,y,w\n0,0,0\n"), "names.csv:1: no column \"z\"");
    expect_refused(written("word.csv", "0,0,0\n1,one,2\n"), "word.csv:2: \"one\" is not a number");
    expect_refused(written("narrow.csv", "0,0,0\n1,2\n"), "narrow.csv:2: 2 columns; column 3");
    expect_refused(written("nan.csv", "0,0,0\n1,nan,0\n"), "point 1 = (1, nan, 0) is not finite");
    expect_refused(written("nan_radius.csv", "0,0,0,1\n1,1,0,nan\n"), "radius at point 1");
    expect_refused(written("one.csv", "0,0,0\n1,1,1\n"), "line 1 is wanted", 1);
}

TEST(ReadCenterline, RefusesTruncatedFiles)
{
    write_centerline(scratch("whole.vtp"), example(), mm);
    std::ifstream whole(scratch("whole.vtp"), std::ios::binary);
    const std::string text((std::istreambuf_iterator<char>(whole)),
                           std::istreambuf_iterator<char>());
    expect_refused(written("half.vtp", text.substr(0, text.size() / 2)), "malformed or truncated");
    expect_refused(written("half.vtk", points.substr(0, points.size() - 20)),
                   "malformed or truncated");
}

}  // namespace
}  // namespace braidzone
