#pragma once

#include "discrepancy/further_measurement.hpp"

#include <nlohmann/json.hpp>

#include <string>

namespace braidzone {

/// "A measurement of both ends to 0.3 mm would separate them (d' 1.2 -> 5.2)."; with pairs named
/// where it separates some of them only. Empty if no channel separates any, or there is nothing to
/// separate.
std::string further_text(const FurtherMeasurement& further);

/// d' of each pair of answers, now and with each channel; `best` is the name of the channel in
/// `further_text`, else null.
nlohmann::ordered_json further_as_json(const FurtherMeasurement& further);

/// One line a channel for the terminal, with the smallest d' of all pairs. Empty without pairs.
std::string further_table(const FurtherMeasurement& further);

}  // namespace braidzone
