#include "export/foam_mesh.hpp"

#include "core/error.hpp"
#include "export/foam_cell_geometry.hpp"
#include "export/foam_format.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace braidzone {

namespace {

std::vector<FoamPatch> read_patches(const std::filesystem::path& file)
{
    FoamReader reader(file);
    // The number of patches is redundant: the list ends with its parenthesis.
    if (reader.peek() != '(') reader.label();
    std::vector<FoamPatch> patches;
    reader.expect('(');
    while (reader.peek() != ')') {
        FoamPatch patch;
        patch.name = reader.word();
        patch.start_face = patch.num_faces = -1;
        reader.expect('{');
        while (reader.peek() != '}') {
            const std::string key = reader.word();
            if (key.empty()) reader.fail("a patch entry is expected");
            if (key == "startFace")
                patch.start_face = reader.label();
            else if (key == "nFaces")
                patch.num_faces = reader.label();
            else if (key == "type")
                patch.type = reader.word();
            reader.entry();
        }
        reader.expect('}');
        if (patch.start_face < 0 || patch.num_faces < 0 || patch.type.empty())
            reader.fail("patch " + patch.name + " lacks type, nFaces or startFace");
        patches.push_back(patch);
    }
    reader.expect(')');
    return patches;
}

/// Refuses content that would send the geometry or the solver astray.
void check(const FoamMesh& mesh, const std::string& folder)
{
    const auto refuse = [&](const std::string& what) {
        throw InputError(fmt::format("{}: {}", folder, what));
    };
    const auto num_points = static_cast<int>(mesh.points.size());
    const auto num_faces = mesh.faces.size();
    if (mesh.owner.size() != num_faces)
        refuse(fmt::format("{} faces but {} owners", num_faces, mesh.owner.size()));
    if (mesh.neighbour.size() > num_faces)
        refuse(fmt::format("{} faces but {} neighbours", num_faces, mesh.neighbour.size()));
    if (num_faces == 0) refuse("no faces");
    for (std::size_t i = 0; i < mesh.points.size(); ++i)
        if (!mesh.points[i].allFinite()) refuse(fmt::format("point {} is not finite", i));

    const int num_cells = count_cells(mesh);
    std::vector<int> faces_of(static_cast<std::size_t>(num_cells), 0);
    const auto count = [&](int cell, std::size_t face) {
        if (cell < 0) refuse(fmt::format("face {} has cell {}; allowed: 0 or more", face, cell));
        ++faces_of[static_cast<std::size_t>(cell)];
    };
    for (std::size_t f = 0; f < num_faces; ++f) {
        if (mesh.faces[f].size() < 3)
            refuse(fmt::format("face {} has {} points", f, mesh.faces[f].size()));
        for (const int point : mesh.faces[f])
            if (point < 0 || point >= num_points)
                refuse(
                    fmt::format("face {} has point {}; allowed 0 to {}", f, point, num_points - 1));
        count(mesh.owner[f], f);
        if (f < mesh.neighbour.size()) count(mesh.neighbour[f], f);
    }
    for (std::size_t cell = 0; cell < faces_of.size(); ++cell)
        if (faces_of[cell] < 4) refuse(fmt::format("cell {} has {} faces", cell, faces_of[cell]));
    for (const FoamPatch& patch : mesh.patches)
        if (static_cast<std::size_t>(patch.start_face) + static_cast<std::size_t>(patch.num_faces) >
            num_faces)
            refuse(fmt::format("patch {} has faces {} to {}; there are {}", patch.name,
                               patch.start_face, patch.start_face + patch.num_faces - 1,
                               num_faces));
}

}  // namespace

int count_cells(const FoamMesh& mesh)
{
    int last = -1;
    for (const auto* cells : {&mesh.owner, &mesh.neighbour})
        for (const int cell : *cells)
            last = std::max(last, cell);
    return last + 1;
}

FoamMesh read_foam_mesh(const std::filesystem::path& foam_case)
{
    const auto folder = foam_case / "constant" / "polyMesh";
    if (!foam_file_exists(folder / "points")) {
        if (std::filesystem::exists(foam_case / "processor0"))
            throw InputError(fmt::format(
                "{}: the mesh is decomposed (processor0, ...) and constant/polyMesh has "
                "no points; run reconstructParMesh -constant first, apply the device, "
                "and decompose again",
                foam_case.string()));
        throw IoError(
            fmt::format("{}: no such file; mesh the case first", (folder / "points").string()));
    }
    FoamMesh mesh;
    mesh.points = FoamReader(folder / "points").vectors();
    mesh.faces = FoamReader(folder / "faces").label_lists();
    mesh.owner = FoamReader(folder / "owner").labels();
    mesh.neighbour = FoamReader(folder / "neighbour").labels();
    mesh.patches = read_patches(folder / "boundary");
    check(mesh, folder.string());
    compute_cell_geometry(mesh);
    const auto worst = std::min_element(mesh.cell_volumes.begin(), mesh.cell_volumes.end());
    if (!(*worst > 0.0))
        throw InputError(fmt::format("{}: cell {} has volume {:.6g} m^3; run checkMesh",
                                     folder.string(), worst - mesh.cell_volumes.begin(), *worst));
    return mesh;
}

}  // namespace braidzone
