#include "discrepancy/further_measurement.hpp"

#include "discrepancy/linear_refit.hpp"
#include "discrepancy/separability.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace braidzone {
namespace {

/// What an answer predicts for all rows, up to what was measured.
struct Predicted {
    Eigen::VectorXd residuals, x;
    Eigen::MatrixXd derivatives;
    std::vector<EffectParameter> parameters;
};

/// None if the answer cannot be simulated.
std::optional<Predicted> predicted(const DiagnosisProblem& planned, const EffectFit& answer)
{
    std::vector<std::size_t> candidates;
    for (const FittedEffect& effect : answer.effects)
        candidates.push_back(effect.candidate);
    EffectResiduals residuals(planned, candidates);
    const auto found = residuals.with_derivatives(answer.x);
    if (!found) return std::nullopt;
    return Predicted{found->first, answer.x, found->second, parameters_of(answer)};
}

/// d'^2 of the data of one answer when the other is fitted to them.
double left_by(const Predicted& there, const Predicted& fitted, const Whitening& whitening,
               const std::vector<int>& rows)
{
    const Eigen::VectorXd apart = (fitted.residuals - there.residuals)(rows);
    const Eigen::MatrixXd slope = fitted.derivatives(rows, Eigen::all);
    return linear_refit(whitening(apart), whitening.of_columns(slope), fitted.x, fitted.parameters)
        .whitened.squaredNorm();
}

/// Whitening of some rows, for d' of pairs.
struct RowsWhitening {
    std::vector<int> rows;
    Whitening whitening;

    RowsWhitening(const DiagnosisProblem& planned, std::vector<int> chosen)
        : rows(std::move(chosen)), whitening(planned.covariance(rows, rows))
    {
    }
};

/// d' that a channel adds when one answer is fitted to the data of another.
double added_by(const RowsWhitening& at_hand, const RowsWhitening& with, const Predicted& there,
                const Predicted& fitted)
{
    const double square = left_by(there, fitted, with.whitening, with.rows) -
                          left_by(there, fitted, at_hand.whitening, at_hand.rows);
    return std::sqrt(std::max(0.0, square));
}

std::vector<int> joined(const std::vector<int>& a, const std::vector<int>& b)
{
    std::vector<int> both;
    std::merge(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(both));
    return both;
}

std::size_t num_separated(const FurtherMeasurement& further, std::size_t channel)
{
    return static_cast<std::size_t>(
        std::count_if(further.pairs.begin(), further.pairs.end(),
                      [&](const SeparatedPair& pair) { return separates(pair, channel); }));
}

std::optional<std::size_t> best_channel(const FurtherMeasurement& further)
{
    if (further.pairs.empty() || further.channels.empty()) return std::nullopt;
    std::size_t best = 0;
    for (std::size_t i = 1; i < further.channels.size(); ++i) {
        const std::size_t here = num_separated(further, i), most = num_separated(further, best);
        const bool is_nearer =
            here == 0 && most == 0 &&
            hardest_pair(further, i).added[i] > hardest_pair(further, best).added[best];
        if (here > most || is_nearer) best = i;
    }
    return best;
}

}  // namespace

double SeparatedPair::with(std::size_t channel) const
{
    return std::hypot(now, added[channel]);
}

bool separates(const SeparatedPair& pair, std::size_t channel)
{
    return pair.added[channel] >= least_separation;
}

const SeparatedPair& hardest_pair(const FurtherMeasurement& further, std::size_t channel)
{
    return *std::min_element(further.pairs.begin(), further.pairs.end(),
                             [&](const SeparatedPair& a, const SeparatedPair& b) {
                                 return a.added[channel] < b.added[channel];
                             });
}

FurtherMeasurement further_measurement(const DiagnosisProblem& planned,
                                       const std::vector<int>& measured,
                                       std::vector<FurtherChannel> channels,
                                       const std::vector<EffectFit>& answers)
{
    FurtherMeasurement further;
    for (const EffectFit& answer : answers)
        further.answers.push_back(name_of(answer));
    std::vector<std::optional<Predicted>> all(answers.size());
    tbb::parallel_for(std::size_t{0}, all.size(),
                      [&](std::size_t i) { all[i] = predicted(planned, answers[i]); });
    const RowsWhitening at_hand(planned, measured);
    std::vector<RowsWhitening> with;
    for (const FurtherChannel& channel : channels)
        with.emplace_back(planned, joined(measured, channel.rows));
    for (std::size_t i = 0; i < all.size(); ++i) {
        for (std::size_t j = i + 1; j < all.size(); ++j) {
            if (!all[i] || !all[j]) continue;
            const double evidence = answers[i].log_evidence - answers[j].log_evidence;
            SeparatedPair pair{i, j, std::sqrt(2.0 * std::abs(evidence)), {}};
            for (const RowsWhitening& channel : with) {
                pair.added.push_back(std::min(added_by(at_hand, channel, *all[i], *all[j]),
                                              added_by(at_hand, channel, *all[j], *all[i])));
            }
            further.pairs.push_back(std::move(pair));
        }
    }
    further.channels = std::move(channels);
    further.best = best_channel(further);
    return further;
}

}  // namespace braidzone
