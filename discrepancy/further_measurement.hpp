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
    /// What the data at hand tell: d' of their evidences, sqrt(2 |ln B_i - ln B_j|).
    double now = 0.0;
    std::vector<double> added;  ///< d' of each further channel, given the data at hand

    /// d' of the data at hand and a channel together: sqrt(now^2 + added^2).
    double with(std::size_t channel) const;
};

/// Which further measurement would tell the answers of an ambiguous set apart.
struct FurtherMeasurement {
    std::vector<std::string> answers;      ///< their names
    std::vector<FurtherChannel> channels;  ///< cheapest first
    std::vector<SeparatedPair> pairs;
    /// The channel that separates most pairs (`separates`), of equals the cheapest; if none
    /// separates any, that with the greatest of the pairs' smallest d'. None without pairs or
    /// channels.
    std::optional<std::size_t> best;
};

/// True if a channel by itself brings d' = 3 (`least_separation`): what the data at hand say of
/// the pair did not decide, and may be what misleads.
bool separates(const SeparatedPair& pair, std::size_t channel);

/// The pair that a channel leaves nearest together. @pre there are pairs
const SeparatedPair& hardest_pair(const FurtherMeasurement& further, std::size_t channel);

/// Tells for each pair of answers, and each channel that was not measured, how far apart it would
/// bring them: by the noise-free data of one answer at its best fit, to which the other is fitted
/// anew, linear in its parameters about its own best fit (`linear_refit`),
///
///     d'^2(i, j) = min over the parameters of j of |L^-1 (m_i - m_j)|^2,   L L' = C
///     added^2    = d'^2 of the data at hand and the channel - d'^2 of the data at hand
///
/// as in `separability.hpp`, and of (i, j) and (j, i) the smaller. Where the channel's errors are
/// independent of the others that is
///
///     added^2 = (m_i - m_j)' (C_channel + D P_j D')^-1 (m_i - m_j)
///
/// with P_j the posterior of j's parameters by the data at hand and D the derivatives of its
/// prediction m of the channel: what a vague answer could still explain does not count. It takes
/// one simulation more than there are parameters for each answer.
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
