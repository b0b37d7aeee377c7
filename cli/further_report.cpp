#include "cli/further_report.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <vector>

namespace braidzone {
namespace {

using Json = nlohmann::ordered_json;

bool separates_some(const FurtherMeasurement& further, std::size_t channel)
{
    return std::any_of(further.pairs.begin(), further.pairs.end(),
                       [&](const SeparatedPair& pair) { return separates(pair, channel); });
}

/// "d' 1.2 -> 5.2"
std::string gain_text(const SeparatedPair& pair, std::size_t channel)
{
    return fmt::format("d' {:.1f} -> {:.1f}", pair.now, pair.with(channel));
}

}  // namespace

std::string further_text(const FurtherMeasurement& further)
{
    if (!further.best) return "";
    const std::size_t best = *further.best;
    const std::string& measurement = further.channels[best].measurement;
    const SeparatedPair& hardest = hardest_pair(further, best);
    if (separates(hardest, best)) {
        return fmt::format("A measurement of {} would separate them ({}).", measurement,
                           gain_text(hardest, best));
    }
    std::vector<std::string> pairs;
    for (const SeparatedPair& pair : further.pairs) {
        if (!separates(pair, best)) continue;
        pairs.push_back(fmt::format("{} from {} ({})", further.answers[pair.first],
                                    further.answers[pair.second], gain_text(pair, best)));
    }
    if (!pairs.empty()) {
        return fmt::format("A measurement of {} would separate {}.", measurement,
                           fmt::join(pairs, ", "));
    }
    return fmt::format(
        "None of the measurements that could be added would separate them; the best, of {}, would "
        "bring d' {:.1f} -> {:.1f}.",
        measurement, hardest.now, hardest.with(best));
}

Json further_as_json(const FurtherMeasurement& further)
{
    Json json = {{"best", Json()}, {"channels", Json::array()}};
    if (further.pairs.empty()) return json;
    if (further.best && separates_some(further, *further.best))
        json["best"] = further.channels[*further.best].name;
    for (std::size_t i = 0; i < further.channels.size(); ++i) {
        Json channel = {{"name", further.channels[i].name},
                        {"measurement", further.channels[i].measurement}};
        for (const SeparatedPair& pair : further.pairs) {
            channel["pairs"].push_back({{"first", further.answers[pair.first]},
                                        {"second", further.answers[pair.second]},
                                        {"now", pair.now},
                                        {"with", pair.with(i)},
                                        {"is_separated", separates(pair, i)}});
        }
        json["channels"].push_back(channel);
    }
    return json;
}

std::string further_table(const FurtherMeasurement& further)
{
    if (further.pairs.empty() || further.channels.empty()) return "";
    std::string text =
        "  what would separate the answers, of the two that are hardest to tell apart\n";
    for (std::size_t i = 0; i < further.channels.size(); ++i) {
        text += fmt::format("    {:<60}{}\n", further.channels[i].measurement,
                            gain_text(hardest_pair(further, i), i));
    }
    return text;
}

}  // namespace braidzone
