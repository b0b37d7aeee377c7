#include "discrepancy/surface_folds.hpp"

#include <algorithm>
#include <cstddef>

namespace braidzone {
namespace {

constexpr std::size_t blocks_along = 4;

}  // namespace

std::vector<std::vector<int>> surface_folds(const DiscrepancyField& field)
{
    std::vector<int> rows;
    for (const Patch& patch : field.patches)
        rows.push_back(patch.row);
    std::sort(rows.begin(), rows.end());
    std::vector<int> first_rows;  // of the blocks along the device but the first
    for (std::size_t block = 1; block < blocks_along; ++block)
        first_rows.push_back(rows[block * rows.size() / blocks_along]);
    std::vector<std::vector<int>> folds(2 * blocks_along);
    for (std::size_t i = 0; i < field.patches.size(); ++i) {
        const Patch& patch = field.patches[i];
        const auto block = static_cast<std::size_t>(
            std::upper_bound(first_rows.begin(), first_rows.end(), patch.row) - first_rows.begin());
        const std::size_t half = 2 * patch.column < field.options.around ? 0 : 1;
        folds[2 * block + half].push_back(static_cast<int>(i));
    }
    std::erase_if(folds, [](const std::vector<int>& fold) { return fold.empty(); });
    return folds;
}

}  // namespace braidzone
