#include "export/lattice_arrays.hpp"

#include "export/binary_file.hpp"
#include "export/npy_header.hpp"
#include "export/resisting_planes.hpp"

#include <fmt/format.h>

#include <functional>
#include <string>

namespace braidzone {

namespace {

std::string shape_text(const VoxelGrid& grid)
{
    return fmt::format("{}, {}, {}", grid.dims[0], grid.dims[1], grid.dims[2]);
}

std::size_t plane_size(const VoxelGrid& grid)
{
    return grid.index(0, 0, 1);
}

/// Writes an array that is 0 but at the resisting nodes, plane by plane.
/// @param num_components  numbers a node
/// @param value           of a resisting node's component
void write_sparse(const std::filesystem::path& path, const LatticeNodes& nodes, int num_components,
                  const std::function<double(std::size_t, int)>& value)
{
    const auto components = static_cast<std::size_t>(num_components);
    BinaryFile file(path);
    const std::string shape = components == 1
                                  ? shape_text(nodes.grid)
                                  : fmt::format("{}, {}", num_components, shape_text(nodes.grid));
    file.write(npy_header("<f4", shape, NpyOrder::first_fastest));
    const ResistingPlanes planes(nodes, 2);
    for (int k = 0; k < nodes.grid.dims[2]; ++k) {
        std::vector<float> plane(components * plane_size(nodes.grid), 0.0F);
        for (const std::size_t i : planes.in_plane(k)) {
            const std::size_t place =
                static_cast<std::size_t>(nodes.resisting[i]) - nodes.grid.index(0, 0, k);
            for (int c = 0; c < num_components; ++c)
                plane[components * place + static_cast<std::size_t>(c)] =
                    static_cast<float>(value(i, c));
        }
        file.write(plane);
    }
    file.close();
}

}  // namespace

std::vector<LatticeFile> write_lattice_arrays(const std::filesystem::path& folder,
                                              const LatticeNodes& nodes)
{
    BinaryFile types(folder / "cell_type.npy");
    types.write(npy_header("|u1", shape_text(nodes.grid), NpyOrder::first_fastest));
    types.write(nodes.type);
    types.close();
    write_sparse(folder / "darcy.npy", nodes, 1,
                 [&](std::size_t i, int) { return nodes.darcy[i]; });
    write_sparse(folder / "forchheimer.npy", nodes, 1,
                 [&](std::size_t i, int) { return nodes.forchheimer[i]; });
    write_sparse(folder / "normal.npy", nodes, 3,
                 [&](std::size_t i, int c) { return nodes.normal[i][c]; });
    const std::vector<int> shape = shape_of(nodes.grid.dims);
    std::vector<int> vector_shape{3};
    vector_shape.insert(vector_shape.end(), shape.begin(), shape.end());
    const char* order = "first index fastest";
    return {{"cell_type.npy", "uint8", shape, order},
            {"darcy.npy", "float32 [1/m^2]", shape, order},
            {"forchheimer.npy", "float32 [1/m]", shape, order},
            {"normal.npy", "float32", vector_shape, order}};
}

LatticeFile write_palabos_geometry(const std::filesystem::path& path, const LatticeNodes& nodes,
                                   const NodeBox& box)
{
    BinaryFile file(path);
    for (int i = box.first[0]; i <= box.last[0]; ++i) {
        std::string text;
        for (int j = box.first[1]; j <= box.last[1]; ++j) {
            for (int k = box.first[2]; k <= box.last[2]; ++k) {
                const std::uint8_t type = nodes.type[nodes.grid.index(i, j, k)];
                const bool is_wall = type == static_cast<std::uint8_t>(NodeType::wall);
                text += is_open(type) ? '0' : is_wall ? '1' : '2';
                text += k < box.last[2] ? ' ' : '\n';
            }
        }
        file.write(text);
    }
    file.close();
    return {path.filename(), "integers in text", shape_of(box.dims()), "last index fastest"};
}

LatticeFile write_walberla_mask(const std::filesystem::path& path, const LatticeNodes& nodes)
{
    BinaryFile file(path);
    const std::size_t in_plane = plane_size(nodes.grid);
    for (std::size_t first = 0; first < nodes.type.size(); first += in_plane) {
        std::vector<char> plane;
        plane.reserve(in_plane);
        for (std::size_t node = first; node < first + in_plane; ++node)
            plane.push_back(is_open(nodes.type[node]) ? 1 : 0);
        file.write(plane);
    }
    file.close();
    return {path.filename(), "uint8", shape_of(nodes.grid.dims), "first index fastest"};
}

}  // namespace braidzone
