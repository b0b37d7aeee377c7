#pragma once

#include "discrepancy/explanation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace braidzone::test {

/// What was hidden in a curve: a name of the catalogue, "none", or that of something outside it.
struct Truth {
    std::string name;
    bool in_catalogue = false;
    std::optional<double> value = {};  ///< of the effect's first parameter [SI]
};

/// How the answers to cases with one thing hidden came out.
struct Tally {
    bool in_catalogue = false;
    int cases = 0;
    int nothing = 0;  ///< nothing is missing
    int first = 0;    ///< the first name is right
    int in_set = 0;   ///< the truth is in the set, not first
    int wrong = 0;    ///< a wrong name or set, without the flag of an unexplained rest
    int wrong_flagged = 0;
    int unknown = 0;
    int or_unknown = 0;     ///< named, with an unknown effect in the set
    int sole = 0;           ///< the only name, and right
    double set_size = 0.0;  ///< sum over named cases
    std::map<std::string, int> first_names;

    int with_value = 0;   ///< fits of the right effect, named or not, whose parameter is known
    int in_interval = 0;  ///< and within the fit's 90 % interval

    int detected() const { return cases - nothing; }
};

inline bool holds(const Answer& answer, const std::string& name)
{
    return std::find(answer.effects.begin(), answer.effects.end(), name) != answer.effects.end();
}

/// A set of several effects is no right answer to a single hidden one.
inline bool is_right(const Answer& answer, const std::string& name)
{
    return answer.effects.size() == 1 && answer.effects.front() == name;
}

/// If the parameter of the right effect lies within 1.645 standard deviations of its fit.
inline void count_interval(Tally& tally, const Truth& truth, const std::vector<EffectFit>& fits)
{
    for (const EffectFit& fit : fits) {
        if (!truth.value || name_of(fit) != truth.name) continue;
        const FittedEffect& effect = fit.effects.front();
        ++tally.with_value;
        tally.in_interval +=
            std::abs(effect.values.front() - *truth.value) < 1.645 * effect.sd.front() ? 1 : 0;
    }
}

inline void count(std::map<std::string, Tally>& tallies, const Truth& truth,
                  const Explanation& found)
{
    const Verdict& verdict = found.verdict;
    Tally& tally = tallies[truth.name];
    tally.in_catalogue = truth.in_catalogue;
    ++tally.cases;
    count_interval(tally, truth, found.fits);
    if (verdict.finding == Finding::nothing_missing) {
        ++tally.nothing;
        ++tally.first_names["-"];
        return;
    }
    if (verdict.answers.empty()) {
        ++tally.unknown;
        ++tally.first_names["unknown"];
        return;
    }
    std::string name;
    for (const std::string& effect : verdict.answers.front().effects)
        name += (name.empty() ? "" : "+") + effect;
    ++tally.first_names[name];
    tally.set_size += static_cast<double>(verdict.answers.size() + (verdict.unknown_lead ? 1 : 0));
    const bool unknown_first = verdict.unknown_lead.value_or(-1.0) > 0.0;
    tally.or_unknown += verdict.unknown_lead ? 1 : 0;
    if (is_right(verdict.answers.front(), truth.name) && !unknown_first) {
        ++tally.first;
        tally.sole += verdict.answers.size() == 1 && !verdict.unknown_lead ? 1 : 0;
        return;
    }
    const bool is_in_set =
        std::any_of(verdict.answers.begin(), verdict.answers.end(),
                    [&](const Answer& answer) { return is_right(answer, truth.name); });
    if (is_in_set) {
        ++tally.in_set;
    } else if (verdict.has_unexplained_rest || verdict.unknown_lead) {
        ++tally.wrong_flagged;
    } else {
        ++tally.wrong;
    }
}

inline std::string percent(int part, int whole)
{
    if (whole == 0) return "-";
    return fmt::format("{} of {} ({:.0f} %)", part, whole, 100.0 * part / whole);
}

/// The table of all kinds, and the bars.
inline void print(const std::map<std::string, Tally>& tallies)
{
    fmt::print(
        "| hidden | cases | nothing | right name first | (alone) | in set | wrong | wrong, "
        "flagged | unknown | (or unknown) | in 90 % interval | first names "
        "|\n|---|---|---|---|---|---|---|---|---|---|---|---|\n");
    Tally named, none, outside;
    for (const auto& [name, tally] : tallies) {
        std::string names;
        for (const auto& [first, number] : tally.first_names)
            names += fmt::format("{}{} {}", names.empty() ? "" : ", ", first, number);
        fmt::print("| {} | {} | {} | {} | {} | {} | {} | {} | {} | {} | {} | {} |\n", name,
                   tally.cases, tally.nothing, tally.first, tally.sole, tally.in_set, tally.wrong,
                   tally.wrong_flagged, tally.unknown, tally.or_unknown,
                   percent(tally.in_interval, tally.with_value), names);
        Tally& sum = tally.in_catalogue ? named : name == "none" ? none : outside;
        sum.cases += tally.cases;
        sum.nothing += tally.nothing;
        sum.first += tally.first;
        sum.sole += tally.sole;
        sum.in_set += tally.in_set;
        sum.wrong += tally.wrong;
        sum.wrong_flagged += tally.wrong_flagged;
        sum.unknown += tally.unknown;
        sum.set_size += tally.set_size;
        sum.with_value += tally.with_value;
        sum.in_interval += tally.in_interval;
    }
    const int with_a_name = named.detected() - named.unknown;
    fmt::print(
        "\n| bar | reached |\n|---|---|\n"
        "| effects detected | {} |\n"
        "| right name first, of those detected: 85 % | {} |\n"
        "| truth in the set, of those detected: 95 % | {} |\n"
        "| mean size of the sets | {:.2f} |\n"
        "| false alarm without an effect: 5 % | {} |\n"
        "| outside the catalogue, wrong name without flag: 5 % | {} |\n"
        "| parameter within its 90 % interval: 80 to 97 % | {} |\n",
        percent(named.detected(), named.cases), percent(named.first, named.detected()),
        percent(named.first + named.in_set, named.detected()),
        with_a_name > 0 ? named.set_size / with_a_name : 0.0, percent(none.detected(), none.cases),
        percent(outside.wrong, outside.cases), percent(named.in_interval, named.with_value));
}

}  // namespace braidzone::test
