#include "export/lattice_arrays.hpp"

#include "core/error.hpp"
#include "export/npy_header.hpp"

#include <fmt/format.h>

#include <bit>
#include <fstream>
#include <functional>
#include <string>

namespace braidzone {

namespace {

static_assert(std::endian::native == std::endian::little);

/// Values of one z are written at once.
class PlaneFile {
public:
    explicit PlaneFile(const std::filesystem::path& path)
        : path_(path), file_(path, std::ios::binary)
    {
    }

    void write(const char* bytes, std::size_t count)
    {
        file_.write(bytes, static_cast<std::streamsize>(count));
    }

    template <typename Value>
    void write(const std::vector<Value>& values)
    {
        write(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(Value));
    }

    void close()
    {
        file_.close();
        if (!file_) throw IoError(fmt::format("{} cannot be written", path_.string()));
    }

private:
    std::filesystem::path path_;
    std::ofstream file_;
};

std::string shape_of(const VoxelGrid& grid)
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
    PlaneFile file(path);
    const std::string shape = components == 1
                                  ? shape_of(nodes.grid)
                                  : fmt::format("{}, {}", num_components, shape_of(nodes.grid));
    const std::string header = npy_header("<f4", shape, NpyOrder::first_fastest);
    file.write(header.data(), header.size());
    const std::size_t in_plane = plane_size(nodes.grid);
    std::size_t next = 0;
    for (int k = 0; k < nodes.grid.dims[2]; ++k) {
        std::vector<float> plane(components * in_plane, 0.0F);
        const std::size_t first = static_cast<std::size_t>(k) * in_plane;
        for (; next < nodes.resisting.size() &&
               static_cast<std::size_t>(nodes.resisting[next]) < first + in_plane;
             ++next) {
            const std::size_t place = static_cast<std::size_t>(nodes.resisting[next]) - first;
            for (int c = 0; c < num_components; ++c)
                plane[components * place + static_cast<std::size_t>(c)] =
                    static_cast<float>(value(next, c));
        }
        file.write(plane);
    }
    file.close();
}

bool is_open(std::uint8_t type)
{
    return type >= static_cast<std::uint8_t>(NodeType::fluid);
}

}  // namespace

void write_lattice_arrays(const std::filesystem::path& folder, const LatticeNodes& nodes)
{
    PlaneFile types(folder / "cell_type.npy");
    const std::string header = npy_header("|u1", shape_of(nodes.grid), NpyOrder::first_fastest);
    types.write(header.data(), header.size());
    types.write(nodes.type);
    types.close();
    write_sparse(folder / "darcy.npy", nodes, 1,
                 [&](std::size_t i, int) { return nodes.darcy[i]; });
    write_sparse(folder / "forchheimer.npy", nodes, 1,
                 [&](std::size_t i, int) { return nodes.forchheimer[i]; });
    write_sparse(folder / "normal.npy", nodes, 3,
                 [&](std::size_t i, int c) { return nodes.normal[i][c]; });
}

void write_palabos_geometry(const std::filesystem::path& path, const LatticeNodes& nodes)
{
    PlaneFile file(path);
    const auto& [nx, ny, nz] = nodes.grid.dims;
    for (int i = 0; i < nx; ++i) {
        std::string text;
        for (int j = 0; j < ny; ++j) {
            for (int k = 0; k < nz; ++k) {
                const std::uint8_t type = nodes.type[nodes.grid.index(i, j, k)];
                const bool is_wall = type == static_cast<std::uint8_t>(NodeType::wall);
                text += is_open(type) ? '0' : is_wall ? '1' : '2';
                text += k + 1 < nz ? ' ' : '\n';
            }
        }
        file.write(text.data(), text.size());
    }
    file.close();
}

void write_walberla_mask(const std::filesystem::path& path, const LatticeNodes& nodes)
{
    PlaneFile file(path);
    const std::size_t in_plane = plane_size(nodes.grid);
    for (std::size_t first = 0; first < nodes.type.size(); first += in_plane) {
        std::vector<char> plane;
        plane.reserve(in_plane);
        for (std::size_t node = first; node < first + in_plane; ++node)
            plane.push_back(is_open(nodes.type[node]) ? 1 : 0);
        file.write(plane);
    }
    file.close();
}

}  // namespace braidzone
