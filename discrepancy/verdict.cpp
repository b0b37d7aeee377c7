#include "discrepancy/verdict.hpp"

#include <algorithm>
#include <limits>

namespace braidzone {
namespace {

double score(const NamedEvidence& named)
{
    return named.log_evidence + std::max(named.log_evidence_unknown, 0.0);
}

}  // namespace

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
    const double best = score(ordered.front());
    if (best - std::max(log_evidence_unknown, 0.0) < options.margin) return verdict;
    for (const NamedEvidence& one : ordered) {
        if (best - score(one) < options.margin) verdict.effects.push_back(one.effect);
    }
    verdict.finding = verdict.effects.size() == 1 ? Finding::named : Finding::ambiguous;
    verdict.has_unexplained_rest =
        std::max(ordered.front().log_evidence_unknown, ordered.front().log_evidence_scalars) >
        options.unexplained_bar;
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
