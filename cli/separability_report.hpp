#pragma once

#include "discrepancy/separability.hpp"

#include <nlohmann/json.hpp>

#include <string>

namespace braidzone {

/// What could be told apart with some channels of a measurement.
struct ChannelSeparability {
    std::string channels;  ///< "surface and end markers"
    Separability separability;
};

/// d' of all pairs and against no effect, as in `separability.hpp`.
nlohmann::ordered_json separability_as_json(const ChannelSeparability& channels);

/// The matrix for the terminal, rows the effect that is there, columns the one that is fitted, and
/// in words what could not be seen or told apart.
std::string separability_text(const ChannelSeparability& channels);

}  // namespace braidzone
