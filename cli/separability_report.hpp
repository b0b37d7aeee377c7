#pragma once

#include "discrepancy/separability.hpp"

#include <nlohmann/json.hpp>

#include <string>
#include <vector>

namespace braidzone {

/// What could be told apart with some channels of a measurement.
struct ChannelSeparability {
    std::string channels;  ///< "surface and end markers"
    Separability separability;
    std::string added = {};  ///< "both ends to 0.3 mm": what it has over those before it
};

/// d' of all pairs and against no effect, as in `separability.hpp`.
nlohmann::ordered_json separability_as_json(const ChannelSeparability& channels);

/// The matrix for the terminal, rows the effect that is there, columns the one that is fitted, and
/// in words what could not be seen or told apart.
std::string separability_text(const ChannelSeparability& channels);

/// What cannot be seen by the first channels (d' < 3 against "none"), with the cheapest channels by
/// which it can; and pairs that cannot be told apart (d' < 3, the smaller of both directions) by
/// the first channels that show both, with the cheapest by which they can. Where no channels reach
/// 3, those of the greatest d'.
/// @param all  cheapest first, at least one
nlohmann::ordered_json gains_as_json(const std::vector<ChannelSeparability>& all);

/// The same for the terminal, one line a channel.
std::string gains_text(const std::vector<ChannelSeparability>& all);

}  // namespace braidzone
