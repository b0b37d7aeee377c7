#pragma once

#include "export/foam_cell_geometry.hpp"
#include "export/foam_mesh.hpp"

#include <array>
#include <vector>

namespace braidzone::test {

/// A block of nx x ny x nz cubes of edge `cell` with its corner at `origin`; cell (i, j, k) has
/// index i + nx (j + ny k). Patches: "inlet" (x lower) and "outlet" (x upper) of type patch,
/// "wall".
inline FoamMesh foam_box(const std::array<int, 3>& size, double cell,
                         const Vec3& origin = Vec3::Zero())
{
    const auto [nx, ny, nz] = size;
    FoamMesh mesh;
    for (int k = 0; k <= nz; ++k)
        for (int j = 0; j <= ny; ++j)
            for (int i = 0; i <= nx; ++i)
                mesh.points.push_back(origin + cell * Vec3(i, j, k));
    const auto point = [=](int i, int j, int k) { return i + (nx + 1) * (j + (ny + 1) * k); };
    const auto index = [=](int i, int j, int k) { return i + nx * (j + ny * k); };

    // The face of cell (i, j, k) towards +axis, or the one towards -axis turned outwards.
    const auto face = [&](int i, int j, int k, int axis, bool upper) -> std::vector<int> {
        const int d = upper ? 1 : 0;
        std::vector<int> corners;
        if (axis == 0)
            corners = {point(i + d, j, k), point(i + d, j + 1, k), point(i + d, j + 1, k + 1),
                       point(i + d, j, k + 1)};
        else if (axis == 1)
            corners = {point(i, j + d, k), point(i, j + d, k + 1), point(i + 1, j + d, k + 1),
                       point(i + 1, j + d, k)};
        else
            corners = {point(i, j, k + d), point(i + 1, j, k + d), point(i + 1, j + 1, k + d),
                       point(i, j + 1, k + d)};
        if (!upper) return {corners[3], corners[2], corners[1], corners[0]};
        return corners;
    };
    const auto for_each_cell = [&](auto visit) {
        for (int k = 0; k < nz; ++k)
            for (int j = 0; j < ny; ++j)
                for (int i = 0; i < nx; ++i)
                    visit(std::array{i, j, k});
    };

    for_each_cell([&](const std::array<int, 3>& c) {
        for (int axis = 0; axis < 3; ++axis) {
            auto next = c;
            ++next[static_cast<std::size_t>(axis)];
            if (next[0] == nx || next[1] == ny || next[2] == nz) continue;
            mesh.faces.push_back(face(c[0], c[1], c[2], axis, true));
            mesh.owner.push_back(index(c[0], c[1], c[2]));
            mesh.neighbour.push_back(index(next[0], next[1], next[2]));
        }
    });
    const auto add_patch = [&](const char* name, const char* type, auto is_on_patch) {
        FoamPatch patch{name, type, static_cast<int>(mesh.faces.size()), 0};
        for_each_cell([&](const std::array<int, 3>& c) {
            for (int axis = 0; axis < 3; ++axis)
                for (const bool upper : {false, true}) {
                    const auto a = static_cast<std::size_t>(axis);
                    if (c[a] != (upper ? size[a] - 1 : 0) || !is_on_patch(axis, upper)) continue;
                    mesh.faces.push_back(face(c[0], c[1], c[2], axis, upper));
                    mesh.owner.push_back(index(c[0], c[1], c[2]));
                }
        });
        patch.num_faces = static_cast<int>(mesh.faces.size()) - patch.start_face;
        mesh.patches.push_back(patch);
    };
    add_patch("inlet", "patch", [](int axis, bool upper) { return axis == 0 && !upper; });
    add_patch("outlet", "patch", [](int axis, bool upper) { return axis == 0 && upper; });
    add_patch("wall", "wall", [](int axis, bool) { return axis != 0; });
    compute_cell_geometry(mesh);
    return mesh;
}

}  // namespace braidzone::test
