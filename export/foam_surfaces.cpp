#include "export/foam_surfaces.hpp"

#include <fmt/format.h>

#include <iterator>

namespace braidzone {

namespace {

void append_triangle(std::string& text, const Vec3& a, const Vec3& b, const Vec3& c)
{
    const Vec3 n = (b - a).cross(c - a).normalized();
    auto out = std::back_inserter(text);
    fmt::format_to(out, "facet normal {:.9g} {:.9g} {:.9g}\nouter loop\n", n.x(), n.y(), n.z());
    for (const Vec3& p : {a, b, c})
        fmt::format_to(out, "vertex {} {} {}\n", p.x(), p.y(), p.z());
    text += "endloop\nendfacet\n";
}

}  // namespace

std::vector<std::string> patch_names(const Vessel& vessel, int inlet)
{
    std::vector<std::string> names;
    int outlet = 0;
    for (std::size_t i = 0; i < vessel.openings.size(); ++i)
        names.push_back(static_cast<int>(i) == inlet ? "inlet"
                                                     : fmt::format("outlet_{}", ++outlet));
    return names;
}

std::string vessel_stl(const Vessel& vessel, const std::vector<std::string>& opening_names)
{
    const ClosedLumen lumen = close_openings(vessel);
    std::string text;
    const auto append_solid = [&](const std::string& name, int opening) {
        text += "solid " + name + "\n";
        for (std::size_t t = 0; t < lumen.mesh.triangles.size(); ++t) {
            if (lumen.opening_of[t] != opening) continue;
            const auto& corners = lumen.mesh.triangles[t];
            const auto corner = [&](std::size_t i) -> const Vec3& {
                return lumen.mesh.points[static_cast<std::size_t>(corners[i])];
            };
            append_triangle(text, corner(0), corner(1), corner(2));
        }
        text += "endsolid " + name + "\n";
    };
    append_solid("wall", -1);
    for (std::size_t i = 0; i < opening_names.size(); ++i)
        append_solid(opening_names[i], static_cast<int>(i));
    return text;
}

std::string acting_device_stl(const ResistanceSheet& sheet)
{
    std::string triangles;
    for (std::size_t rhombus = 0; rhombus < sheet.acting.size(); ++rhombus) {
        if (!(sheet.acting[rhombus] > 0.0)) continue;
        const auto corner = [&](std::size_t i) -> const Vec3& {
            return sheet.surface
                .points[static_cast<std::size_t>(sheet.surface.corners[rhombus][i])];
        };
        append_triangle(triangles, corner(0), corner(1), corner(2));
        append_triangle(triangles, corner(0), corner(2), corner(3));
    }
    return triangles.empty() ? triangles : "solid device\n" + triangles + "endsolid device\n";
}

}  // namespace braidzone
