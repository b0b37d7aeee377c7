#include "export/foam_mesh_check.hpp"

#include "core/error.hpp"
#include "export/foam_cell_geometry.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>

namespace braidzone {

namespace {

/// A cell has at least that many faces, and a face two sides.
constexpr std::size_t fewest_faces = 4;
/// OpenFOAM's primitiveMesh::closedThreshold_.
constexpr double closed_threshold = 1e-6;

std::size_t index(int label)
{
    return static_cast<std::size_t>(label);
}

class MeshCheck {
public:
    MeshCheck(const FoamMesh& mesh, const std::string& folder) : mesh_(mesh), folder_(folder) {}

    void sizes() const
    {
        const std::size_t num_faces = mesh_.faces.size();
        if (mesh_.owner.size() != num_faces)
            refuse(fmt::format("{} faces but {} owners", num_faces, mesh_.owner.size()));
        if (mesh_.neighbour.size() > num_faces)
            refuse(fmt::format("{} faces but {} neighbours", num_faces, mesh_.neighbour.size()));
        if (num_faces == 0) refuse("no faces");
    }

    void points() const
    {
        for (std::size_t i = 0; i < mesh_.points.size(); ++i)
            if (!mesh_.points[i].allFinite()) refuse(fmt::format("point {} is not finite", i));
        const auto num_points = static_cast<std::int64_t>(mesh_.points.size());
        for (std::size_t face = 0; face < mesh_.faces.size(); ++face) {
            if (mesh_.faces[face].size() < 3)
                refuse(fmt::format("face {} has {} points", face, mesh_.faces[face].size()));
            for (const int point : mesh_.faces[face])
                if (point < 0 || point >= num_points)
                    refuse(fmt::format("face {} has point {}; allowed 0 to {}", face, point,
                                       num_points - 1));
        }
    }

    void cells() const
    {
        for_each_side([&](int cell, std::size_t face) { require_cell(cell, face); });
        for (std::size_t face = 0; face < mesh_.neighbour.size(); ++face)
            if (mesh_.owner[face] >= mesh_.neighbour[face])
                refuse(
                    fmt::format("face {} lies between owner {} and neighbour {}; the owner has the "
                                "smaller number",
                                face, mesh_.owner[face], mesh_.neighbour[face]));
        std::vector<std::size_t> faces_of(index(count_cells(mesh_)), 0);
        for_each_side([&](int cell, std::size_t) { ++faces_of[index(cell)]; });
        for (std::size_t cell = 0; cell < faces_of.size(); ++cell)
            if (faces_of[cell] < fewest_faces)
                refuse(fmt::format("cell {} has {} faces", cell, faces_of[cell]));
    }

    void closedness() const
    {
        std::vector<Vec3> sums(index(count_cells(mesh_)), Vec3::Zero());
        std::vector<double> areas(sums.size(), 0.0);
        for (std::size_t face = 0; face < mesh_.faces.size(); ++face) {
            const Vec3 area = face_area(mesh_, face);
            const auto add = [&](int cell, double sign) {
                sums[index(cell)] += sign * area;
                areas[index(cell)] += area.norm();
            };
            add(mesh_.owner[face], 1.0);
            if (face < mesh_.neighbour.size()) add(mesh_.neighbour[face], -1.0);
        }
        for (std::size_t cell = 0; cell < sums.size(); ++cell)
            if (!(sums[cell].norm() <= closed_threshold * areas[cell]))
                refuse(
                    fmt::format("cell {} is not closed: the area vectors of its faces add up to "
                                "{:.6g} of their areas; run checkMesh",
                                cell, sums[cell].norm() / areas[cell]));
    }

    void patches() const
    {
        std::vector<FoamPatch> in_order = mesh_.patches;
        std::erase_if(in_order, [](const FoamPatch& patch) { return patch.num_faces == 0; });
        std::stable_sort(in_order.begin(), in_order.end(),
                         [](const FoamPatch& first, const FoamPatch& second) {
                             return first.start_face < second.start_face;
                         });
        auto next = static_cast<std::int64_t>(mesh_.neighbour.size());
        std::string before = "an internal face";
        for (const FoamPatch& patch : in_order) {
            require_within(patch);
            if (patch.start_face < next)
                refuse(fmt::format("face {} belongs to patch {} and is {}", patch.start_face,
                                   patch.name, before));
            require_no_gap(next, patch.start_face);
            next = std::int64_t{patch.start_face} + patch.num_faces;
            before = "one of patch " + patch.name + ", too";
        }
        require_no_gap(next, static_cast<std::int64_t>(mesh_.faces.size()));
    }

private:
    [[noreturn]] void refuse(const std::string& what) const
    {
        throw InputError(fmt::format("{}: {}", folder_, what));
    }

    /// Calls visit(cell, face) for both sides of each face.
    template <class Visit>
    void for_each_side(const Visit& visit) const
    {
        for (std::size_t face = 0; face < mesh_.owner.size(); ++face) {
            visit(mesh_.owner[face], face);
            if (face < mesh_.neighbour.size()) visit(mesh_.neighbour[face], face);
        }
    }

    void require_cell(int cell, std::size_t face) const
    {
        const std::size_t most_cells = 2 * mesh_.faces.size() / fewest_faces;
        if (cell >= 0 && index(cell) < most_cells) return;
        refuse(fmt::format("face {} has cell {}; allowed 0 to {}, for {} faces", face, cell,
                           static_cast<std::int64_t>(most_cells) - 1, mesh_.faces.size()));
    }

    void require_within(const FoamPatch& patch) const
    {
        const std::int64_t end = std::int64_t{patch.start_face} + patch.num_faces;
        if (end > static_cast<std::int64_t>(mesh_.faces.size()))
            refuse(fmt::format("patch {} has faces {} to {}; there are {}", patch.name,
                               patch.start_face, end - 1, mesh_.faces.size()));
    }

    void require_no_gap(std::int64_t first, std::int64_t end) const
    {
        if (first < end)
            refuse(
                fmt::format("faces {} to {} on the boundary belong to no patch", first, end - 1));
    }

    const FoamMesh& mesh_;
    const std::string& folder_;
};

}  // namespace

void require_closed_mesh(const FoamMesh& mesh, const std::string& folder)
{
    const MeshCheck check(mesh, folder);
    check.sizes();
    check.points();
    check.cells();
    check.closedness();
    check.patches();
}

}  // namespace braidzone
