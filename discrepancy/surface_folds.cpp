#include "discrepancy/surface_folds.hpp"

#include <map>
#include <utility>

namespace braidzone {
namespace {

constexpr int rows_per_block = 3;
constexpr int blocks_around = 4;

}  // namespace

std::vector<std::vector<int>> surface_folds(const DiscrepancyField& field)
{
    std::map<std::pair<int, int>, std::vector<int>> blocks;
    for (std::size_t i = 0; i < field.patches.size(); ++i) {
        const Patch& patch = field.patches[i];
        blocks[{patch.row / rows_per_block, patch.column * blocks_around / field.options.around}]
            .push_back(static_cast<int>(i));
    }
    std::vector<std::vector<int>> folds;
    for (auto& [place, block] : blocks)
        folds.push_back(std::move(block));
    return folds;
}

}  // namespace braidzone
