#include "export/foam_inspection.hpp"

#include "export/foam_format.hpp"
#include "export/text_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <string_view>

namespace braidzone {

namespace {

/// Patch types that prescribe the type of every field's boundary condition.
bool is_constraint(const std::string& patch_type)
{
    constexpr std::array<std::string_view, 8> constraints = {
        "empty",  "wedge",     "symmetry",   "symmetryPlane",
        "cyclic", "cyclicAMI", "cyclicACMI", "processor"};
    return std::find(constraints.begin(), constraints.end(), patch_type) != constraints.end();
}

/// A volScalarField or volVectorField as text, from the text of its cell values.
struct FieldText {
    std::string name;
    std::string value_type;  ///< "scalar" or "vector"
    std::string dimensions;  ///< e.g. "[0 -2 0 0 0 0 0]"
    std::string zero;        ///< the value on patches
};

void write_field(const std::filesystem::path& folder, const FieldText& field,
                 const std::vector<std::string>& values, const FoamMesh& mesh)
{
    const std::string field_class =
        field.value_type == "vector" ? "volVectorField" : "volScalarField";
    std::string text = foam_header(field_class, folder.filename().string(), field.name);
    auto out = std::back_inserter(text);
    fmt::format_to(out,
                   "dimensions      {};\n\ninternalField   nonuniform List<{}>\n{}\n(\n{}\n)\n;\n\n"
                   "boundaryField\n{{\n",
                   field.dimensions, field.value_type, values.size(), fmt::join(values, "\n"));
    for (const FoamPatch& patch : mesh.patches) {
        if (is_constraint(patch.type))
            fmt::format_to(out, "    {} {{ type {}; }}\n", patch.name, patch.type);
        else
            fmt::format_to(out, "    {} {{ type calculated; value uniform {}; }}\n", patch.name,
                           field.zero);
    }
    text += "}\n";
    write_text_file(folder / field.name, text);
}

}  // namespace

std::vector<std::filesystem::path> write_inspection_fields(const std::filesystem::path& foam_case,
                                                           const FoamMesh& mesh,
                                                           const CellResistance& resistance,
                                                           const std::vector<FoamZone>& zones)
{
    const bool only_orig =
        !std::filesystem::exists(foam_case / "0") && std::filesystem::exists(foam_case / "0.orig");
    const std::filesystem::path start = only_orig ? "0.orig" : "0";

    const std::size_t num_cells = mesh.cell_volumes.size();
    std::vector<std::string> darcy(num_cells, "0"), forchheimer(num_cells, "0");
    std::vector<std::string> normal(num_cells, "(0 0 0)"), zone_of(num_cells, "-1");
    for (std::size_t i = 0; i < resistance.cells.size(); ++i) {
        const auto cell = static_cast<std::size_t>(resistance.cells[i]);
        darcy[cell] = fmt::format("{:.9g}", resistance.darcy[i]);
        forchheimer[cell] = fmt::format("{:.9g}", resistance.forchheimer[i]);
        const Vec3& n = resistance.normal[i];
        normal[cell] = fmt::format("({:.9g} {:.9g} {:.9g})", n.x(), n.y(), n.z());
    }
    std::vector<std::string> voids(num_cells, "1"), density(num_cells, "0");
    for (std::size_t i = 0; i < resistance.metal.cells.size(); ++i) {
        const auto cell = static_cast<std::size_t>(resistance.metal.cells[i]);
        voids[cell] = fmt::format("{:.9g}", resistance.metal.void_fraction[i]);
        density[cell] = fmt::format("{:.9g}", resistance.metal.surface_density[i]);
    }
    for (std::size_t zone = 0; zone < zones.size(); ++zone)
        for (const int cell : zones[zone].cells)
            zone_of[static_cast<std::size_t>(cell)] = std::to_string(zone);

    const std::string no_dimension = "[0 0 0 0 0 0 0]";
    const auto folder = foam_case / start;
    write_field(folder, {"fdDarcy", "scalar", "[0 -2 0 0 0 0 0]", "0"}, darcy, mesh);
    write_field(folder, {"fdForchheimer", "scalar", "[0 -1 0 0 0 0 0]", "0"}, forchheimer, mesh);
    write_field(folder, {"fdNormal", "vector", no_dimension, "(0 0 0)"}, normal, mesh);
    write_field(folder, {"fdVoidFraction", "scalar", no_dimension, "1"}, voids, mesh);
    write_field(folder, {"fdSurfaceDensity", "scalar", "[0 -1 0 0 0 0 0]", "0"}, density, mesh);
    write_field(folder, {"fdZone", "scalar", no_dimension, "-1"}, zone_of, mesh);
    return {start / "fdDarcy",        start / "fdForchheimer",    start / "fdNormal",
            start / "fdVoidFraction", start / "fdSurfaceDensity", start / "fdZone"};
}

}  // namespace braidzone
