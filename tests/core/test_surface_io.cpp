#include "core/error.hpp"
#include "core/surface_io.hpp"
#include "support/shapes.hpp"
#include "support/temporary_folder.hpp"

#include <gtest/gtest.h>
#include <vtkCell.h>
#include <vtkCellArray.h>
#include <vtkOBJWriter.h>
#include <vtkPLYWriter.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataWriter.h>
#include <vtkSTLReader.h>
#include <vtkSTLWriter.h>
#include <vtkSmartPointer.h>
#include <vtkXMLPolyDataWriter.h>

#include <filesystem>
#include <fstream>
#include <functional>
#include <limits>

namespace braidzone {
namespace {

namespace fs = std::filesystem;
const LengthUnit mm{"mm", 1e-3};

vtkSmartPointer<vtkPolyData> poly_data(const TriangleMesh& mesh, double scale)
{
    const auto points = vtkSmartPointer<vtkPoints>::New();
    points->SetDataTypeToDouble();
    for (const Vec3& p : mesh.points)
        points->InsertNextPoint((scale * p).eval().data());
    const auto polygons = vtkSmartPointer<vtkCellArray>::New();
    for (const auto& [a, b, c] : mesh.triangles)
        polygons->InsertNextCell({a, b, c});
    auto data = vtkSmartPointer<vtkPolyData>::New();
    data->SetPoints(points);
    data->SetPolys(polygons);
    return data;
}

template <typename Writer>
void write_with(const fs::path& path, vtkPolyData* data, const std::function<void(Writer&)>& set)
{
    const auto writer = vtkSmartPointer<Writer>::New();
    writer->SetFileName(path.c_str());
    writer->SetInputData(data);
    set(*writer);
    ASSERT_EQ(writer->Write(), 1) << path;
}

/// A file format and form, written by VTK.
struct Format {
    std::string name;
    std::string ending;
    std::function<void(const fs::path&, vtkPolyData*)> write;
};

std::ostream& operator<<(std::ostream& out, const Format& format)
{
    return out << format.name;
}

std::vector<Format> formats()
{
    return {
        {"stl_ascii", ".stl",
         [](const fs::path& path, vtkPolyData* data) {
             write_with<vtkSTLWriter>(path, data, [](auto& w) { w.SetFileTypeToASCII(); });
         }},
        {"stl_binary", ".STL",
         [](const fs::path& path, vtkPolyData* data) {
             write_with<vtkSTLWriter>(path, data, [](auto& w) { w.SetFileTypeToBinary(); });
         }},
        {"vtp_ascii", ".vtp",
         [](const fs::path& path, vtkPolyData* data) {
             write_with<vtkXMLPolyDataWriter>(path, data, [](auto& w) { w.SetDataModeToAscii(); });
         }},
        {"vtp_appended", ".vtp",
         [](const fs::path& path, vtkPolyData* data) {
             write_with<vtkXMLPolyDataWriter>(path, data,
                                              [](auto& w) { w.SetDataModeToAppended(); });
         }},
        {"vtk_ascii", ".vtk",
         [](const fs::path& path, vtkPolyData* data) {
             write_with<vtkPolyDataWriter>(path, data, [](auto& w) { w.SetFileTypeToASCII(); });
         }},
        {"vtk_binary", ".vtk",
         [](const fs::path& path, vtkPolyData* data) {
             write_with<vtkPolyDataWriter>(path, data, [](auto& w) { w.SetFileTypeToBinary(); });
         }},
        {"ply_ascii", ".ply",
         [](const fs::path& path, vtkPolyData* data) {
             write_with<vtkPLYWriter>(path, data, [](auto& w) { w.SetFileTypeToASCII(); });
         }},
        {"ply_binary", ".ply",
         [](const fs::path& path, vtkPolyData* data) {
             write_with<vtkPLYWriter>(path, data, [](auto& w) { w.SetFileTypeToBinary(); });
         }},
        {"obj", ".obj",
         [](const fs::path& path, vtkPolyData* data) {
             write_with<vtkOBJWriter>(path, data, [](auto&) {});
         }},
    };
}

class ReadSurfaceOf : public testing::TestWithParam<Format> {
protected:
    fs::path written(const TriangleMesh& mesh, double scale)
    {
        const fs::path path = folder_.path() / ("surface" + GetParam().ending);
        GetParam().write(path, poly_data(mesh, scale));
        return path;
    }
    test::TemporaryFolder folder_;
};

INSTANTIATE_TEST_SUITE_P(EachFormat, ReadSurfaceOf, testing::ValuesIn(formats()),
                         [](const auto& test) { return test.param.name; });

void expect_same_triangles(const TriangleMesh& found, const TriangleMesh& expected,
                           double tolerance)
{
    ASSERT_EQ(found.triangles.size(), expected.triangles.size());
    for (std::size_t triangle = 0; triangle < found.triangles.size(); ++triangle) {
        for (std::size_t k = 0; k < 3; ++k) {
            const auto a = static_cast<std::size_t>(found.triangles[triangle][k]);
            const auto b = static_cast<std::size_t>(expected.triangles[triangle][k]);
            EXPECT_LT((found.points[a] - expected.points[b]).norm(), tolerance);
        }
    }
}

TEST_P(ReadSurfaceOf, GivesTheTrianglesInMetres)
{
    const TriangleMesh tube = test::tube(2e-3, 10e-3, 12, 5);
    const TriangleMesh found = read_surface(written(tube, 1e3), mm);
    EXPECT_EQ(found.points.size(), tube.points.size());  // coincident points are one
    // ASCII STL has six digits.
    expect_same_triangles(found, tube, 1e-5 * 10e-3);
}

// The message names the file, and VTK and CGAL print nothing of their own.
void expect_refused(const fs::path& path)
{
    testing::internal::CaptureStderr();
    try {
        read_surface(path, mm);
        ADD_FAILURE() << "the file was accepted";
    } catch (const Error& error) {
        EXPECT_NE(std::string(error.what()).find(path.string()), std::string::npos) << error.what();
    }
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

TEST_P(ReadSurfaceOf, RefusesATruncatedFile)
{
    const fs::path path = written(test::tube(2e-3, 10e-3, 12, 5), 1e3);
    // An OBJ has no counts: what is left after a cut may be a smaller surface.
    const bool tells_its_length = GetParam().ending != ".obj";
    const auto size = fs::file_size(path);
    for (const double share : {0.99, 0.95, 0.6, 0.3, 0.02}) {
        if (share > 0.3 && !tells_its_length) continue;
        SCOPED_TRACE(share);
        fs::resize_file(path, static_cast<std::uintmax_t>(share * static_cast<double>(size)));
        expect_refused(path);
    }
}

TEST_P(ReadSurfaceOf, RefusesAFileOfSomethingElse)
{
    for (const std::string& content :
         {std::string("not a surface at all\n"), std::string(200, '\0'), std::string()}) {
        expect_refused(folder_.write("other" + GetParam().ending, content));
    }
}

TEST_P(ReadSurfaceOf, RefusesCoordinatesThatAreNotFinite)
{
    TriangleMesh tube = test::tube(2e-3, 10e-3, 12, 5);
    tube.points[3].y() = std::numeric_limits<double>::quiet_NaN();
    expect_refused(written(tube, 1e3));
}

std::string message_of(const fs::path& path)
{
    try {
        read_surface(path, mm);
    } catch (const Error& error) {
        return error.what();
    }
    return "";
}

TEST(ReadSurface, NamesThePointThatIsNotFinite)
{
    const test::TemporaryFolder folder;
    const fs::path path = folder.write("nan.stl",
                                       "solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\n"
                                       "vertex 1 0 0\nvertex 0 nan 0\nendloop\nendfacet\n"
                                       "endsolid\n");
    EXPECT_THROW(read_surface(path, mm), InputError);
    EXPECT_EQ(message_of(path), path.string() + ": point 2 = (0, nan, 0) is not finite");
}

TEST(ReadSurface, SaysThatAFileIsMissing)
{
    const fs::path path = "/nonexistent/vessel.stl";
    EXPECT_THROW(read_surface(path, mm), IoError);
    EXPECT_EQ(message_of(path), "/nonexistent/vessel.stl: no such file");
}

TEST(ReadSurface, RefusesAFolder)
{
    const test::TemporaryFolder folder;
    EXPECT_THROW(read_surface(folder.path(), mm), IoError);
}

TEST(ReadSurface, RefusesAnotherEnding)
{
    const test::TemporaryFolder folder;
    const fs::path path = folder.write("vessel.step", "ISO-10303-21;");
    EXPECT_THROW(read_surface(path, mm), InputError);
    EXPECT_EQ(message_of(path),
              path.string() + ": ending \".step\" is not .stl, .vtp, .vtu, .vtk, .ply or .obj");
}

TEST(ReadSurface, RefusesASurfaceWithoutTriangles)
{
    const test::TemporaryFolder folder;
    const fs::path path = folder.write("empty.stl", "solid empty\nendsolid empty\n");
    EXPECT_THROW(read_surface(path, mm), Error);
    const fs::path binary = folder.path() / "binary.stl";
    write_stl(binary, TriangleMesh{}, mm);
    EXPECT_THROW(read_surface(binary, mm), InputError);
    EXPECT_EQ(message_of(binary), binary.string() + ": the surface has no triangles");
}

// Two tetrahedra over the corner of the unit cube share a face: six faces, a volume of 2/6.
TEST(ReadSurface, TakesTheBoundaryOfVolumeElements)
{
    const test::TemporaryFolder folder;
    const fs::path path = folder.write(
        "grid.vtk",
        "# vtk DataFile Version 3.0\ngrid\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 5 float\n"
        "0 0 0 1 0 0 0 1 0 0 0 1 0 0 -1\nCELLS 2 10\n4 0 1 2 3\n4 0 2 1 4\nCELL_TYPES 2\n10\n10\n");
    const LabelledSurface surface = read_labelled_surface(path, LengthUnit{"m", 1.0});
    EXPECT_EQ(surface.mesh.triangles.size(), 6u);
    EXPECT_NEAR(std::abs(enclosed_volume(surface.mesh)), 2.0 / 6.0, 1e-6);
    EXPECT_EQ(surface.notes, std::vector<std::string>{"took the boundary of 2 volume elements"});
}

TEST(ReadSurface, RefusesALegacyFileOfAnotherDataSet)
{
    const test::TemporaryFolder folder;
    const fs::path path = folder.write(
        "grid.vtk",
        "# vtk DataFile Version 3.0\ngrid\nASCII\nDATASET STRUCTURED_POINTS\nDIMENSIONS 1 1 1\n"
        "ORIGIN 0 0 0\nSPACING 1 1 1\n");
    EXPECT_THROW(read_surface(path, mm), InputError);
    EXPECT_NE(message_of(path).find("DATASET POLYDATA or UNSTRUCTURED_GRID is needed"),
              std::string::npos);
}

TEST(ReadSurface, RefusesAReferenceToAPointThatIsNotThere)
{
    const test::TemporaryFolder folder;
    const fs::path path = folder.write("far.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 4\n");
    EXPECT_THROW(read_surface(path, mm), InputError);
    EXPECT_EQ(message_of(path), path.string() + ": polygon 0 refers to point 3, but there are 3");
}

TEST(ReadSurface, RefusesAPolygonOfTwoCorners)
{
    const test::TemporaryFolder folder;
    const fs::path path = folder.write("cut.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 1 2\n");
    EXPECT_THROW(read_surface(path, mm), InputError);
    EXPECT_EQ(message_of(path), path.string() + ": polygon 1 has 2 corners, at least 3 are needed");
}

// VTK's legacy reader would end the program here: it reads on from a file that it has closed.
TEST(ReadSurface, RefusesALegacyFileThatGoesWrongInTheMiddle)
{
    const test::TemporaryFolder folder;
    expect_refused(folder.write("bad.vtk",
                                "# vtk DataFile Version 3.0\nbad\nASCII\nDATASET POLYDATA\n"
                                "POINTS 4 double\n0 0 0 1 0 0 0 1 0 1 1 0\n"
                                "POLYGONS 2 8\n3 0 1 2\n3 1x3 2\n"));
}

// CGAL's PLY reader would end the program here.
TEST(ReadSurface, RefusesAPlyWhosePropertiesBelongToNothing)
{
    const test::TemporaryFolder folder;
    const fs::path path = folder.write("bad.ply", "ply\nformat ascii 1.0\nproperty float x\n");
    expect_refused(path);
    EXPECT_EQ(message_of(path), path.string() +
                                    ": malformed PLY: unexpected line \"property "
                                    "float x\" in the header");
}

TEST(ReadSurface, TakesABinaryStlWhoseHeaderBeginsWithSolid)
{
    const test::TemporaryFolder folder;
    const fs::path path = folder.path() / "solid.stl";
    const TriangleMesh tube = test::tube(2e-3, 10e-3, 12, 5);
    write_stl(path, tube, mm);
    std::fstream file(path, std::ios::in | std::ios::out | std::ios::binary);
    file << "solid written by another program";
    file.close();
    expect_same_triangles(read_surface(path, mm), tube, 1e-6 * 10e-3);
}

// An L of area 3 with its reflex corner at (1, 1): a fan about the first corner would leave it.
TEST(ReadSurface, TriangulatesAPolygonThatIsNotConvex)
{
    const test::TemporaryFolder folder;
    const fs::path path = folder.write(
        "l.obj", "v 2 0 0\nv 2 1 0\nv 1 1 0\nv 1 2 0\nv 0 2 0\nv 0 0 0\nf 1 2 3 4 5 6\n");
    const TriangleMesh mesh = read_surface(path, LengthUnit{"m", 1.0});
    ASSERT_EQ(mesh.triangles.size(), 4u);
    double area = 0.0;
    for (int triangle = 0; triangle < 4; ++triangle)
        area += area_vector(mesh, triangle).z();
    EXPECT_NEAR(area, 3.0, 1e-14);
    EXPECT_NEAR(surface_area(mesh), 3.0, 1e-14);  // no triangle is turned
}

// A strip of four points is two triangles of the same sense.
TEST(ReadSurface, TakesTriangleStrips)
{
    const test::TemporaryFolder folder;
    const fs::path path =
        folder.write("strip.vtk",
                     "# vtk DataFile Version 3.0\nstrip\nASCII\nDATASET POLYDATA\n"
                     "POINTS 4 double\n0 0 0 1 0 0 0 1 0 1 1 0\nTRIANGLE_STRIPS 1 5\n4 0 1 2 3\n");
    const TriangleMesh mesh = read_surface(path, LengthUnit{"m", 1.0});
    ASSERT_EQ(mesh.triangles.size(), 2u);
    EXPECT_EQ(area_vector(mesh, 0), Vec3(0, 0, 0.5));
    EXPECT_EQ(area_vector(mesh, 1), Vec3(0, 0, 0.5));
}

TEST(ReadSurface, LeavesOutPointsThatNoTriangleUses)
{
    const test::TemporaryFolder folder;
    const fs::path path =
        folder.write("loose.obj", "v 0 0 0\nv 9 9 9\nv 1 0 0\nv 0 1 0\nf 1 3 4\n");
    const TriangleMesh mesh = read_surface(path, LengthUnit{"cm", 1e-2});
    ASSERT_EQ(mesh.points.size(), 3u);
    EXPECT_EQ(mesh.points[1], Vec3(1e-2, 0, 0));
}

TEST(WriteStl, IsReadByVtkInTheGivenUnit)
{
    const test::TemporaryFolder folder;
    const fs::path path = folder.path() / "tube.stl";
    const TriangleMesh tube = test::tube(2e-3, 10e-3, 12, 5);
    write_stl(path, tube, mm);

    const auto reader = vtkSmartPointer<vtkSTLReader>::New();
    reader->SetFileName(path.c_str());
    reader->Update();
    vtkPolyData& data = *reader->GetOutput();
    ASSERT_EQ(data.GetNumberOfCells(), static_cast<vtkIdType>(tube.triangles.size()));
    ASSERT_EQ(data.GetNumberOfPoints(), static_cast<vtkIdType>(tube.points.size()));
    for (vtkIdType cell = 0; cell < data.GetNumberOfCells(); ++cell) {
        for (int k = 0; k < 3; ++k) {
            const Vec3 found(data.GetPoint(data.GetCell(cell)->GetPointId(k)));
            const auto corner =
                tube.triangles[static_cast<std::size_t>(cell)][static_cast<std::size_t>(k)];
            const Vec3 expected = 1e3 * tube.points[static_cast<std::size_t>(corner)];
            EXPECT_LT((found - expected).norm(), 1e-6 * 10.0);  // single precision
        }
    }
}

TEST(WriteStl, RefusesAPlaceThatCannotBeWritten)
{
    EXPECT_THROW(write_stl("/nonexistent/tube.stl", test::tube(2e-3, 10e-3, 12, 5), mm), IoError);
}

}  // namespace
}  // namespace braidzone
