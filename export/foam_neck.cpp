#include "export/foam_neck.hpp"

namespace braidzone {

namespace {

std::vector<char> is_in(const std::vector<int>& cells, const FoamMesh& mesh)
{
    std::vector<char> in(mesh.cell_volumes.size(), 0);
    for (const int cell : cells)
        in[static_cast<std::size_t>(cell)] = 1;
    return in;
}

}  // namespace

FoamFaceZone sac_neck(const std::string& name, const std::vector<int>& sac, const FoamMesh& mesh)
{
    const std::vector<char> in_sac = is_in(sac, mesh);
    FoamFaceZone zone{name, {}, {}};
    for (std::size_t face = 0; face < mesh.neighbour.size(); ++face) {
        const char owner = in_sac[static_cast<std::size_t>(mesh.owner[face])];
        const char neighbour = in_sac[static_cast<std::size_t>(mesh.neighbour[face])];
        if (owner == neighbour) continue;
        zone.faces.push_back(static_cast<int>(face));
        zone.flipped.push_back(owner);  // a face's normal points out of its owner
    }
    return zone;
}

FoamFaceZone sac_wall(const std::string& name, const std::vector<int>& sac, const FoamMesh& mesh)
{
    const std::vector<char> in_sac = is_in(sac, mesh);
    FoamFaceZone zone{name, {}, {}};
    for (const FoamPatch& patch : mesh.patches) {
        if (patch.type != "wall") continue;
        for (int face = patch.start_face; face < patch.start_face + patch.num_faces; ++face) {
            if (in_sac[static_cast<std::size_t>(mesh.owner[static_cast<std::size_t>(face)])])
                zone.faces.push_back(face);
        }
    }
    zone.flipped.assign(zone.faces.size(), 0);
    return zone;
}

}  // namespace braidzone
