#include "export/foam_mesh.hpp"

#include "core/error.hpp"
#include "export/foam_cell_geometry.hpp"
#include "export/foam_format.hpp"
#include "export/foam_mesh_check.hpp"

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
    require_closed_mesh(mesh, folder.string());
    compute_cell_geometry(mesh);
    const auto worst = std::min_element(mesh.cell_volumes.begin(), mesh.cell_volumes.end());
    if (!(*worst > 0.0))
        throw InputError(fmt::format("{}: cell {} has volume {:.6g} m^3; run checkMesh",
                                     folder.string(), worst - mesh.cell_volumes.begin(), *worst));
    return mesh;
}

}  // namespace braidzone
