#include "discrepancy/verdict.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace braidzone {
namespace {

double score(const NamedEvidence& named)
{
    return named.log_evidence + named.log_prior +
           std::max(named.log_evidence_unknown - named.unknown_price, 0.0);
}

/// True if the other answer has all effects of one, and more.
bool is_part_of(const Answer& one, const Answer& other)
{
    return one.effects.size() < other.effects.size() &&
           std::all_of(one.effects.begin(), one.effects.end(), [&](const std::string& effect) {
               return std::find(other.effects.begin(), other.effects.end(), effect) !=
                      other.effects.end();
           });
}

}  // namespace

VerdictOptions for_choice_among(std::size_t num_candidates, const VerdictOptions& options)
{
    VerdictOptions result = options;
    const double choice = std::log(std::max(1.0, static_cast<double>(num_candidates)));
    result.effect_bar += choice;
    result.unknown_margin += choice;
    return result;
}

Verdict decide(const std::vector<NamedEvidence>& named, double log_evidence_unknown,
               double log_evidence_scalars, const VerdictOptions& options)
{
    std::vector<NamedEvidence> ordered = named;
    std::stable_sort(
        ordered.begin(), ordered.end(),
        [](const NamedEvidence& a, const NamedEvidence& b) { return score(a) > score(b); });
    double best_evidence = -std::numeric_limits<double>::infinity();
    for (const NamedEvidence& one : named)
        best_evidence = std::max(best_evidence, one.log_evidence);
    Verdict verdict;
    if (best_evidence < options.effect_bar &&
        std::max(log_evidence_unknown, log_evidence_scalars) < options.unknown_bar)
        return verdict;
    verdict.finding = Finding::unknown;
    if (ordered.empty()) return verdict;
    const bool in_scalars_only =
        best_evidence < options.effect_bar && log_evidence_unknown < options.unknown_bar;
    double best = score(ordered.front());
    const double unknown =
        std::max(in_scalars_only ? log_evidence_scalars : log_evidence_unknown, 0.0);
    const bool beside_unknown =
        in_scalars_only ||
        best - unknown < (options.offers_unknown ? options.unknown_margin : options.margin);
    if (beside_unknown) {
        // Those that need no unknown effect to explain about as much.
        const double lack = std::max(options.margin, options.unknown_share * unknown);
        const double least = std::max(in_scalars_only ? 0.0 : options.effect_bar, unknown - lack);
        std::erase_if(ordered, [&](const NamedEvidence& one) {
            return !options.offers_unknown || one.log_evidence < least;
        });
        if (ordered.empty()) return verdict;
        best = score(ordered.front());
        verdict.unknown_lead = unknown - best;
    }
    std::vector<Answer> near;
    for (const NamedEvidence& one : ordered) {
        if (best - score(one) < options.margin) near.push_back({one.effects, one.fit});
    }
    for (const Answer& answer : near) {
        if (std::none_of(near.begin(), near.end(),
                         [&](const Answer& other) { return is_part_of(answer, other); }))
            verdict.answers.push_back(answer);
    }
    verdict.finding =
        verdict.answers.size() == 1 && !beside_unknown ? Finding::named : Finding::ambiguous;
    const NamedEvidence& first = *std::find_if(
        ordered.begin(), ordered.end(),
        [&](const NamedEvidence& one) { return one.effects == verdict.answers.front().effects; });
    verdict.has_unexplained_rest =
        std::max(first.log_evidence_unknown, first.log_evidence_scalars) > options.unexplained_bar;
    return verdict;
}

std::string name_of(Finding finding)
{
    switch (finding) {
        case Finding::nothing_missing:
            return "nothing_missing";
        case Finding::named:
            return "named";
        case Finding::ambiguous:
            return "ambiguous";
        case Finding::unknown:
            return "unknown";
    }
    return "";
}

}  // namespace braidzone
