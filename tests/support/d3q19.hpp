#pragma once

#include <array>
#include <cstddef>

/// The D3Q19 velocities: rest, then nine pairs of opposite ones. Those of pair k have the indices
/// 2 k + 1 and 2 k + 2.
namespace braidzone::test::d3q19 {

constexpr int num_velocities = 19;
constexpr std::size_t num_pairs = 9;

constexpr std::array<std::array<int, 3>, num_velocities> velocity{{
    {0, 0, 0},  {1, 0, 0},   {-1, 0, 0},  {0, 1, 0},  {0, -1, 0}, {0, 0, 1},   {0, 0, -1},
    {1, 1, 0},  {-1, -1, 0}, {1, -1, 0},  {-1, 1, 0}, {1, 0, 1},  {-1, 0, -1}, {1, 0, -1},
    {-1, 0, 1}, {0, 1, 1},   {0, -1, -1}, {0, 1, -1}, {0, -1, 1},
}};

constexpr int opposite(int i)
{
    if (i == 0) return 0;
    return i % 2 == 1 ? i + 1 : i - 1;
}

constexpr float rest_weight = 1.0F / 3.0F;

constexpr float pair_weight(std::size_t pair)
{
    return pair < 3 ? 1.0F / 18.0F : 1.0F / 36.0F;
}

constexpr float weight(int i)
{
    return i == 0 ? rest_weight : pair_weight(static_cast<std::size_t>(i - 1) / 2);
}

/// The neighbour of a cell along velocity i.
constexpr std::array<int, 3> moved(const std::array<int, 3>& cell, int i)
{
    const auto& c = velocity[static_cast<std::size_t>(i)];
    return {cell[0] + c[0], cell[1] + c[1], cell[2] + c[2]};
}

}  // namespace braidzone::test::d3q19
