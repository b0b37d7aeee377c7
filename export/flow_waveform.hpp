#pragma once

#include <filesystem>
#include <optional>
#include <vector>

namespace braidzone {

/// One period of a flow rate; linear between its points.
struct FlowWaveform {
    std::filesystem::path file;      ///< that it was read from
    std::vector<double> times;       ///< increasing, from 0 to the period [s]
    std::vector<double> flow_rates;  ///< into the vessel; the last is the first [m^3/s]
    std::optional<double> scaled_to =
        {};  ///< mean that the file's flow rates are scaled to [m^3/s]
};

/// Reads a waveform from a CSV file of two columns with a header.
///
/// The header names the quantities with their units: `time_s` (or `time_ms`) and `flow_rate_mL_s`
/// (or `flow_rate_mL_min`, `flow_rate_m3_s`). Times increase from 0; the last flow rate is the
/// first one (within 1e-6 of the largest), as the flow repeats. Negative values are flow back out
/// of the inlet.
///
/// @throws IoError if the file cannot be read; InputError, with the line, for anything else than
///         such a table, fewer than three points, or a mean that is not positive
FlowWaveform read_flow_waveform(const std::filesystem::path& path);

/// The time after which the flow repeats [s].
double period(const FlowWaveform& waveform);

/// The mean flow rate over the period [m^3/s].
double mean_flow_rate(const FlowWaveform& waveform);

/// The same waveform with another mean.
/// @param mean  [m^3/s]; > 0
FlowWaveform scaled_to_mean(FlowWaveform waveform, double mean);

}  // namespace braidzone
