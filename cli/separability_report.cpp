#include "cli/separability_report.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <optional>
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

/// Two effects, or an effect and none, that the first channels do not tell apart.
struct Gain {
    std::string first, second;
    double from = 0.0, to = 0.0;
    std::size_t channels = 0;  ///< index of those that d' is `to` with
};

/// The first channels by which all of some effects are seen; none if there are no such channels.
std::optional<std::size_t> first_seen(const std::vector<ChannelSeparability>& all,
                                      const std::vector<Eigen::Index>& effects)
{
    for (std::size_t i = 0; i < all.size(); ++i) {
        if (std::all_of(effects.begin(), effects.end(), [&](Eigen::Index effect) {
                return all[i].separability.detection[effect] >= least_separation;
            }))
            return i;
    }
    return std::nullopt;
}

/// From some channels on: the cheapest that separate two, or those with the greatest d'.
template <typename Separation>
void add_gain(std::vector<Gain>& gains, const std::vector<ChannelSeparability>& all,
              std::size_t first, Gain gain, const Separation& separation)
{
    gain.channels = first;
    gain.from = separation(all[first].separability);
    if (!(gain.from < least_separation)) return;
    gain.to = gain.from;
    for (std::size_t i = first + 1; i < all.size() && gain.to < least_separation; ++i) {
        const double here = separation(all[i].separability);
        if (!(here > gain.to)) continue;
        gain.to = here;
        gain.channels = i;
    }
    gains.push_back(gain);
}

std::vector<Gain> gains_of(const std::vector<ChannelSeparability>& all)
{
    const std::vector<std::string>& names = all.front().separability.names;
    const auto count = static_cast<Eigen::Index>(names.size());
    const auto name = [&](Eigen::Index i) { return names[static_cast<std::size_t>(i)]; };
    std::vector<Gain> gains;
    for (Eigen::Index i = 0; i < count; ++i) {
        add_gain(gains, all, 0, {name(i), "none"},
                 [&](const Separability& found) { return found.detection[i]; });
    }
    for (Eigen::Index i = 0; i < count; ++i) {
        for (Eigen::Index j = i + 1; j < count; ++j) {
            const std::optional<std::size_t> first = first_seen(all, {i, j});
            if (!first) continue;
            add_gain(gains, all, *first, {name(i), name(j)}, [&](const Separability& found) {
                return std::min(found.separation(i, j), found.separation(j, i));
            });
        }
    }
    return gains;
}

bool is_separated(const Gain& gain)
{
    return gain.to >= least_separation;
}

/// Those of the gains that fulfil a condition: "a / b (1.2 -> 5.2), ...".
template <typename Condition>
std::string gains_line(const std::vector<Gain>& gains, const std::string& title,
                       const Condition& condition)
{
    std::vector<std::string> texts;
    for (const Gain& gain : gains) {
        if (!condition(gain)) continue;
        texts.push_back(
            fmt::format("{} / {} ({:.1f} -> {:.1f})", gain.first, gain.second, gain.from, gain.to));
    }
    if (texts.empty()) return "";
    return fmt::format("  {}: {}\n", title, fmt::join(texts, ", "));
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

Json gains_as_json(const std::vector<ChannelSeparability>& all)
{
    Json json = Json::array();
    for (const Gain& gain : gains_of(all)) {
        json.push_back({{"first", gain.first},
                        {"second", gain.second},
                        {"from", gain.from},
                        {"to", gain.to},
                        {"channels", all[gain.channels].channels},
                        {"is_separated", is_separated(gain)}});
    }
    return json;
}

std::string gains_text(const std::vector<ChannelSeparability>& all)
{
    const std::vector<Gain> gains = gains_of(all);
    std::string text = fmt::format(
        "d' of what cannot be seen or told apart by the {}, with the cheapest measurement by which "
        "it can\n",
        all.front().channels);
    for (std::size_t i = 1; i < all.size(); ++i) {
        text += gains_line(gains, all[i].added, [&](const Gain& gain) {
            return is_separated(gain) && gain.channels == i;
        });
    }
    return text +
           gains_line(gains, "none of these", [](const Gain& gain) { return !is_separated(gain); });
}

}  // namespace braidzone
