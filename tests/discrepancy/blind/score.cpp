#include "discrepancy/blind/score.hpp"

#include <boost/math/special_functions/beta.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <random>
#include <set>

namespace braidzone::blind {
namespace {

using Names = std::set<std::string>;

Names names_of(const CaseTruth& truth)
{
    Names names;
    for (const hidden::HiddenEffect& effect : truth.effects)
        names.insert(effect.name);
    return names;
}

Names first_names(const Answer& answer)
{
    if (answer.sets.empty()) return {};
    return {answer.sets.front().begin(), answer.sets.front().end()};
}

bool is_detected(const Answer& answer)
{
    return answer.finding != "nothing_missing" && answer.finding != "error";
}

bool in_any_set(const Names& truth, const Answer& answer)
{
    return std::any_of(answer.sets.begin(), answer.sets.end(),
                       [&](const auto& set) { return Names(set.begin(), set.end()) == truth; });
}

/// True if the printed names hold the truth, maybe with others beside it.
bool among_names(const Names& truth, const Answer& answer)
{
    return std::any_of(answer.sets.begin(), answer.sets.end(), [&](const auto& set) {
        const Names names(set.begin(), set.end());
        return std::includes(names.begin(), names.end(), truth.begin(), truth.end());
    });
}

/// Location and intervals of an effect that was rightly named.
void add_parameters(const hidden::HiddenEffect& truth, const Answer& answer, SingleScore& score)
{
    constexpr double normal_95 = 1.645;
    const auto fit = answer.fits.find(truth.name);
    if (fit == answer.fits.end()) return;
    for (const auto& [name, value] : truth.values) {
        const auto found = fit->second.values.find(name);
        const auto sd = fit->second.sd.find(name);
        if (found == fit->second.values.end() || sd == fit->second.sd.end()) continue;
        const double error = std::abs(found->second - value);
        score.covered.add(error <= normal_95 * sd->second);
        if (name == "centre") score.location_errors.push_back(error);
    }
}

void add_single(const ScoredCase& one, SingleScore& score)
{
    const Answer& answer = one.answer;
    const Names truth = names_of(one.truth);
    const hidden::HiddenEffect& effect = one.truth.effects.front();
    score.detected.add(is_detected(answer));
    if (!is_detected(answer)) return;
    const bool is_right = first_names(answer) == truth;
    score.first.add(is_right);
    score.in_set.add(in_any_set(truth, answer));
    score.among_names.add(among_names(truth, answer));
    if (!answer.sets.empty()) score.first_of_named.add(is_right);
    if (is_right) add_parameters(effect, answer, score);
    const auto oracle = answer.fits.find(effect.name);
    if (oracle == answer.fits.end()) return;
    score.rms_before.push_back(answer.rms_before);
    score.rms_after.push_back(answer.rms_after);
    score.rms_oracle.push_back(oracle->second.rms_after);
}

void add_pair(const ScoredCase& one, PairScore& score)
{
    const Names truth = names_of(one.truth), found = first_names(one.answer);
    const bool some_wrong = !std::includes(truth.begin(), truth.end(), found.begin(), found.end());
    score.both.add(found == truth);
    score.one.add(!found.empty() && !some_wrong);
    score.wrong.add(some_wrong);
    score.in_set.add(in_any_set(truth, one.answer));
}

/// Of the case's fainter effect; none if it was not measured.
std::optional<std::size_t> detectability_class(const CaseTruth& truth)
{
    if (truth.detectability.empty()) return std::nullopt;
    const double least = *std::min_element(truth.detectability.begin(), truth.detectability.end());
    const auto end =
        std::upper_bound(detectability_bounds.begin(), detectability_bounds.end(), least);
    return static_cast<std::size_t>(end - detectability_bounds.begin());
}

double median(std::vector<double> values)
{
    if (values.empty()) return std::nan("");
    std::sort(values.begin(), values.end());
    const std::size_t n = values.size();
    return 0.5 * (values[(n - 1) / 2] + values[n / 2]);
}

std::string rate_text(const Rate& rate)
{
    if (rate.of == 0) return "-";
    const Bounds bounds = clopper_pearson(rate);
    return fmt::format("{}/{} = {:.1f} % ({:.1f} to {:.1f})", rate.count, rate.of,
                       100.0 * rate.count / rate.of, 100.0 * bounds.lower, 100.0 * bounds.upper);
}

std::string share_text(const Rate& rate)
{
    return rate.of == 0 ? "-" : fmt::format("{}/{}", rate.count, rate.of);
}

std::string millimetres(const std::vector<double>& values)
{
    return values.empty() ? "-" : fmt::format("{:.3f}", 1e3 * median(values));
}

/// Of what the oracle closes, by the medians' squares.
std::string closure_text(const SingleScore& score)
{
    const double before = std::pow(median(score.rms_before), 2);
    const double closed = before - std::pow(median(score.rms_after), 2);
    const double possible = before - std::pow(median(score.rms_oracle), 2);
    return possible > 0.0 ? fmt::format("{:.2f}", closed / possible) : "-";
}

std::string single_row(const std::string& name, const SingleScore& score)
{
    Rate near;
    for (const double error : score.location_errors)
        near.add(error <= 1e-3);
    return fmt::format(
        "| {} | {} | {} | {} | {} | {} | {} | {} | {} / {} / {} | {} |\n", name,
        share_text(score.detected), share_text(score.first), share_text(score.first_of_named),
        share_text(score.in_set), millimetres(score.location_errors), share_text(near),
        share_text(score.covered), millimetres(score.rms_before), millimetres(score.rms_after),
        millimetres(score.rms_oracle), closure_text(score));
}

constexpr const char* single_head =
    "| hidden | detected | right first, of detected | of named | in a set | place off by [mm], "
    "median | within 1 mm | in 90 % interval | RMS before / after / oracle [mm], medians | share "
    "of the oracle's closure |\n|---|---|---|---|---|---|---|---|---|---|\n";

std::string detectability_table(const Score& score)
{
    std::string text =
        "\n## By detectability d' of the effect, of the fainter one of a pair\n\n"
        "| d' | single effects detected | right first, of detected | pairs: both and nothing else "
        "| at least one, none wrong |\n|---|---|---|---|---|\n";
    double from = 0.0;
    for (std::size_t i = 0; i < score.singles_by_detectability.size(); ++i) {
        const bool is_last = i == detectability_bounds.size();
        const double to = is_last ? 0.0 : detectability_bounds[i];
        const SingleScore& single = score.singles_by_detectability[i];
        const PairScore& pair = score.pairs_by_detectability[i];
        text += fmt::format(
            "| {} | {} | {} | {} | {} |\n",
            is_last ? fmt::format("{} and more", from) : fmt::format("{} to {}", from, to),
            rate_text(single.detected), rate_text(single.first), rate_text(pair.both),
            rate_text(pair.one));
        from = to;
    }
    return text;
}

/// Numbered columns, with rows in the same order, so that it stays narrow.
std::string confusion_text(const std::map<std::string, std::map<std::string, int>>& confusion,
                           bool by_answer)
{
    Names labels;
    for (const auto& [truth, row] : confusion) {
        labels.insert(truth);
        for (const auto& [answer, count] : row)
            labels.insert(answer);
    }
    std::map<std::string, int> totals;
    for (const auto& [truth, row] : confusion) {
        for (const auto& [answer, count] : row)
            totals[answer] += count;
    }
    std::string head = "| |", rule = "|---|", body;
    int number = 0;
    for (const std::string& label : labels) {
        head += fmt::format(" {} |", ++number);
        rule += "---|";
        body += fmt::format("| {} {} |", number, label);
        for (const std::string& answer : labels) {
            const auto row = confusion.find(label);
            const int count =
                row != confusion.end() && row->second.contains(answer) ? row->second.at(answer) : 0;
            if (count == 0) {
                body += " |";
            } else if (by_answer) {
                body += fmt::format(" {:.2f} |", static_cast<double>(count) / totals[answer]);
            } else {
                body += fmt::format(" {} |", count);
            }
        }
        body += "\n";
    }
    return head + "\n" + rule + "\n" + body;
}

}  // namespace

Bounds clopper_pearson(const Rate& rate)
{
    constexpr double tail = 0.025;
    const double count = rate.count, rest = rate.of - rate.count;
    Bounds bounds;
    if (rate.count > 0) bounds.lower = boost::math::ibeta_inv(count, rest + 1.0, tail);
    if (rate.count < rate.of) bounds.upper = boost::math::ibeta_inv(count + 1.0, rest, 1.0 - tail);
    return bounds;
}

std::string first_answer(const Answer& answer)
{
    if (!answer.sets.empty()) return fmt::format("{}", fmt::join(first_names(answer), "+"));
    return answer.finding == "nothing_missing" ? "none" : answer.finding;
}

std::string label_of(const CaseTruth& truth)
{
    if (truth.effects.empty()) return "none";
    return fmt::format("{}", fmt::join(names_of(truth), "+"));
}

Score score_of(const std::vector<ScoredCase>& cases)
{
    Score score;
    for (const ScoredCase& one : cases) {
        const CaseTruth& truth = one.truth;
        if (one.answer.finding == "error") ++score.errors;
        if (truth.kind == "pair") {
            add_pair(one, score.pairs);
            if (const auto k = detectability_class(truth))
                add_pair(one, score.pairs_by_detectability[*k]);
            continue;
        }
        ++score.confusion[label_of(truth)][first_answer(one.answer)];
        if (truth.kind == "none") score.false_alarm.add(is_detected(one.answer));
        if (truth.kind == "outside") {
            const bool is_wrong = !one.answer.sets.empty() && !one.answer.leaves_doubt;
            score.wrong_without_flag.add(is_wrong);
            score.wrong_without_flag_by_kind[label_of(truth)].add(is_wrong);
        }
        if (truth.kind == "single") {
            add_single(one, score.singles[label_of(truth)]);
            add_single(one, score.all_singles);
            if (const auto k = detectability_class(truth))
                add_single(one, score.singles_by_detectability[*k]);
            add_single(one, score.by_size[std::string(name_of(truth.effects.front().size))]);
        }
    }
    return score;
}

std::vector<ScoredCase> shuffled(std::vector<ScoredCase> cases, std::uint32_t seed)
{
    std::mt19937 random(seed);
    std::vector<CaseTruth> truths;
    for (const ScoredCase& one : cases)
        truths.push_back(one.truth);
    std::shuffle(truths.begin(), truths.end(), random);
    for (std::size_t i = 0; i < cases.size(); ++i)
        cases[i].truth = truths[i];
    return cases;
}

std::string score_text(const Score& score)
{
    std::string text = "## Single effects\n\n";
    text += single_head;
    for (const auto& [name, one] : score.singles)
        text += single_row(name, one);
    for (const auto& [name, one] : score.by_size)
        text += single_row("all " + name, one);
    text += single_row("all", score.all_singles);
    const SingleScore& all = score.all_singles;
    text += fmt::format(
        "\n| rate | of cases (95 % bounds) |\n|---|---|\n| detected | {} |\n| right name first, of "
        "detected | {} |\n| truth in a printed set, of detected | {} |\n| truth among the printed "
        "names, of detected | {} |\n| parameters in their 90 % "
        "intervals | {} |\n| false alarms without an effect | {} |\n| outside the catalogue: a "
        "name without a flag | {} |\n",
        rate_text(all.detected), rate_text(all.first), rate_text(all.in_set),
        rate_text(all.among_names), rate_text(all.covered), rate_text(score.false_alarm),
        rate_text(score.wrong_without_flag));
    for (const auto& [kind, rate] : score.wrong_without_flag_by_kind)
        text += fmt::format("| - {} | {} |\n", kind, rate_text(rate));
    text += fmt::format(
        "| pairs: both and nothing else | {} |\n| pairs: at least one, none wrong | {} |\n| pairs: "
        "something wrong | {} |\n| pairs: both in a printed set | {} |\n| failed to answer | {} "
        "|\n",
        rate_text(score.pairs.both), rate_text(score.pairs.one), rate_text(score.pairs.wrong),
        rate_text(score.pairs.in_set), score.errors);
    text += detectability_table(score);
    text += "\n## Confusion matrix: truth down, first answer across\n\n" +
            confusion_text(score.confusion, false);
    text += "\n## Inversion matrix: share of the truths behind each first answer\n\n" +
            confusion_text(score.confusion, true);
    return text;
}

}  // namespace braidzone::blind
