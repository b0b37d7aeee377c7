#include "cli/further_report.hpp"

#include "discrepancy/separability.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <vector>

namespace braidzone {
namespace {

using Json = nlohmann::ordered_json;

/// True if a channel separates some pair.
bool separates(const FurtherMeasurement& further, std::size_t channel)
{
    for (const SeparatedPair& pair : further.pairs) {
        if (pair.with[channel] >= least_separation) return true;
    }
    return false;
}

}  // namespace

std::string further_text(const FurtherMeasurement& further)
{
    if (!further.best || !separates(further, *further.best)) return "";
    const std::size_t best = *further.best;
    const std::string& measurement = further.channels[best].measurement;
    if (smallest_with(further, best) >= least_separation) {
        return fmt::format("A measurement of {} would separate them (d' {:.1f} -> {:.1f}).",
                           measurement, smallest_now(further), smallest_with(further, best));
    }
    std::vector<std::string> pairs;
    for (const SeparatedPair& pair : further.pairs) {
        if (pair.with[best] < least_separation) continue;
        pairs.push_back(fmt::format("{} from {} (d' {:.1f} -> {:.1f})", further.answers[pair.first],
                                    further.answers[pair.second], pair.now, pair.with[best]));
    }
    return fmt::format("A measurement of {} would separate {}.", measurement,
                       fmt::join(pairs, ", "));
}

Json further_as_json(const FurtherMeasurement& further)
{
    Json json = {{"best", Json()}, {"channels", Json::array()}};
    if (further.pairs.empty()) return json;
    if (further.best && separates(further, *further.best))
        json["best"] = further.channels[*further.best].name;
    for (std::size_t i = 0; i < further.channels.size(); ++i) {
        Json channel = {{"name", further.channels[i].name},
                        {"measurement", further.channels[i].measurement},
                        {"smallest_now", smallest_now(further)},
                        {"smallest_with", smallest_with(further, i)}};
        for (const SeparatedPair& pair : further.pairs) {
            channel["pairs"].push_back({{"first", further.answers[pair.first]},
                                        {"second", further.answers[pair.second]},
                                        {"now", pair.now},
                                        {"with", pair.with[i]}});
        }
        json["channels"].push_back(channel);
    }
    return json;
}

std::string further_table(const FurtherMeasurement& further)
{
    if (further.pairs.empty() || further.channels.empty()) return "";
    std::string text = "  d' between the answers, the smallest, with a measurement of\n";
    for (std::size_t i = 0; i < further.channels.size(); ++i) {
        text += fmt::format("    {:<60}{:.1f} -> {:.1f}\n", further.channels[i].measurement,
                            smallest_now(further), smallest_with(further, i));
    }
    return text;
}

}  // namespace braidzone
