#include "cli/separability_report.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <vector>

namespace braidzone {
namespace {

using Json = nlohmann::ordered_json;

Json number_or_null(double value)
{
    return std::isnan(value) ? Json() : Json(value);
}

std::string cell(double value)
{
    return std::isnan(value) ? "   -" : fmt::format("{:4.{}f}", value, value < 99.95 ? 1 : 0);
}

/// Effects that cannot be seen, and pairs of which either can be taken for the other.
std::string in_words(const Separability& found)
{
    std::vector<std::string> unseen, pairs;
    for (std::size_t i = 0; i < found.names.size(); ++i) {
        const auto row = static_cast<Eigen::Index>(i);
        if (found.detection[row] < least_separation) {
            unseen.push_back(found.names[i]);
            continue;
        }
        for (std::size_t j = 0; j < found.names.size(); ++j) {
            const auto column = static_cast<Eigen::Index>(j);
            if (j != i && found.separation(row, column) < least_separation)
                pairs.push_back(fmt::format("{} for {}", found.names[j], found.names[i]));
        }
    }
    return fmt::format("  cannot be seen: {}\n  could be taken: {}\n",
                       unseen.empty() ? "none" : fmt::format("{}", fmt::join(unseen, ", ")),
                       pairs.empty() ? "none" : fmt::format("{}", fmt::join(pairs, ", ")));
}

}  // namespace

Json separability_as_json(const ChannelSeparability& channels)
{
    const Separability& found = channels.separability;
    Json json = {{"channels", channels.channels}, {"effects", found.names}};
    for (Eigen::Index i = 0; i < found.detection.size(); ++i) {
        json["against_none"].push_back(number_or_null(found.detection[i]));
        Json row = Json::array();
        for (Eigen::Index j = 0; j < found.detection.size(); ++j)
            row.push_back(number_or_null(found.separation(i, j)));
        json["separation"].push_back(row);
    }
    return json;
}

std::string separability_text(const ChannelSeparability& channels)
{
    const Separability& found = channels.separability;
    std::string text =
        fmt::format("{}: d' of the effect in the row if that of the column is fitted\n  {:<31}none",
                    channels.channels, "");
    for (std::size_t j = 0; j < found.names.size(); ++j)
        text += fmt::format(" {:4}", j + 1);
    for (std::size_t i = 0; i < found.names.size(); ++i) {
        const auto row = static_cast<Eigen::Index>(i);
        text += fmt::format("\n  {:2} {:<28}{}", i + 1, found.names[i], cell(found.detection[row]));
        for (Eigen::Index j = 0; j < found.detection.size(); ++j)
            text += fmt::format(" {}", cell(found.separation(row, j)));
    }
    return text + "\n" + in_words(found);
}

}  // namespace braidzone
