#pragma once

#include "discrepancy/further_measurement.hpp"

#include <nlohmann/json.hpp>

#include <string>

namespace braidzone {

/// "A measurement of both ends to 0.3 mm would separate them (d' 1.2 -> 5.2).", of the pair that is
/// hardest to tell apart; with pairs named where it separates some of them only; or that none of
/// the measurements that could be added would. Empty if there is nothing to separate.
std::string further_text(const FurtherMeasurement& further);

/// d' of each pair of answers, now and with each channel; `best` is the name of the channel that
/// `further_text` recommends, null for none.
nlohmann::ordered_json further_as_json(const FurtherMeasurement& further);

/// One line a channel for the terminal, with d' of the pair it leaves nearest
/// together. Empty without pairs.
std::string further_table(const FurtherMeasurement& further);

}  // namespace braidzone
