#include "core/surface_io.hpp"

#include "core/error.hpp"
#include "core/ply_header.hpp"
#include "core/vtk_messages.hpp"

#include <CGAL/IO/OBJ.h>
#include <CGAL/IO/PLY.h>
#include <CGAL/Simple_cartesian.h>
#include <fmt/format.h>
#include <vtkCell.h>
#include <vtkCellArray.h>
#include <vtkCellArrayIterator.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkIdList.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataReader.h>
#include <vtkPolygon.h>
#include <vtkSTLReader.h>
#include <vtkSmartPointer.h>
#include <vtkUnstructuredGrid.h>
#include <vtkUnstructuredGridReader.h>
#include <vtkXMLPolyDataReader.h>
#include <vtkXMLUnstructuredGridReader.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cctype>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <functional>
#include <map>
#include <new>
#include <numeric>
#include <stdexcept>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>
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
    std::vector<int> labels;         ///< one a polygon, or none
    std::string label_name;          ///< what the file calls them
    std::vector<std::string> notes;  ///< what reading changed
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

/// The integers of the first cell array that tells regions apart; empty if there is none.
std::vector<int> cell_labels(vtkDataSet& data, std::string& name)
{
    // An ASCII STL's solids come as VTK's STLSolidLabeling.
    for (const char* known : {"CellEntityIds", "ModelFaceID", "CapID", "STLSolidLabeling"}) {
        vtkDataArray* array = data.GetCellData()->GetArray(known);
        if (array == nullptr || array->GetNumberOfComponents() != 1 ||
            array->GetNumberOfTuples() != data.GetNumberOfCells())
            continue;
        std::vector<int> labels;
        for (vtkIdType cell = 0; cell < array->GetNumberOfTuples(); ++cell)
            labels.push_back(static_cast<int>(std::lround(array->GetTuple1(cell))));
        const bool differ =
            std::adjacent_find(labels.begin(), labels.end(), std::not_equal_to<>()) != labels.end();
        if (!differ) continue;
        name = known == std::string("STLSolidLabeling") ? "solid" : known;
        return labels;
    }
    return {};
}

void append_points(PolygonSoup& soup, vtkPointSet& data)
{
    for (vtkIdType point = 0; point < data.GetNumberOfPoints(); ++point)
        soup.points.emplace_back(data.GetPoint(point));
}

/// The polygons and strips of a VTK surface. Cells are numbered vertices, lines, polygons, strips.
PolygonSoup polygons_of(vtkPolyData& data)
{
    PolygonSoup soup;
    append_points(soup, data);
    const std::vector<int> labels = cell_labels(data, soup.label_name);
    std::size_t number =
        static_cast<std::size_t>(data.GetNumberOfVerts() + data.GetNumberOfLines());
    const auto append = [&](const vtkIdType* first, const vtkIdType* last) {
        soup.polygons.emplace_back(first, last);
        if (!labels.empty()) soup.labels.push_back(labels[number]);
    };
    const auto corners = vtkSmartPointer<vtkIdList>::New();
    const auto for_each_cell = [&](vtkCellArray& cells, auto visit) {
        const auto cell = vtk::TakeSmartPointer(cells.NewIterator());
        for (cell->GoToFirstCell(); !cell->IsDoneWithTraversal(); cell->GoToNextCell()) {
            cell->GetCurrentCell(corners);
            visit();
            ++number;
        }
    };
    for_each_cell(*data.GetPolys(), [&] { append(corners->begin(), corners->end()); });
    for_each_cell(*data.GetStrips(), [&] {
        // Every other triangle of a strip runs the other way.
        for (vtkIdType k = 0; k + 2 < corners->GetNumberOfIds(); ++k) {
            const vtkIdType odd = k % 2;
            const std::array<vtkIdType, 3> triangle = {
                corners->GetId(k + odd), corners->GetId(k + 1 - odd), corners->GetId(k + 2)};
            append(triangle.data(), triangle.data() + 3);
        }
    });
    if (data.GetNumberOfStrips() > 0) {
        soup.notes.push_back(
            fmt::format("took {} triangle strips apart", data.GetNumberOfStrips()));
    }
    return soup;
}

/// The corners of a face, without the middles of its sides.
std::vector<int> corners_of(vtkCell& face)
{
    std::vector<int> corners;
    for (int k = 0; k < face.GetNumberOfEdges(); ++k)
        corners.push_back(static_cast<int>(face.GetPointId(k)));
    return corners;
}

/// The faces of volume elements that belong to one element only.
std::vector<std::vector<int>> boundary_faces(vtkUnstructuredGrid& data)
{
    std::map<std::vector<int>, std::pair<int, std::vector<int>>> faces;  // by sorted corners
    for (vtkIdType cell = 0; cell < data.GetNumberOfCells(); ++cell) {
        vtkCell* element = data.GetCell(cell);
        if (element->GetCellDimension() != 3) continue;
        for (int k = 0; k < element->GetNumberOfFaces(); ++k) {
            std::vector<int> corners = corners_of(*element->GetFace(k));
            std::vector<int> key = corners;
            std::sort(key.begin(), key.end());
            auto& [count, face] = faces[std::move(key)];
            if (++count == 1) face = std::move(corners);
        }
    }
    std::vector<std::vector<int>> boundary;
    for (auto& [key, entry] : faces) {
        if (entry.first == 1) boundary.push_back(std::move(entry.second));
    }
    return boundary;
}

/// The surface elements of a VTK grid or, without any, the boundary of its volume elements.
PolygonSoup polygons_of(vtkUnstructuredGrid& data)
{
    PolygonSoup soup;
    append_points(soup, data);
    const std::vector<int> labels = cell_labels(data, soup.label_name);
    vtkIdType num_volumes = 0;
    for (vtkIdType number = 0; number < data.GetNumberOfCells(); ++number) {
        vtkCell* cell = data.GetCell(number);
        if (cell->GetCellDimension() == 3) ++num_volumes;
        if (cell->GetCellDimension() != 2) continue;
        if (cell->GetCellType() == VTK_TRIANGLE_STRIP || cell->GetCellType() == VTK_PIXEL)
            continue;  // no writer of meshes uses them
        soup.polygons.push_back(corners_of(*cell));
        if (!labels.empty()) soup.labels.push_back(labels[static_cast<std::size_t>(number)]);
    }
    if (soup.polygons.empty() && num_volumes > 0) {
        soup.polygons = boundary_faces(data);
        soup.notes.push_back(fmt::format("took the boundary of {} volume elements", num_volumes));
    } else if (num_volumes > 0) {
        soup.notes.push_back(fmt::format("took the {} surface elements beside {} volume elements",
                                         soup.polygons.size(), num_volumes));
    }
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
    reader->MergingOff();    // merged below, for all formats alike
    reader->ScalarTagsOn();  // several solids
    return read_by_vtk(*reader, path);
}

PolygonSoup read_legacy_vtk(const fs::path& path)
{
    const auto reader = vtkSmartPointer<vtkPolyDataReader>::New();
    reader->SetFileName(path.c_str());
    {
        const VtkMessages messages;
        const auto grid_reader = vtkSmartPointer<vtkUnstructuredGridReader>::New();
        grid_reader->SetFileName(path.c_str());
        grid_reader->ReadAllScalarsOn();
        grid_reader->ReadAllFieldsOn();
        if (grid_reader->IsFileUnstructuredGrid()) return read_by_vtk(*grid_reader, path);
        if (!reader->IsFilePolyData()) {
            throw InputError(fmt::format(
                "{}: a legacy VTK file of DATASET POLYDATA or UNSTRUCTURED_GRID is needed{}{}",
                path.string(), messages.any() ? ": " : "", messages.first()));
        }
    }
    reader->ReadAllScalarsOn();
    reader->ReadAllFieldsOn();
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
    if (ending == ".vtu") {
        return read_by_vtk(*vtkSmartPointer<vtkXMLUnstructuredGridReader>::New(), path);
    }
    if (ending == ".ply") return read_ply(path);
    if (ending == ".obj") return read_obj(path);
    throw InputError(fmt::format("{}: ending \"{}\" is not .stl, .vtp, .vtu, .vtk, .ply or .obj",
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

/// Cuts the ears off a polygon, which need not be convex.
class PolygonCutter {
public:
    /// Three places in the polygon for each of its triangles; empty if it cannot be triangulated.
    std::vector<std::array<std::size_t, 3>> triangles_of(const std::vector<int>& corners,
                                                         const std::vector<Vec3>& points)
    {
        polygon_->Points->Reset();
        polygon_->PointIds->Reset();
        for (std::size_t k = 0; k < corners.size(); ++k) {
            polygon_->Points->InsertNextPoint(points[static_cast<std::size_t>(corners[k])].data());
            polygon_->PointIds->InsertNextId(static_cast<vtkIdType>(k));
        }
        std::vector<std::array<std::size_t, 3>> triangles;
        if (polygon_->Triangulate(ears_) == 0) return triangles;
        const auto place = [&](vtkIdType k) { return static_cast<std::size_t>(ears_->GetId(k)); };
        for (vtkIdType k = 0; k + 2 < ears_->GetNumberOfIds(); k += 3)
            triangles.push_back({place(k), place(k + 1), place(k + 2)});
        return triangles;
    }

private:
    vtkSmartPointer<vtkPolygon> polygon_ = vtkSmartPointer<vtkPolygon>::New();
    vtkSmartPointer<vtkIdList> ears_ = vtkSmartPointer<vtkIdList>::New();
};

/// Triangles instead of polygons, each with its polygon's label.
LabelledSurface triangulated(const PolygonSoup& soup, const fs::path& path)
{
    LabelledSurface surface{{soup.points, {}}, {}, soup.label_name, soup.notes};
    const auto append = [&](std::size_t polygon, int a, int b, int c) {
        surface.mesh.triangles.push_back({a, b, c});
        if (!soup.labels.empty()) surface.labels.push_back(soup.labels[polygon]);
    };
    PolygonCutter cutter;
    const VtkMessages messages;
    std::size_t num_cut = 0;
    for (std::size_t index = 0; index < soup.polygons.size(); ++index) {
        const std::vector<int>& corners = soup.polygons[index];
        if (corners.size() == 3) {
            append(index, corners[0], corners[1], corners[2]);
            continue;
        }
        const auto triangles = cutter.triangles_of(corners, soup.points);
        if (triangles.empty()) {
            throw InputError(fmt::format("{}: polygon {} ({} corners) cannot be triangulated",
                                         path.string(), index, corners.size()));
        }
        for (const auto& [a, b, c] : triangles)
            append(index, corners[a], corners[b], corners[c]);
        ++num_cut;
    }
    if (num_cut > 0) surface.notes.push_back(fmt::format("triangulated {} polygons", num_cut));
    return surface;
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
    return read_labelled_surface(path, unit).mesh;
}

LabelledSurface read_labelled_surface(const fs::path& path, const LengthUnit& unit)
{
    opened(path);
    const PolygonSoup soup = read_polygons(path);
    if (soup.polygons.empty()) {
        throw InputError(fmt::format("{}: the surface has no triangles", path.string()));
    }
    require_finite(soup.points, path);
    require_valid_corners(soup, path);
    LabelledSurface surface = triangulated(soup, path);
    surface.mesh = merged(surface.mesh);
    for (Vec3& point : surface.mesh.points)
        point *= unit.metres;
    return surface;
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
