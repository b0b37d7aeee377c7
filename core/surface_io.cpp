#include "core/surface_io.hpp"

#include "core/error.hpp"
#include "core/ply_header.hpp"
#include "core/vtk_messages.hpp"

#include <CGAL/IO/OBJ.h>
#include <CGAL/IO/PLY.h>
#include <CGAL/Simple_cartesian.h>
#include <fmt/format.h>
#include <vtkCellArray.h>
#include <vtkCellArrayIterator.h>
#include <vtkIdList.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataReader.h>
#include <vtkPolygon.h>
#include <vtkSTLReader.h>
#include <vtkSmartPointer.h>
#include <vtkTriangleStrip.h>
#include <vtkXMLPolyDataReader.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cctype>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <new>
#include <numeric>
#include <stdexcept>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

namespace braidzone {

namespace {

namespace fs = std::filesystem;

constexpr std::uintmax_t stl_header_size = 84;    // 80 bytes of text, a 32-bit triangle count
constexpr std::uintmax_t stl_triangle_size = 50;  // 12 floats, a 16-bit attribute
static_assert(std::endian::native == std::endian::little, "binary STL is little-endian");

/// What a file holds, in its unit: polygons with any number of corners.
struct PolygonSoup {
    std::vector<Vec3> points;
    std::vector<std::vector<int>> polygons;
};

std::string lower_case(std::string text)
{
    std::transform(text.begin(), text.end(), text.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return text;
}

std::ifstream opened(const fs::path& path)
{
    std::error_code error;
    if (!fs::exists(path, error)) throw IoError(fmt::format("{}: no such file", path.string()));
    if (!fs::is_regular_file(path, error)) {
        throw IoError(fmt::format("{}: not a file", path.string()));
    }
    std::ifstream file(path, std::ios::binary);
    if (!file) throw IoError(fmt::format("{}: cannot be opened for reading", path.string()));
    return file;
}

/// The polygons and strips of a VTK surface.
PolygonSoup polygons_of(vtkPolyData& data)
{
    PolygonSoup soup;
    for (vtkIdType point = 0; point < data.GetNumberOfPoints(); ++point) {
        soup.points.emplace_back(data.GetPoint(point));
    }
    const auto corners = vtkSmartPointer<vtkIdList>::New();
    const auto for_each_cell = [&](vtkCellArray& cells, auto visit) {
        const auto cell = vtk::TakeSmartPointer(cells.NewIterator());
        for (cell->GoToFirstCell(); !cell->IsDoneWithTraversal(); cell->GoToNextCell()) {
            cell->GetCurrentCell(corners);
            visit();
        }
    };
    const auto append_polygon = [&] {
        soup.polygons.emplace_back(corners->begin(), corners->end());
    };
    const auto strip_triangles = vtkSmartPointer<vtkCellArray>::New();
    for_each_cell(*data.GetPolys(), append_polygon);
    for_each_cell(*data.GetStrips(), [&] {
        vtkTriangleStrip::DecomposeStrip(static_cast<int>(corners->GetNumberOfIds()),
                                         corners->GetPointer(0), strip_triangles);
    });
    for_each_cell(*strip_triangles, append_polygon);
    return soup;
}

/// Runs one of VTK's readers; whatever it complains about is an error of ours.
template <typename Reader>
PolygonSoup read_by_vtk(Reader& reader, const fs::path& path)
{
    const std::string failure = fmt::format("{}: malformed or truncated", path.string());
    const VtkMessages messages(failure);
    reader.SetFileName(path.c_str());
    reader.Update();
    if (reader.GetErrorCode() != 0 || reader.GetOutput() == nullptr) throw IoError(failure);
    return polygons_of(*reader.GetOutput());
}

/// Runs one of CGAL's readers. For PLY and OBJ they are preferred to VTK's, which end the program
/// on a truncated PLY and take a coordinate that they cannot read for zero in an OBJ.
template <typename Reader>
PolygonSoup read_by_cgal(Reader read, const fs::path& path)
{
    std::ifstream file = opened(path);
    std::vector<CGAL::Simple_cartesian<double>::Point_3> points;
    PolygonSoup soup;
    bool succeeded = false;
    try {
        succeeded = read(file, points, soup.polygons);
    } catch (const std::length_error&) {  // a count out of all proportion
    } catch (const std::bad_alloc&) {
    }
    if (!succeeded) throw IoError(fmt::format("{}: malformed or truncated", path.string()));
    for (const auto& point : points)
        soup.points.emplace_back(point.x(), point.y(), point.z());
    return soup;
}

PolygonSoup read_ply(const fs::path& path)
{
    std::ifstream file = opened(path);
    const std::string fault = ply_header_fault(file);
    if (!fault.empty()) throw IoError(fmt::format("{}: malformed PLY: {}", path.string(), fault));
    const auto silent = CGAL::parameters::verbose(false);
    return read_by_cgal([&](auto&... to) { return CGAL::IO::read_PLY(to..., silent); }, path);
}

PolygonSoup read_obj(const fs::path& path)
{
    const auto silent = CGAL::parameters::verbose(false);
    return read_by_cgal([&](auto&... to) { return CGAL::IO::read_OBJ(to..., silent); }, path);
}

PolygonSoup read_binary_stl(std::ifstream& file, std::uint32_t num_triangles)
{
    PolygonSoup soup;
    file.seekg(stl_header_size);
    std::array<char, stl_triangle_size> record;
    for (std::uint32_t triangle = 0; triangle < num_triangles; ++triangle) {
        file.read(record.data(), record.size());
        std::array<float, 12> values;  // normal, then three corners
        std::memcpy(values.data(), record.data(), sizeof(values));
        const int first = static_cast<int>(soup.points.size());
        for (std::size_t k = 3; k < values.size(); k += 3) {
            soup.points.push_back(
                Eigen::Vector3f(values[k], values[k + 1], values[k + 2]).cast<double>());
        }
        soup.polygons.push_back({first, first + 1, first + 2});
    }
    return soup;
}

/// True if the last line of the file that holds anything begins with "endsolid".
bool ends_as_ascii_stl(std::ifstream& file)
{
    file.clear();
    file.seekg(0);
    std::string line, last_word;
    while (std::getline(file, line)) {
        std::string word = line.substr(std::min(line.find_first_not_of(" \t\r"), line.size()));
        word = word.substr(0, word.find_first_of(" \t\r"));
        if (!word.empty()) last_word = word;
    }
    return lower_case(last_word) == "endsolid";
}

/// An STL file is binary if its size is what its triangle count says: the header's text is free,
/// and some programs begin it with the "solid" of the ASCII form.
PolygonSoup read_stl(const fs::path& path)
{
    std::ifstream file = opened(path);
    const std::uintmax_t size = fs::file_size(path);
    std::array<char, stl_header_size> header{};
    file.read(header.data(), header.size());
    std::uint32_t num_triangles = 0;
    std::memcpy(&num_triangles, header.data() + 80, sizeof(num_triangles));
    const std::uintmax_t expected_size = stl_header_size + stl_triangle_size * num_triangles;
    if (size >= stl_header_size && size == expected_size) {
        return read_binary_stl(file, num_triangles);
    }

    const std::string_view text(header.data(), std::min(size, stl_header_size));
    if (text.find('\0') != std::string_view::npos) {
        throw IoError(fmt::format(
            "{}: truncated or damaged: {} bytes, but a binary STL of {} triangles has {}",
            path.string(), size, num_triangles, expected_size));
    }
    if (lower_case(std::string(text.substr(0, 5))) != "solid") {
        throw IoError(fmt::format("{}: neither a binary nor an ASCII STL", path.string()));
    }
    if (!ends_as_ascii_stl(file)) {
        throw IoError(fmt::format("{}: truncated: ASCII STL without \"endsolid\"", path.string()));
    }
    const auto reader = vtkSmartPointer<vtkSTLReader>::New();
    reader->MergingOff();  // merged below, for all formats alike
    return read_by_vtk(*reader, path);
}

PolygonSoup read_legacy_vtk(const fs::path& path)
{
    const auto reader = vtkSmartPointer<vtkPolyDataReader>::New();
    reader->SetFileName(path.c_str());
    {
        const VtkMessages messages;
        if (!reader->IsFilePolyData()) {
            throw InputError(fmt::format("{}: a legacy VTK file of DATASET POLYDATA is needed{}{}",
                                         path.string(), messages.any() ? ": " : "",
                                         messages.first()));
        }
    }
    return read_by_vtk(*reader, path);
}

PolygonSoup read_polygons(const fs::path& path)
{
    const std::string ending = lower_case(path.extension().string());
    if (ending == ".stl") return read_stl(path);
    if (ending == ".vtk") return read_legacy_vtk(path);
    if (ending == ".vtp") {
        return read_by_vtk(*vtkSmartPointer<vtkXMLPolyDataReader>::New(), path);
    }
    if (ending == ".ply") return read_ply(path);
    if (ending == ".obj") return read_obj(path);
    throw InputError(fmt::format("{}: ending \"{}\" is not .stl, .vtp, .vtk, .ply or .obj",
                                 path.string(), ending));
}

void require_finite(const std::vector<Vec3>& points, const fs::path& path)
{
    for (std::size_t index = 0; index < points.size(); ++index) {
        const Vec3& point = points[index];
        if (point.allFinite()) continue;
        throw InputError(fmt::format("{}: point {} = ({:.6g}, {:.6g}, {:.6g}) is not finite",
                                     path.string(), index, point.x(), point.y(), point.z()));
    }
}

void require_valid_corners(const PolygonSoup& soup, const fs::path& path)
{
    const int num_points = static_cast<int>(soup.points.size());
    for (std::size_t index = 0; index < soup.polygons.size(); ++index) {
        if (soup.polygons[index].size() < 3) {
            throw InputError(fmt::format("{}: polygon {} has {} corners, at least 3 are needed",
                                         path.string(), index, soup.polygons[index].size()));
        }
        for (const int corner : soup.polygons[index]) {
            if (corner >= 0 && corner < num_points) continue;
            throw InputError(fmt::format("{}: polygon {} refers to point {}, but there are {}",
                                         path.string(), index, corner, num_points));
        }
    }
}

/// Triangles instead of polygons: ears are cut off, so a polygon need not be convex.
TriangleMesh triangulated(const PolygonSoup& soup, const fs::path& path)
{
    TriangleMesh mesh;
    mesh.points = soup.points;
    const auto polygon = vtkSmartPointer<vtkPolygon>::New();
    const auto ears = vtkSmartPointer<vtkIdList>::New();  // three indices into the polygon each
    const VtkMessages messages;
    for (std::size_t index = 0; index < soup.polygons.size(); ++index) {
        const std::vector<int>& corners = soup.polygons[index];
        if (corners.size() == 3) {
            mesh.triangles.push_back({corners[0], corners[1], corners[2]});
            continue;
        }
        polygon->Points->Reset();
        polygon->PointIds->Reset();
        for (std::size_t k = 0; k < corners.size(); ++k) {
            polygon->Points->InsertNextPoint(
                soup.points[static_cast<std::size_t>(corners[k])].data());
            polygon->PointIds->InsertNextId(static_cast<vtkIdType>(k));
        }
        if (polygon->Triangulate(ears) == 0) {
            throw InputError(fmt::format("{}: polygon {} ({} corners) cannot be triangulated",
                                         path.string(), index, corners.size()));
        }
        const auto corner = [&](vtkIdType k) {
            return corners[static_cast<std::size_t>(ears->GetId(k))];
        };
        for (vtkIdType k = 0; k + 2 < ears->GetNumberOfIds(); k += 3) {
            mesh.triangles.push_back({corner(k), corner(k + 1), corner(k + 2)});
        }
    }
    return mesh;
}

/// The mesh with equal points made one, numbered in the order in which triangles first use them;
/// points that no triangle uses are left out.
TriangleMesh merged(const TriangleMesh& mesh)
{
    const auto key = [&](int index) {
        const Vec3& point = mesh.points[static_cast<std::size_t>(index)];
        return std::tuple(point.x(), point.y(), point.z());
    };
    std::vector<int> order(mesh.points.size());
    std::iota(order.begin(), order.end(), 0);
    std::sort(order.begin(), order.end(), [&](int a, int b) { return key(a) < key(b); });
    std::vector<std::size_t> group_of(mesh.points.size(), 0);  // points of one place are a group
    std::size_t num_groups = 0;
    for (std::size_t k = 0; k < order.size(); ++k) {
        if (k == 0 || key(order[k - 1]) != key(order[k])) ++num_groups;
        group_of[static_cast<std::size_t>(order[k])] = num_groups - 1;
    }

    TriangleMesh result;
    constexpr int unused = -1;
    std::vector<int> new_index(num_groups, unused);
    for (std::array<int, 3> corners : mesh.triangles) {
        for (int& corner : corners) {
            const auto old = static_cast<std::size_t>(corner);
            int& index = new_index[group_of[old]];
            if (index == unused) {
                index = static_cast<int>(result.points.size());
                result.points.push_back(mesh.points[old]);
            }
            corner = index;
        }
        result.triangles.push_back(corners);
    }
    return result;
}

}  // namespace

TriangleMesh read_surface(const fs::path& path, const LengthUnit& unit)
{
    opened(path);
    const PolygonSoup soup = read_polygons(path);
    if (soup.polygons.empty()) {
        throw InputError(fmt::format("{}: the surface has no triangles", path.string()));
    }
    require_finite(soup.points, path);
    require_valid_corners(soup, path);
    TriangleMesh mesh = merged(triangulated(soup, path));
    for (Vec3& point : mesh.points)
        point *= unit.metres;
    return mesh;
}

void write_stl(const fs::path& path, const TriangleMesh& mesh, const LengthUnit& unit)
{
    std::ofstream file(path, std::ios::binary);
    std::array<char, 80> header{};
    const std::string text = fmt::format("Braidzone surface, coordinates in {}", unit.name);
    std::copy_n(text.begin(), std::min(text.size(), header.size()), header.begin());
    const auto num_triangles = static_cast<std::uint32_t>(mesh.triangles.size());
    file.write(header.data(), header.size());
    file.write(reinterpret_cast<const char*>(&num_triangles), sizeof(num_triangles));
    for (std::size_t triangle = 0; triangle < mesh.triangles.size(); ++triangle) {
        std::array<Eigen::Vector3f, 4> vectors;  // normal, then three corners
        vectors[0] = area_vector(mesh, static_cast<int>(triangle)).normalized().cast<float>();
        for (std::size_t k = 0; k < 3; ++k) {
            const auto point = static_cast<std::size_t>(mesh.triangles[triangle][k]);
            vectors[k + 1] = (mesh.points[point] / unit.metres).cast<float>();
        }
        std::array<char, stl_triangle_size> record{};
        static_assert(sizeof(vectors) == 48);
        std::memcpy(record.data(), vectors.data(), sizeof(vectors));
        file.write(record.data(), record.size());
    }
    file.close();
    if (!file) throw IoError(fmt::format("{}: cannot be written", path.string()));
}

}  // namespace braidzone
