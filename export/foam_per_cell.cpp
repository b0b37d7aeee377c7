#include "export/foam_per_cell.hpp"

#include "export/foam_field.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <numbers>

namespace braidzone {

namespace {

constexpr const char* prefix = "fdNuD_";

Mat3 tensor(const CellResistance& resistance, std::size_t i)
{
    const double r = resistance.tangential_ratio.linear;
    const Vec3& n = resistance.normal[i];
    return resistance.darcy[i] * (r * Mat3::Identity() + (1.0 - r) * n * n.transpose());
}

/// The names of the fields, in a list of OpenFOAM's.
std::string names_of(const std::vector<FoamDirectedField>& fields)
{
    std::string names;
    for (const FoamDirectedField& field : fields)
        names += (names.empty() ? "" : " ") + field.name;
    return "(" + names + ")";
}

}  // namespace

std::vector<FoamDirectedField> directed_fields(const CellResistance& resistance)
{
    constexpr double half = 1.0 / std::numbers::sqrt2;
    std::vector<FoamDirectedField> fields = {
        {"x", Vec3::UnitX(), {}},          {"y", Vec3::UnitY(), {}},
        {"z", Vec3::UnitZ(), {}},          {"xy", Vec3(half, half, 0.0), {}},
        {"yz", Vec3(0.0, half, half), {}}, {"xz", Vec3(half, 0.0, half), {}},
    };
    for (std::size_t i = 0; i < resistance.cells.size(); ++i) {
        const Mat3 d = tensor(resistance, i);
        const double xy = d(0, 1), yz = d(1, 2), xz = d(0, 2);
        const std::array<double, 6> coefficients = {
            d(0, 0) - xy - xz, d(1, 1) - xy - yz, d(2, 2) - xz - yz, 2.0 * xy, 2.0 * yz, 2.0 * xz};
        for (std::size_t k = 0; k < fields.size(); ++k)
            fields[k].coefficient.push_back(coefficients[k]);
    }
    std::erase_if(fields, [](const FoamDirectedField& field) {
        return std::all_of(field.coefficient.begin(), field.coefficient.end(),
                           [](double c) { return c == 0.0; });
    });
    for (FoamDirectedField& field : fields)
        field.name = prefix + field.name;
    return fields;
}

std::vector<FoamPorousSource> per_cell_sources(const std::vector<FoamDirectedField>& fields)
{
    std::vector<FoamPorousSource> sources;
    for (const FoamDirectedField& field : fields)
        // OpenFOAM registers a source under its name, which must not be that of a field.
        sources.push_back({.name = "source_" + field.name,
                           .cell_zone = per_cell_zone,
                           .darcy = Vec3::UnitX(),
                           .e1 = field.e1,
                           .viscosity_field = field.name});
    return sources;
}

std::vector<std::filesystem::path> write_directed_fields(
    const std::filesystem::path& foam_case, const std::vector<FoamDirectedField>& fields,
    const CellResistance& resistance, const FoamMesh& mesh, double viscosity)
{
    const std::filesystem::path start = start_folder(foam_case);
    std::vector<std::filesystem::path> files;
    for (const FoamDirectedField& field : fields) {
        std::vector<std::string> values(mesh.cell_volumes.size(), "0");
        for (std::size_t i = 0; i < resistance.cells.size(); ++i)
            values[static_cast<std::size_t>(resistance.cells[i])] =
                fmt::format("{}", viscosity * field.coefficient[i]);
        write_foam_field(foam_case / start, {field.name, "scalar", "[0 2 -1 0 0 0 0]", "0"}, values,
                         mesh);
        files.push_back(start / field.name);
    }
    return files;
}

std::vector<std::filesystem::path> directed_field_files(const std::filesystem::path& foam_case)
{
    std::vector<std::filesystem::path> files;
    for (const char* direction : {"x", "y", "z", "xy", "yz", "xz"})
        files.push_back(start_folder(foam_case) / (std::string(prefix) + direction));
    return files;
}

std::string directed_field_functions(const std::vector<FoamDirectedField>& fields)
{
    if (fields.empty()) return "";
    const std::string names = names_of(fields);
    return "// The resistance of the cells: read at the start, written with every time so that a "
           "run\n"
           "// can be taken up again.\n"
           "readDevice\n{\n"
           "    type            readFields;\n"
           "    libs            (\"libfieldFunctionObjects.so\");\n"
           "    fields          " +
           names +
           ";\n"
           "    readOnStart     true;\n"
           "}\n"
           "writeDevice\n{\n"
           "    type            writeObjects;\n"
           "    libs            (\"libutilityFunctionObjects.so\");\n"
           "    objects         " +
           names +
           ";\n"
           "    writeOption     anyWrite;\n"
           "    writeControl    writeTime;\n"
           "}\n";
}

}  // namespace braidzone
