#pragma once

#include "core/vector.hpp"

#include <array>
#include <cstddef>

namespace braidzone::test {

/// A box of lattice cells, unit spacing, that repeats itself: point x is the same as
/// x + (nx, 0, 0), x + (shift, ny, 0) and x + (0, 0, nz). With a shift of nx / 2 it holds one of
/// the two points of a centred rectangular pattern of nx x 2 ny cells.
///
/// Arrays over its cells have a layer of ghost cells around them.
struct PeriodicBox {
    std::array<int, 3> dims{1, 1, 1};
    int shift = 0;

    /// The cell of the box, coordinates 0 ... dims - 1, that a cell up to one box away is.
    std::array<int, 3> wrapped(std::array<int, 3> cell) const
    {
        const auto modulo = [](int value, int n) { return ((value % n) + n) % n; };
        const int row = modulo(cell[1], dims[1]);
        const int rows_up = (cell[1] - row) / dims[1];
        return {modulo(cell[0] - rows_up * shift, dims[0]), row, modulo(cell[2], dims[2])};
    }

    /// Place of a cell in an array with ghost cells, coordinates -1 ... dims.
    std::ptrdiff_t index(const std::array<int, 3>& cell) const
    {
        return cell[0] + 1 + row_stride() * (cell[1] + 1) + plane_stride() * (cell[2] + 1);
    }
    std::ptrdiff_t row_stride() const { return dims[0] + 2; }
    std::ptrdiff_t plane_stride() const { return row_stride() * (dims[1] + 2); }
    std::ptrdiff_t array_size() const { return plane_stride() * (dims[2] + 2); }

    /// Visits the cells of the box in the order of their index.
    template <typename Visit>
    void for_each_cell(Visit visit) const
    {
        for (int z = 0; z < dims[2]; ++z) {
            for (int y = 0; y < dims[1]; ++y) {
                for (int x = 0; x < dims[0]; ++x)
                    visit(std::array<int, 3>{x, y, z});
            }
        }
    }

    double num_cells() const { return 1.0 * dims[0] * dims[1] * dims[2]; }

    /// Vector from a point to its image (i, j, k) boxes away.
    Vec3 image(int i, int j, int k) const
    {
        return Vec3(i * dims[0] + j * shift, j * dims[1], k * dims[2]);
    }
};

}  // namespace braidzone::test
