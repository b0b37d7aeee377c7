#include "core/centerline_io.hpp"

#include "core/error.hpp"
#include "core/vtk_messages.hpp"

#include <fmt/format.h>
#include <vtkCellArray.h>
#include <vtkCellArrayIterator.h>
#include <vtkDataArray.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkIdList.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataReader.h>
#include <vtkSmartPointer.h>
#include <vtkStringArray.h>
#include <vtkXMLPolyDataReader.h>
#include <vtkXMLPolyDataWriter.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <fstream>
#include <optional>
#include <string>
#include <string_view>

namespace braidzone {

namespace {

namespace fs = std::filesystem;

constexpr const char* radius_array = "MaximumInscribedSphereRadius";

std::string lower_case(std::string text)
{
    std::transform(text.begin(), text.end(), text.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return text;
}

void require_file(const fs::path& path)
{
    std::error_code error;
    if (!fs::exists(path, error)) {
        throw IoError(fmt::format("{}: no such file", path.string()));
    }
    if (!fs::is_regular_file(path, error)) {
        throw IoError(fmt::format("{}: not a file", path.string()));
    }
    if (!std::ifstream(path)) {
        throw IoError(fmt::format("{}: cannot be opened for reading", path.string()));
    }
}

template <typename Reader>
vtkSmartPointer<vtkPolyData> poly_data(Reader& reader, const fs::path& path)
{
    const std::string failure = fmt::format("{}: malformed or truncated", path.string());
    const VtkMessages messages(failure);
    reader.SetFileName(path.c_str());
    reader.Update();
    if (reader.GetErrorCode() != 0 || reader.GetOutput() == nullptr) throw IoError(failure);
    return reader.GetOutput();
}

/// The lines of the file as lists of point numbers. A cell that starts where the one before it
/// ends continues it: VMTK's branch extraction cuts lines into such pieces.
std::vector<std::vector<vtkIdType>> joined_lines(vtkPolyData& data, const fs::path& path)
{
    std::vector<std::vector<vtkIdType>> lines;
    const auto cell = vtkSmartPointer<vtkIdList>::New();
    auto cells = vtk::TakeSmartPointer(data.GetLines()->NewIterator());
    const auto place = [&](vtkIdType point) { return Vec3(data.GetPoint(point)); };
    for (cells->GoToFirstCell(); !cells->IsDoneWithTraversal(); cells->GoToNextCell()) {
        cells->GetCurrentCell(cell);
        std::vector<vtkIdType> points;
        for (vtkIdType i = 0; i < cell->GetNumberOfIds(); ++i) {
            const vtkIdType point = cell->GetId(i);
            if (!(point >= 0 && point < data.GetNumberOfPoints())) {
                throw InputError(fmt::format("{}: a line refers to point {}, but there are {}",
                                             path.string(), point, data.GetNumberOfPoints()));
            }
            points.push_back(point);
        }
        if (points.size() < 2) continue;
        // VMTK writes the cut's point to both pieces, in single precision.
        const double tolerance = 1e-6 * data.GetLength();
        const bool continues =
            !lines.empty() &&
            (place(lines.back().back()) - place(points.front())).norm() <= tolerance;
        if (continues) {
            lines.back().insert(lines.back().end(), points.begin() + 1, points.end());
        } else {
            lines.push_back(points);
        }
    }
    return lines;
}

std::vector<Polyline> read_vtk(vtkPolyData& data, const fs::path& path)
{
    vtkDataArray* radii = data.GetPointData()->GetArray(radius_array);
    std::vector<Polyline> lines;
    for (const std::vector<vtkIdType>& points : joined_lines(data, path)) {
        Polyline& line = lines.emplace_back();
        for (const vtkIdType point : points) {
            line.points.emplace_back(data.GetPoint(point));
            if (radii != nullptr) line.inscribed_radii.push_back(radii->GetTuple1(point));
        }
    }
    if (lines.empty()) throw InputError(fmt::format("{}: holds no line", path.string()));
    return lines;
}

std::vector<std::string> cells_of(const std::string& row)
{
    std::vector<std::string> cells(1);
    for (const char c : row) {
        if (c == ',' || c == ';') {
            cells.emplace_back();
        } else if (c != '"' && !std::isspace(static_cast<unsigned char>(c))) {
            cells.back() += c;
        }
    }
    return cells;
}

std::optional<double> number(const std::string& cell)
{
    double value = 0.0;
    const char* const end = cell.data() + cell.size();
    const auto [rest, error] = std::from_chars(cell.data(), end, value);
    if (error != std::errc() || rest != end || cell.empty()) return std::nullopt;
    return value;
}

/// Column numbers of x, y, z and radius.
struct CsvColumns {
    std::array<std::size_t, 3> point = {0, 1, 2};
    std::optional<std::size_t> radius;
};

/// The columns by the names in the first row or, if that holds numbers, by their order.
CsvColumns find_columns(const std::vector<std::string>& first_row, const std::string& place)
{
    CsvColumns columns;
    if (number(first_row.front())) {
        if (first_row.size() > 3) columns.radius = 3;
        return columns;
    }
    const auto column = [&](const std::string& name) -> std::optional<std::size_t> {
        for (std::size_t i = 0; i < first_row.size(); ++i) {
            if (lower_case(first_row[i]) == name) return i;
        }
        return std::nullopt;
    };
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const std::string name(1, "xyz"[axis]);
        const auto found = column(name);
        if (!found) {
            throw InputError(
                fmt::format("{}: no column \"{}\"; needed are x, y, z and, if known, "
                            "radius",
                            place, name));
        }
        columns.point[axis] = *found;
    }
    columns.radius = column("radius");
    return columns;
}

Polyline read_csv(const fs::path& path)
{
    std::ifstream file(path);
    Polyline polyline;
    std::optional<CsvColumns> columns;
    std::string row;
    for (int line = 1; std::getline(file, row); ++line) {
        const std::string place = fmt::format("{}:{}", path.string(), line);
        const std::vector<std::string> cells = cells_of(row);
        if ((cells.size() == 1 && cells[0].empty()) || cells[0].starts_with('#')) continue;
        if (!columns) {
            columns = find_columns(cells, place);
            if (!number(cells.front())) continue;
        }
        const auto value = [&](std::size_t column) {
            if (column >= cells.size()) {
                throw InputError(fmt::format("{}: {} columns; column {} is needed", place,
                                             cells.size(), column + 1));
            }
            const auto parsed = number(cells[column]);
            if (!parsed) {
                throw InputError(fmt::format("{}: \"{}\" is not a number", place, cells[column]));
            }
            return *parsed;
        };
        polyline.points.emplace_back(value(columns->point[0]), value(columns->point[1]),
                                     value(columns->point[2]));
        if (columns->radius) polyline.inscribed_radii.push_back(value(*columns->radius));
    }
    if (polyline.points.size() < 2) {
        throw InputError(fmt::format("{}: {} points; a line has at least 2", path.string(),
                                     polyline.points.size()));
    }
    return polyline;
}

std::vector<Polyline> read_in_file_unit(const fs::path& path)
{
    const std::string ending = lower_case(path.extension().string());
    if (ending == ".vtp") {
        const auto reader = vtkSmartPointer<vtkXMLPolyDataReader>::New();
        return read_vtk(*poly_data(*reader, path), path);
    }
    if (ending == ".vtk") {
        const auto reader = vtkSmartPointer<vtkPolyDataReader>::New();
        {
            const VtkMessages messages;
            reader->SetFileName(path.c_str());
            if (!reader->IsFilePolyData()) {
                throw InputError(fmt::format("{}: a legacy VTK file of DATASET POLYDATA is needed",
                                             path.string()));
            }
        }
        return read_vtk(*poly_data(*reader, path), path);
    }
    if (ending == ".csv") return {read_csv(path)};
    throw InputError(
        fmt::format("{}: ending \"{}\" is not .vtp, .vtk or .csv", path.string(), ending));
}

void require_finite(const Polyline& polyline, const fs::path& path)
{
    for (std::size_t i = 0; i < polyline.points.size(); ++i) {
        const Vec3& point = polyline.points[i];
        if (!point.allFinite()) {
            throw InputError(fmt::format("{}: point {} = ({:.6g}, {:.6g}, {:.6g}) is not finite",
                                         path.string(), i, point.x(), point.y(), point.z()));
        }
        if (!polyline.inscribed_radii.empty() && !std::isfinite(polyline.inscribed_radii[i])) {
            throw InputError(
                fmt::format("{}: the radius at point {} is not finite", path.string(), i));
        }
    }
}

}  // namespace

std::vector<Polyline> read_centerlines(const fs::path& path, const LengthUnit& unit)
{
    require_file(path);
    std::vector<Polyline> lines = read_in_file_unit(path);
    for (Polyline& line : lines) {
        require_finite(line, path);
        for (Vec3& point : line.points)
            point *= unit.metres;
        for (double& radius : line.inscribed_radii)
            radius *= unit.metres;
    }
    return lines;
}

Polyline read_centerline(const fs::path& path, const LengthUnit& unit, int line)
{
    std::vector<Polyline> lines = read_centerlines(path, unit);
    const int num_lines = static_cast<int>(lines.size());
    if (line == -1 && num_lines > 1) {
        throw InputError(fmt::format("{}: holds {} lines; say which one, 0 to {}", path.string(),
                                     num_lines, num_lines - 1));
    }
    if (!(line >= -1 && line < num_lines)) {
        throw InputError(fmt::format("{}: line {} is wanted; the file has lines 0 to {}",
                                     path.string(), line, num_lines - 1));
    }
    return std::move(lines[static_cast<std::size_t>(std::max(line, 0))]);
}

void write_centerline(const fs::path& path, const Polyline& polyline, const LengthUnit& unit)
{
    const auto points = vtkSmartPointer<vtkPoints>::New();
    points->SetDataTypeToDouble();
    const auto line = vtkSmartPointer<vtkIdList>::New();
    for (const Vec3& point : polyline.points) {
        const Vec3 in_unit = point / unit.metres;
        line->InsertNextId(points->InsertNextPoint(in_unit.data()));
    }
    const auto lines = vtkSmartPointer<vtkCellArray>::New();
    lines->InsertNextCell(line);
    const auto data = vtkSmartPointer<vtkPolyData>::New();
    data->SetPoints(points);
    data->SetLines(lines);
    if (!polyline.inscribed_radii.empty()) {
        const auto radii = vtkSmartPointer<vtkDoubleArray>::New();
        radii->SetName(radius_array);
        for (const double radius : polyline.inscribed_radii) {
            radii->InsertNextValue(radius / unit.metres);
        }
        data->GetPointData()->AddArray(radii);
    }
    const auto unit_name = vtkSmartPointer<vtkStringArray>::New();
    unit_name->SetName("length_unit");
    unit_name->InsertNextValue(unit.name);
    data->GetFieldData()->AddArray(unit_name);

    const VtkMessages messages;
    const auto writer = vtkSmartPointer<vtkXMLPolyDataWriter>::New();
    writer->SetFileName(path.c_str());
    writer->SetInputData(data);
    if (writer->Write() == 0 || messages.any()) {
        throw IoError(fmt::format("{}: cannot be written{}{}", path.string(),
                                  messages.any() ? ": " : "", messages.first()));
    }
}

}  // namespace braidzone
