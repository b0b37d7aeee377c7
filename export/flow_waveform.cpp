#include "export/flow_waveform.hpp"

#include "core/csv_fields.hpp"
#include "core/csv_reader.hpp"
#include "core/error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

namespace braidzone {

namespace {

constexpr std::size_t fewest_points = 3;
/// Slower than any heart or bench [s], and twice the aorta's peak flow [m^3/s].
constexpr double longest_period = 1e3;
constexpr double largest_flow_rate = 1e-3;
constexpr double closing_tolerance = 1e-6;  // of the largest flow rate

/// SI value of the unit that a column's name ends with; none if it is no such column.
std::optional<double> unit_of(std::string_view column,
                              std::initializer_list<std::pair<std::string_view, double>> names)
{
    for (const auto& [name, value] : names) {
        if (column == name) return value;
    }
    return std::nullopt;
}

struct Units {
    double time = 1.0;
    double flow_rate = 1.0;
};

std::optional<Units> units_in(std::string_view header)
{
    const auto columns = csv_fields(header);
    if (columns.size() != 2) return std::nullopt;
    const auto time = unit_of(columns[0], {{"time_s", 1.0}, {"time_ms", 1e-3}});
    const auto flow_rate = unit_of(columns[1], {{"flow_rate_m3_s", 1.0},
                                                {"flow_rate_mL_s", 1e-6},
                                                {"flow_rate_ml_s", 1e-6},
                                                {"flow_rate_mL_min", 1e-6 / 60.0},
                                                {"flow_rate_ml_min", 1e-6 / 60.0}});
    if (!time || !flow_rate) return std::nullopt;
    return Units{*time, *flow_rate};
}

}  // namespace

FlowWaveform read_flow_waveform(const std::filesystem::path& path)
{
    CsvReader file(path);
    const std::optional<Units> units = units_in(file.header());
    if (!units) {
        throw file.refusal(
            fmt::format("\"{}\" is not the header of a flow waveform; expected is "
                        "time_s,flow_rate_mL_s (or time_ms; flow_rate_mL_min, "
                        "flow_rate_m3_s)",
                        file.header()));
    }
    FlowWaveform waveform;
    waveform.file = path;
    int last_line = 1;
    while (const auto line = file.next()) {
        if (line->find_first_not_of(" \t") == std::string::npos) continue;
        const auto fields = csv_fields(*line);
        const auto time = csv_number(fields[0]);
        const auto flow_rate = csv_number(fields.back());
        if (fields.size() != 2 || !time || !flow_rate) {
            throw file.refusal(
                fmt::format("\"{}\" is not a point of the waveform; expected are "
                            "two numbers with a comma between",
                            *line));
        }
        if (waveform.times.empty() && *time != 0.0)
            throw file.refusal(fmt::format("the first time is {}; it must be 0", *time));
        const double seconds = units->time * *time;
        if (!waveform.times.empty() && !(seconds > waveform.times.back())) {
            throw file.refusal(fmt::format("time {} follows {}; times must increase", *time,
                                           waveform.times.back() / units->time));
        }
        if (!(seconds <= longest_period) ||
            !(std::abs(units->flow_rate * *flow_rate) <= largest_flow_rate)) {
            throw file.refusal(
                fmt::format("time {} with flow rate {} is no point of a heartbeat; allowed are up "
                            "to {} s and {} m^3/s",
                            *time, *flow_rate, longest_period, largest_flow_rate));
        }
        waveform.times.push_back(seconds);
        waveform.flow_rates.push_back(units->flow_rate * *flow_rate);
        last_line = file.line_number();
    }
    if (waveform.times.size() < fewest_points) {
        throw file.refusal(last_line,
                           fmt::format("the waveform has {} points; at least {} are expected",
                                       waveform.times.size(), fewest_points));
    }
    double largest = 0.0;
    for (const double flow_rate : waveform.flow_rates)
        largest = std::max(largest, std::abs(flow_rate));
    double& first = waveform.flow_rates.front();
    if (!(std::abs(waveform.flow_rates.back() - first) <= closing_tolerance * largest)) {
        throw file.refusal(
            last_line,
            fmt::format("the last flow rate is {:.6g} and the first {:.6g}; the flow "
                        "repeats, and the last point must close the period",
                        waveform.flow_rates.back() / units->flow_rate, first / units->flow_rate));
    }
    waveform.flow_rates.back() = first;
    if (const double mean = mean_flow_rate(waveform); !(mean > 0.0)) {
        throw InputError(
            fmt::format("{}: the mean flow rate is {:.6g} m^3/s; it must be positive: flow enters "
                        "at the inlet",
                        path.string(), mean));
    }
    return waveform;
}

double period(const FlowWaveform& waveform)
{
    return waveform.times.back();
}

double mean_flow_rate(const FlowWaveform& waveform)
{
    double integral = 0.0;
    for (std::size_t i = 1; i < waveform.times.size(); ++i) {
        integral += 0.5 * (waveform.flow_rates[i - 1] + waveform.flow_rates[i]) *
                    (waveform.times[i] - waveform.times[i - 1]);
    }
    return integral / period(waveform);
}

FlowWaveform scaled_to_mean(FlowWaveform waveform, double mean)
{
    const double factor = mean / mean_flow_rate(waveform);
    for (double& flow_rate : waveform.flow_rates)
        flow_rate *= factor;
    waveform.scaled_to = mean;
    return waveform;
}

}  // namespace braidzone
