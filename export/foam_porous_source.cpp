#include "export/foam_porous_source.hpp"

#include "core/error.hpp"
#include "export/foam_format.hpp"
#include "export/text_file.hpp"

#include <fmt/format.h>

#include <fstream>
#include <iterator>
#include <optional>

namespace braidzone {

namespace {

namespace fs = std::filesystem;

/// A unit vector at right angles to n.
Vec3 some_perpendicular(const Vec3& n)
{
    Eigen::Index smallest = 0;
    n.cwiseAbs().minCoeff(&smallest);
    return n.cross(Vec3::Unit(smallest)).normalized();
}

/// Makes a dictionary include constant/fdPorosity, unless it does already.
/// @param include  the path of fdPorosity from the dictionary
/// @return true if the file was changed
bool include_sources(const fs::path& file, const std::string& include)
{
    std::string text;
    if (fs::exists(file)) {
        std::ifstream stream(file, std::ios::binary);
        text.assign(std::istreambuf_iterator<char>(stream), {});
        if (stream.bad()) throw IoError(fmt::format("{}: cannot be read", file.string()));
        if (text.find("fdPorosity\"") != std::string::npos) return false;
        if (!text.empty() && text.back() != '\n') text += '\n';
    } else {
        text = foam_header("dictionary", "constant", file.filename().string());
    }
    write_text_file(file, text + fmt::format("// The flow diverter.\n#include \"{}\"\n", include));
    return true;
}

std::string model(const FoamPorousSource& source)
{
    if (source.viscosity)
        return fmt::format(
            "        type            fixedCoeff;  // nu = {}: alpha = nu D, beta = F / 2\n"
            "        alpha           alpha [0 0 -1 0 0 0 0] {};\n"
            "        beta            beta [0 -1 0 0 0 0 0] {};\n",
            *source.viscosity, foam_vector(*source.viscosity * source.darcy),
            foam_vector(0.5 * source.forchheimer));
    std::string text = fmt::format(
        "        type            DarcyForchheimer;\n"
        "        d               d [0 -2 0 0 0 0 0] {};\n"
        "        f               f [0 -1 0 0 0 0 0] {};\n",
        foam_vector(source.darcy), foam_vector(source.forchheimer));
    if (!source.viscosity_field.empty())
        text += fmt::format("        nu              {};\n", source.viscosity_field);
    return text;
}

}  // namespace

std::string porous_sources(const std::vector<FoamPorousSource>& sources)
{
    std::string text =
        "// Resistance of the flow diverter: S = -(mu D + 1/2 rho |U| F) U, D in 1/m^2, F in 1/m,\n"
        "// along the axes of each zone; e1 is the normal of the braid unless said otherwise.\n";
    if (sources.empty()) text += "// No zone: the device meets no flow, or is not applied yet.\n";
    auto out = std::back_inserter(text);
    for (const FoamPorousSource& source : sources) {
        fmt::format_to(out, R"(
{name}
{{
    type            explicitPorositySource;
    active          yes;
    explicitPorositySourceCoeffs
    {{
        selectionMode   cellZone;
        cellZone        {zone};
{model}        coordinateSystem
        {{
            type            cartesian;
            origin          (0 0 0);
            coordinateRotation
            {{
                type            axesRotation;
                e1              {e1};
                e2              {e2};
            }}
        }}
    }}
}}
)",
                       fmt::arg("name", source.name), fmt::arg("zone", source.cell_zone),
                       fmt::arg("model", model(source)), fmt::arg("e1", foam_vector(source.e1)),
                       fmt::arg("e2", foam_vector(some_perpendicular(source.e1))));
    }
    return text;
}

std::vector<fs::path> write_porous_sources(const fs::path& foam_case,
                                           const std::vector<FoamPorousSource>& sources)
{
    const fs::path constant = "constant";
    std::vector<fs::path> files{constant / "fdPorosity"};
    write_text_file(foam_case / files.front(), porous_sources(sources));

    const fs::path system_options = fs::path("system") / "fvOptions";
    const bool only_system =
        fs::exists(foam_case / system_options) && !fs::exists(foam_case / constant / "fvOptions");
    const auto include = [&](const fs::path& file, const std::string& path) {
        if (include_sources(foam_case / file, path)) files.push_back(file);
    };
    if (only_system) {
        include(system_options, "../constant/fdPorosity");
    } else {
        include(constant / "fvOptions", "fdPorosity");
    }
    include(constant / "fvModels", "fdPorosity");
    return files;
}

}  // namespace braidzone
