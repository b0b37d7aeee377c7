#include "export/foam_baffles.hpp"

#include "core/error.hpp"
#include "core/wall_tree.hpp"
#include "export/foam_cell_geometry.hpp"
#include "export/foam_format.hpp"
#include "export/foam_zones.hpp"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace braidzone {

namespace {

/// What the segment across a face crosses.
struct Crossing {
    int face = -1;
    int rhombus = -1;          ///< the first one
    double darcy = 0.0;        ///< D_s, summed over what is crossed [1/m]
    double forchheimer = 0.0;  ///< F_s [-]
    double step_area = 0.0;    ///< |S| [m^2]
    double area = 0.0;         ///< |S . n| [m^2]
    bool flipped = false;      ///< the face's normal is opposite to the braid's
};

/// The device's surface for segment queries: triangles 2 i and 2 i + 1 are those of rhombus i.
WallTree skin_of(const BraidSurface& surface)
{
    Vessel skin;
    skin.wall.points = surface.points;
    for (const auto& c : surface.corners) {
        skin.wall.triangles.push_back({c[0], c[1], c[2]});
        skin.wall.triangles.push_back({c[0], c[2], c[3]});
    }
    return WallTree(skin);
}

/// Every rhombus that a segment crosses, in order; a crossing of an edge counts once.
std::vector<int> rhombi_across(const WallTree& skin, const Vec3& from, const Vec3& to)
{
    // Far less than the distance of two layers, which is a wire or more.
    constexpr double past = 1e-3;
    std::vector<int> rhombi;
    double start = 0.0;
    while (start < 1.0) {
        const Vec3 begin = from + start * (to - from);
        const auto hit = skin.first_hit(begin, to);
        if (!hit) break;
        rhombi.push_back(hit->triangle / 2);
        start += hit->fraction * (1.0 - start) + past;
    }
    return rhombi;
}

std::vector<Crossing> crossings(const ResistanceSheet& sheet, const FoamMesh& mesh)
{
    const WallTree skin = skin_of(sheet.surface);
    std::vector<Crossing> of_face(mesh.neighbour.size());
    tbb::parallel_for(std::size_t{0}, of_face.size(), [&](std::size_t face) {
        const auto& from = mesh.cell_centres[static_cast<std::size_t>(mesh.owner[face])];
        const auto& to = mesh.cell_centres[static_cast<std::size_t>(mesh.neighbour[face])];
        Crossing& crossing = of_face[face];
        for (const int rhombus : rhombi_across(skin, from, to)) {
            crossing.face = static_cast<int>(face);
            if (crossing.rhombus < 0) crossing.rhombus = rhombus;
            crossing.darcy += sheet_darcy(sheet, rhombus);
            crossing.forchheimer += sheet_forchheimer(sheet, rhombus);
        }
        if (crossing.face < 0) return;
        const Vec3 area = face_area(mesh, face);
        const double along =
            area.dot(sheet.surface.normals[static_cast<std::size_t>(crossing.rhombus)]);
        crossing.step_area = area.norm();
        crossing.area = std::abs(along);
        crossing.flipped = along < 0.0;
    });
    std::erase_if(of_face, [](const Crossing& crossing) { return crossing.face < 0; });
    return of_face;
}

/// k of each crossing: over all faces of the rhombi that share a corner with its own.
std::vector<double> step_ratios(const std::vector<Crossing>& all, const BraidSurface& surface)
{
    struct Areas {
        double steps = 0.0, sheet = 0.0;
    };
    std::vector<Areas> at_corner(surface.points.size());
    const auto corners_of = [&](const Crossing& crossing) -> const std::array<int, 4>& {
        return surface.corners[static_cast<std::size_t>(crossing.rhombus)];
    };
    for (const Crossing& crossing : all)
        for (const int corner : corners_of(crossing)) {
            at_corner[static_cast<std::size_t>(corner)].steps += crossing.step_area;
            at_corner[static_cast<std::size_t>(corner)].sheet += crossing.area;
        }
    std::vector<double> ratios;
    for (const Crossing& crossing : all) {
        Areas sum;
        for (const int corner : corners_of(crossing)) {
            sum.steps += at_corner[static_cast<std::size_t>(corner)].steps;
            sum.sheet += at_corner[static_cast<std::size_t>(corner)].sheet;
        }
        ratios.push_back(sum.sheet > 0.0 ? sum.steps / sum.sheet : 1.0);
    }
    return ratios;
}

struct FaceJump {
    Crossing crossing;
    double darcy = 0.0;    ///< D [1/m^2]
    double inertia = 0.0;  ///< I [1/m]
};

FoamBaffle make_group(const std::vector<FaceJump>& jumps, std::size_t begin, std::size_t end)
{
    FoamBaffle group;
    std::vector<const FaceJump*> members;
    for (std::size_t i = begin; i < end; ++i)
        members.push_back(&jumps[i]);
    std::sort(members.begin(), members.end(), [](const FaceJump* a, const FaceJump* b) {
        return a->crossing.face < b->crossing.face;
    });
    double weight = 0.0;
    for (const FaceJump* jump : members) {
        const Crossing& crossing = jump->crossing;
        group.faces.faces.push_back(crossing.face);
        group.faces.flipped.push_back(crossing.flipped ? 1 : 0);
        group.area += crossing.area;
        group.integral += crossing.darcy * crossing.area;
        weight += crossing.step_area;
        group.darcy += crossing.step_area * jump->darcy;
        group.inertia += crossing.step_area * jump->inertia;
    }
    group.darcy /= weight;
    group.inertia /= weight;
    return group;
}

std::string front(const std::string& group)
{
    return group + "_front";
}

std::string back(const std::string& group)
{
    return group + "_back";
}

std::string patch_text(const FoamBaffle& baffle, const std::string& role, const std::string& name,
                       const std::string& opposite)
{
    return fmt::format(R"(            {role}
            {{
                name            {name};
                type            cyclic;
                neighbourPatch  {opposite};
                patchFields
                {{
                    p
                    {{
                        type            porousBafflePressure;
                        patchType       cyclic;
                        D               {darcy};
                        I               {inertia};
                        length          1;
                        jump            uniform 0;
                        value           uniform 0;
                    }}
                }}
            }}
)",
                       fmt::arg("role", role), fmt::arg("name", name),
                       fmt::arg("opposite", opposite), fmt::arg("darcy", baffle.darcy),
                       fmt::arg("inertia", baffle.inertia));
}

}  // namespace

FoamBaffles make_baffles(const ResistanceSheet& sheet, const FoamMesh& mesh, int most_groups)
{
    if (most_groups < 1)
        throw InputError(fmt::format("{} groups of faces; allowed: 1 or more", most_groups));
    const std::vector<Crossing> all = crossings(sheet, mesh);
    const std::vector<double> ratios = step_ratios(all, sheet.surface);
    std::vector<FaceJump> jumps;
    double area = 0.0, step_area = 0.0;
    for (std::size_t i = 0; i < all.size(); ++i) {
        const double k = ratios[i];
        const FaceJump jump{all[i], k * all[i].darcy, k * k * all[i].forchheimer};
        if (!(jump.darcy > 0.0) && !(jump.inertia > 0.0)) continue;
        jumps.push_back(jump);
        area += all[i].area;
        step_area += all[i].step_area;
    }
    const bool acts = std::any_of(sheet.acting.begin(), sheet.acting.end(),
                                  [](double acting) { return acting > 0.0; });
    if (jumps.empty() && acts)
        throw GeometryError(
            "no face of the mesh lies across the acting part of the device: the mesh is too coarse "
            "there for baffles, or does not hold the device");
    std::sort(jumps.begin(), jumps.end(), [](const FaceJump& a, const FaceJump& b) {
        if (a.darcy != b.darcy) return a.darcy > b.darcy;
        if (a.inertia != b.inertia) return a.inertia > b.inertia;
        return a.crossing.face < b.crossing.face;
    });

    FoamBaffles baffles;
    std::vector<FoamBaffle>& groups = baffles.groups;
    if (area > 0.0) baffles.step_ratio = step_area / area;
    double passed = 0.0;
    for (std::size_t begin = 0, end = 0; begin < jumps.size(); begin = end) {
        const double share = static_cast<double>(groups.size() + 1) / most_groups;
        while (end < jumps.size() && (end == begin || passed < share * area)) {
            passed += jumps[end].crossing.area;
            ++end;
        }
        groups.push_back(make_group(jumps, begin, end));
        groups.back().faces.name = foam_zone_name(groups.size() - 1);
    }
    return baffles;
}

std::string baffle_dict(const std::vector<FoamBaffle>& baffles)
{
    std::string text =
        foam_header("dictionary", "system", "fdBaffles") +
        "// For createBaffles -overwrite -dict system/fdBaffles: the flow diverter as "
        "pressure jumps\n"
        "// dp / rho = (nu D + I |u| / 2) |u| length on faces of the mesh.\n"
        "internalFacesOnly true;\n\nbaffles\n{\n";
    auto out = std::back_inserter(text);
    for (const FoamBaffle& baffle : baffles) {
        const std::string& name = baffle.faces.name;
        fmt::format_to(
            out,
            "    {0}\n    {{\n        type            faceZone;\n"
            "        zoneName        {0};\n        patches\n        {{\n{1}{2}        }}\n"
            "    }}\n",
            name, patch_text(baffle, "master", front(name), back(name)),
            patch_text(baffle, "slave", back(name), front(name)));
    }
    return text + "}\n";
}

}  // namespace braidzone
