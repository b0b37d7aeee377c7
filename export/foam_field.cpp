#include "export/foam_field.hpp"

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

}  // namespace

std::filesystem::path start_folder(const std::filesystem::path& foam_case)
{
    const bool only_orig =
        !std::filesystem::exists(foam_case / "0") && std::filesystem::exists(foam_case / "0.orig");
    return only_orig ? "0.orig" : "0";
}

void write_foam_field(const std::filesystem::path& folder, const FoamField& field,
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

}  // namespace braidzone
