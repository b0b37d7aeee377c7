#pragma once

#include "verification/unit_cell/braid_cell.hpp"

#include <array>
#include <numbers>
#include <vector>

namespace braidzone::test {

/// Spacing of the wires on the finest grid of the table of slow flow, for each solidity in it.
struct TableResolution {
    double solidity = 0.0;
    double spacing_lu = 0.0;
};

inline constexpr std::array<TableResolution, 6> table_resolutions{
    {{0.10, 64.0}, {0.14, 56.0}, {0.176, 56.0}, {0.22, 56.0}, {0.30, 56.0}, {0.40, 45.0}}};

/// The three grids of a braid in the table, from coarse to fine: each has 1 / sqrt(2) of the cells
/// of the next one along a line. The box is two spacings of the wires high, which leaves 0.1 % of
/// the loss to the images of the braid above and below.
inline std::vector<BraidCell> table_grids(const Braid& braid, double finest_spacing_lu)
{
    std::vector<BraidCell> grids;
    for (const double coarsening : {2.0, std::numbers::sqrt2, 1.0}) {
        grids.push_back(
            make_braid_cell(braid, braid.solidity * finest_spacing_lu / coarsening, 2.0));
    }
    return grids;
}

}  // namespace braidzone::test
