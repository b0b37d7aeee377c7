#include "core/nearest_name.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace braidzone {

int edit_distance(const std::string& a, const std::string& b)
{
    const std::size_t rows = a.size() + 1, columns = b.size() + 1;
    // distance[i][j]: between the first i letters of a and the first j of b.
    std::vector<std::vector<int>> distance(rows, std::vector<int>(columns));
    for (std::size_t i = 0; i < rows; ++i)
        distance[i][0] = static_cast<int>(i);
    for (std::size_t j = 0; j < columns; ++j)
        distance[0][j] = static_cast<int>(j);
    for (std::size_t i = 1; i < rows; ++i) {
        for (std::size_t j = 1; j < columns; ++j) {
            const int replace = distance[i - 1][j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
            distance[i][j] = std::min({replace, distance[i - 1][j] + 1, distance[i][j - 1] + 1});
            if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1]) {
                distance[i][j] = std::min(distance[i][j], distance[i - 2][j - 2] + 1);
            }
        }
    }
    return distance[a.size()][b.size()];
}

std::string did_you_mean(const std::string& name, const std::vector<std::string>& known)
{
    if (known.empty()) return {};
    const auto nearest = std::min_element(
        known.begin(), known.end(), [&](const std::string& first, const std::string& second) {
            return edit_distance(name, first) < edit_distance(name, second);
        });
    const int near_enough = std::max(1, static_cast<int>(nearest->size()) / 3);
    if (edit_distance(name, *nearest) <= near_enough) {
        return fmt::format("; did you mean \"{}\"?", *nearest);
    }
    return fmt::format("; known are {}", fmt::join(known, ", "));
}

}  // namespace braidzone
