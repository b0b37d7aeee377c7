#pragma once

#include "discrepancy/blind/answer.hpp"

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace braidzone::blind {

/// A case's truth beside what was answered.
struct ScoredCase {
    CaseTruth truth;
    Answer answer;
};

/// How many of how many.
struct Rate {
    int count = 0;
    int of = 0;
    void add(bool yes)
    {
        count += yes ? 1 : 0;
        ++of;
    }
};

/// Bounds that hold a binomial probability with 95 % (Clopper and Pearson 1934, Biometrika 26:404):
/// quantiles of beta distributions; 0 and 1 for an empty sample.
struct Bounds {
    double lower = 0.0, upper = 1.0;
};
Bounds clopper_pearson(const Rate& rate);

/// What an answer says first: "none", "unknown", "error", an effect's name, or several joined by
/// "+".
std::string first_answer(const Answer& answer);

/// What is true: "none", the effect's name, or several joined by "+" in the order of the alphabet.
std::string label_of(const CaseTruth& truth);

/// Scores of single effects of the catalogue.
struct SingleScore {
    Rate detected;                        ///< anything but "nothing missing"
    Rate first;                           ///< right name first, among the detected
    Rate first_of_named;                  ///< the same, among those that got a name
    Rate in_set;                          ///< truth among the alternatives, among the detected
    Rate among_names;                     ///< the same, alone or with another effect beside it
    std::vector<double> location_errors;  ///< of rightly named effects with a centre [m]
    Rate covered;  ///< parameters within 90 % intervals, mean +- 1.645 sd, of rightly named effects
    std::vector<double> rms_before, rms_after, rms_oracle;  ///< of the detected [m]
};

struct PairScore {
    Rate both;    ///< first answer: just these two
    Rate one;     ///< first answer: at least one right, none wrong
    Rate wrong;   ///< first answer holds a wrong effect
    Rate in_set;  ///< just these two among the alternatives
};

/// Where classes of detectability d' end: hidden; near the limit of 3.4 (`detectability.hpp`);
/// faint; plain.
inline constexpr std::array<double, 3> detectability_bounds = {3.0, 4.0, 6.0};

struct Score {
    std::map<std::string, SingleScore> singles;  ///< by effect
    SingleScore all_singles;
    std::map<std::string, SingleScore> by_size;
    Rate false_alarm;         ///< of cases without an effect
    Rate wrong_without_flag;  ///< of cases outside the catalogue: a name, no unexplained rest
    std::map<std::string, Rate> wrong_without_flag_by_kind;
    PairScore pairs;
    /// By what the fainter effect of a case shows, in the order of `detectability_bounds`.
    std::array<SingleScore, 4> singles_by_detectability;
    std::array<PairScore, 4> pairs_by_detectability;
    /// Counts by truth and first answer, of all but pairs.
    std::map<std::string, std::map<std::string, int>> confusion;
    int errors = 0;
};

Score score_of(const std::vector<ScoredCase>& cases);

/// The same answers with the truths dealt out anew: what chance would score.
std::vector<ScoredCase> shuffled(std::vector<ScoredCase> cases, std::uint32_t seed);

/// The score as text, in tables of Markdown.
std::string score_text(const Score& score);

}  // namespace braidzone::blind
