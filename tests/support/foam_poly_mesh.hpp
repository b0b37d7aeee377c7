#pragma once

#include "export/foam_format.hpp"
#include "export/foam_mesh.hpp"
#include "export/text_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <numeric>
#include <string>
#include <vector>

namespace braidzone::test {

/// Moves the faces of a patch whose centre `is_moved` to a patch of their own, behind it.
template <class Predicate>
void split_patch(FoamMesh& mesh, const std::string& patch, const FoamPatch& new_patch,
                 Predicate is_moved)
{
    const auto old = std::find_if(mesh.patches.begin(), mesh.patches.end(),
                                  [&](const FoamPatch& p) { return p.name == patch; });
    std::vector<int> order(static_cast<std::size_t>(old->num_faces));
    std::iota(order.begin(), order.end(), old->start_face);
    const auto stays = [&](int face) {
        Vec3 centre = Vec3::Zero();
        const auto& corners = mesh.faces[static_cast<std::size_t>(face)];
        for (const int corner : corners)
            centre +=
                mesh.points[static_cast<std::size_t>(corner)] / static_cast<double>(corners.size());
        return !is_moved(centre);
    };
    const auto first_moved = std::stable_partition(order.begin(), order.end(), stays);
    const auto faces = mesh.faces;
    const auto owner = mesh.owner;
    for (std::size_t i = 0; i < order.size(); ++i) {
        const std::size_t to = static_cast<std::size_t>(old->start_face) + i;
        mesh.faces[to] = faces[static_cast<std::size_t>(order[i])];
        mesh.owner[to] = owner[static_cast<std::size_t>(order[i])];
    }
    FoamPatch moved = new_patch;
    moved.num_faces = static_cast<int>(order.end() - first_moved);
    old->num_faces -= moved.num_faces;
    moved.start_face = old->start_face + old->num_faces;
    mesh.patches.insert(old + 1, moved);
}

/// Writes a mesh as an ASCII constant/polyMesh.
inline void write_poly_mesh(const std::filesystem::path& foam_case, const FoamMesh& mesh)
{
    const auto write = [&](const char* class_name, const char* object, const auto& items,
                           auto text_of_item) {
        std::string text = foam_header(class_name, "constant/polyMesh", object) +
                           fmt::format("{}\n(\n", items.size());
        for (const auto& item : items)
            text += text_of_item(item) + "\n";
        write_text_file(foam_case / "constant/polyMesh" / object, text + ")\n");
    };
    const auto number = [](int value) { return std::to_string(value); };
    write("vectorField", "points", mesh.points, foam_vector);
    write("faceList", "faces", mesh.faces, [](const std::vector<int>& face) {
        return fmt::format("{}({})", face.size(), fmt::join(face, " "));
    });
    write("labelList", "owner", mesh.owner, number);
    write("labelList", "neighbour", mesh.neighbour, number);
    write("polyBoundaryMesh", "boundary", mesh.patches, [](const FoamPatch& patch) {
        return fmt::format("{} {{ type {}; nFaces {}; startFace {}; }}", patch.name, patch.type,
                           patch.num_faces, patch.start_face);
    });
}

}  // namespace braidzone::test
