#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace braidzone {

/// Evidence for one known effect, or several together; natural logarithms of Bayes factors.
struct NamedEvidence {
    std::vector<std::string> effects;
    double log_evidence = 0.0;          ///< against no effect
    double log_evidence_unknown = 0.0;  ///< of an unknown effect besides, against the named alone
    double log_evidence_scalars = 0.0;  ///< the same of scalars off by something unknown
    std::size_t fit = 0;                ///< index of its fit
    double log_prior = 0.0;      ///< of several effects against one, for the choice among many
    double unknown_price = 0.0;  ///< what an unknown effect besides must gain to count
};

/// Bars of the decision.
struct VerdictOptions {
    /// Named effect against none; `effect_bar` adds what the choice among many costs.
    double effect_bar = 3.0;
    double unknown_bar = 3.4;      ///< unknown effect against none: 99 % of a prototype's runs
    double unexplained_bar = 0.0;  ///< unknown effect beside a named one: more probable than none
    double margin = 3.0;           ///< Bayes factor of 20: less does not decide
    /// An unknown effect that is not clearly worse than the best answer stands beside it in a set,
    /// instead of being the answer. Clearly: by `unknown_margin`, to which the choice among many
    /// adds as well.
    bool offers_unknown = false;
    double unknown_margin = 3.0;
    /// Share of an unknown effect's ln B that may be lacking to such a known one: its shape may be
    /// wrong by as much.
    double unknown_share = 0.1;
};

/// The options with ln n more on the bar of a named effect and on `unknown_margin`: the best of n
/// Bayes factors must reach 20 once it is divided by the number of candidates it was chosen from.
VerdictOptions for_choice_among(std::size_t num_candidates, const VerdictOptions& options);

enum class Finding {
    nothing_missing,
    named,      ///< one effect, or several together
    ambiguous,  ///< one of several answers, which the data do not tell apart
    unknown,    ///< something, but none of the known effects
};

/// "nothing_missing", "named", "ambiguous" or "unknown".
std::string name_of(Finding finding);

/// One effect, or several that are missing together.
struct Answer {
    std::vector<std::string> effects;
    std::size_t fit = 0;  ///< index of its fit
};

struct Verdict {
    Finding finding = Finding::nothing_missing;
    /// What explains the data about equally well, best first; empty unless named or ambiguous.
    std::vector<Answer> answers;
    /// A structured gap remains that the best answer does not explain.
    bool has_unexplained_rest = false;
    /// Score of an unknown effect over that of the best answer, if it is one of the set.
    std::optional<double> unknown_lead = {};
};

/// Decides between no effect, the known effects (each alone, and sets of them), an unknown effect,
/// and known with unknown ones.
///
///     score_k = ln B_k + max(ln B_(U|k) - price, 0) + ln prior_k,
///     margin = max_k score_k - max(ln B_U, 0)
///
/// Nothing is missing if the best ln B_k, ln B_U and that of scalars that are off by something
/// unknown are below their bars; the effect is unknown if the margin is less than 3; else all
/// within 3 of the best score are the answers, but for those whose effects are all in another of
/// them: what was added to them was found to be missing. Equal scores keep the given order.
///
/// With `offers_unknown`, where the margin is less than `unknown_margin`, those known effects are
/// answers beside an unknown one whose own ln B_k reaches its bar and is no more than 3, or a
/// tenth, below ln B_U. Where single numbers alone tell that something is missing, an end that is
/// off, ln B of the scalars stands in the place of ln B_U, and that bar falls to 0: it is what a
/// choice among many costs, which the scalars' own bar is free of.
Verdict decide(const std::vector<NamedEvidence>& named, double log_evidence_unknown,
               double log_evidence_scalars = 0.0, const VerdictOptions& options = {});

}  // namespace braidzone
