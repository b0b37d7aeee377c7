#pragma once

#include "discrepancy/effect_fit.hpp"

#include <optional>
#include <string>
#include <vector>

namespace braidzone {

/// Something that was not measured but could be.
struct FurtherChannel {
    std::string name;         ///< "end_markers"
    std::string measurement;  ///< for people: "both ends to 0.3 mm"
    std::vector<int> rows;    ///< its residuals, increasing
};

/// Two answers of an ambiguous set, and how well they can be told apart.
struct SeparatedPair {
    std::size_t first = 0, second = 0;  ///< indices of the answers
    double now = 0.0;                   ///< d' by the data at hand
    std::vector<double> with;           ///< d' with each further channel besides
};

/// Which further measurement would tell the answers of an ambiguous set apart.
struct FurtherMeasurement {
    std::vector<std::string> answers;      ///< their names
    std::vector<FurtherChannel> channels;  ///< cheapest first
    std::vector<SeparatedPair> pairs;
    /// The channel that separates most pairs (`least_separation`), of equals the cheapest; if none
    /// separates any, that with the greatest of the pairs' smallest d'. None without pairs or
    /// channels.
    std::optional<std::size_t> best;
};

/// The smallest d' of all pairs, now and with a channel.
double smallest_now(const FurtherMeasurement& further);
double smallest_with(const FurtherMeasurement& further, std::size_t channel);

/// Tells for each pair of answers, and each channel that was not measured, how far apart the data
/// at hand and that channel would be: the noise-free data of one answer at its best fit, to which
/// the other is fitted anew, linear in its parameters about its own best fit (`linear_refit`),
///
///     d'(i, j) = min over the parameters of j of sqrt(|L^-1 (m_i - m_j)|^2),   L L' = C
///
/// as in `separability.hpp`, and of (i, j) and (j, i) the smaller. With P_j the posterior of j's
/// parameters by the data at hand and D their derivatives of the channel's prediction m, that is
///
///     d'^2 = d'^2 now + (m_i - m_j)' (C_channel + D P_j D')^-1 (m_i - m_j)
///
/// where the channel's errors are independent of the others. It takes one simulation more than
/// there are parameters for each answer.
/// @param planned   residuals of the data at hand and of all further channels; the values that the
///                  latter are thought to have measured do not matter
/// @param measured  rows of the data at hand, increasing
/// @param channels  cheapest first
/// @param answers   fits of the answers
FurtherMeasurement further_measurement(const DiagnosisProblem& planned,
                                       const std::vector<int>& measured,
                                       std::vector<FurtherChannel> channels,
                                       const std::vector<EffectFit>& answers);

}  // namespace braidzone
