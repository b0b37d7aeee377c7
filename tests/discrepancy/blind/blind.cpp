// Hidden cases: makes them, has them diagnosed, and scores the answers; see README.md beside this.
//
//     blind make DATA TRUTH --seed N [--per-effect N --none N --outside N --pairs N]
//                           [--least-detectability D]
//     blind calibrate NOISE.json --seed N --sets N
//     blind diagnose DATA ANSWERS [--noise NOISE.json] [--further] [--without EFFECT]
//                           [--jobs N]
//     blind score DATA TRUTH ANSWERS [--shuffle-labels SEED]
//     blind hidden_push FOLDER        the data of cases/hidden_push

#include "core/error.hpp"
#include "core/file_hash.hpp"
#include "discrepancy/blind/detectability.hpp"
#include "discrepancy/blind/plan.hpp"
#include "discrepancy/blind/score.hpp"
#include "discrepancy/noise_calibration.hpp"
#include "support/hidden/spacing_stretch.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <atomic>
#include <fstream>
#include <thread>

namespace braidzone::blind {
namespace {

constexpr const char* digests_name = "truths.sha256";

struct Arguments {
    fs::path data, truth, answers, noise;
    PlanSizes sizes;
    double least_detectability = 0.0;
    std::uint32_t seed = 0;
    int num_sets = 60;
    int jobs = 1;
    std::vector<std::string> without;
    bool with_further = false;
    bool shuffles = false;
};

void write_text(const fs::path& file, const std::string& text)
{
    // Under another name first: a file that is there is whole.
    const fs::path partial = file.string() + ".partial";
    {
        std::ofstream out(partial);
        if (!(out << text)) throw IoError(fmt::format("{} cannot be written", file.string()));
    }
    fs::rename(partial, file);
}

std::string case_name(std::size_t i)
{
    return fmt::format("{:04}", i + 1);
}

/// Different cases, whatever the first seed.
std::uint32_t seed_of(std::uint32_t first, std::size_t number)
{
    std::seed_seq sequence{first, static_cast<std::uint32_t>(number)};
    std::vector<std::uint32_t> one(1);
    sequence.generate(one.begin(), one.end());
    return one.front();
}

/// A case and the truth about it.
struct SealedCase {
    hidden::HiddenCase made;
    CaseTruth truth;
};

/// A case of the plan. Two strong effects may leave a device nowhere to lie; then another vessel is
/// tried, and said so.
SealedCase made_case(const PlannedCase& planned, const std::string& name, std::uint32_t seed)
{
    constexpr std::size_t most_trials = 5;
    for (std::size_t trial = 1;; ++trial) {
        try {
            hidden::HiddenCase made =
                hidden::random_case(planned.effects, trial == 1 ? seed : seed_of(seed, trial));
            CaseTruth truth{planned.kind, made.effects, detectability(made, planned.effects)};
            return {std::move(made), std::move(truth)};
        } catch (const std::runtime_error& error) {
            if (trial == most_trials) throw;
            fmt::print(stderr, "{}: {}; with another vessel\n", name, error.what());
        }
    }
}

/// True if an effect of the case is fainter than a limit.
bool has_fainter(const CaseTruth& truth, double least)
{
    return std::any_of(truth.detectability.begin(), truth.detectability.end(),
                       [&](double index) { return index < least; });
}

/// Case i of the plan, a pair drawn anew until both of its effects are as detectable as asked for.
/// @param num_drawn  counts these draws
SealedCase drawn_case(const PlannedCase& planned, std::size_t i, const Arguments& arguments,
                      std::atomic<int>& num_drawn)
{
    constexpr int most_draws = 100;
    const std::string name = case_name(i);
    std::uint32_t seed = seed_of(arguments.seed, i);
    SealedCase one = made_case(planned, name, seed);
    if (planned.kind != "pair") return one;
    for (int draw = 1; has_fainter(one.truth, arguments.least_detectability); ++draw) {
        if (draw == most_draws) {
            throw InputError(fmt::format("{}: of {} pairs none has two effects of d' >= {}", name,
                                         most_draws, arguments.least_detectability));
        }
        seed = seed_of(seed, i);
        one = made_case(another_pair(planned, seed), name, seed);
        ++num_drawn;
    }
    return one;
}

void make(const Arguments& arguments)
{
    const std::vector<PlannedCase> plan = make_plan(arguments.sizes, arguments.seed);
    std::atomic<int> num_drawn = arguments.sizes.pairs;
    fs::create_directories(arguments.data);
    fs::create_directories(arguments.truth);
    std::vector<std::string> digests(plan.size());
    tbb::parallel_for(std::size_t{0}, plan.size(), [&](std::size_t i) {
        const std::string name = case_name(i);
        const std::uint32_t seed = seed_of(arguments.seed, i);
        const SealedCase one = drawn_case(plan[i], i, arguments, num_drawn);
        write_case(one.made, hidden::further_data(one.made, seed_of(seed, 0)),
                   arguments.data / name);
        std::mt19937_64 salt(seed);
        const std::string truth = truth_text(one.truth, salt());
        write_text(arguments.truth / (name + ".json"), truth);
        digests[i] = fmt::format("{}  {}.json\n", sha256_of_text(truth), name);
    });
    write_text(arguments.data / digests_name, fmt::format("{}", fmt::join(digests, "")));
    fmt::print("{} cases in {}, their truths in {}\n", plan.size(), arguments.data.string(),
               arguments.truth.string());
    fmt::print("{} pairs were drawn until {} had no effect of d' < {}\n", num_drawn.load(),
               arguments.sizes.pairs, arguments.least_detectability);
}

/// A measurement without an effect, as a set to learn from.
CalibrationSet random_set(std::uint32_t seed)
{
    const hidden::HiddenCase made = hidden::random_case({}, seed);
    const Model model = believed_model(made.belief);
    const Lumen lumen = believed_lumen(made.belief.phantom);
    return calibration_set(made.scan.points, made.scan.ends, model, simulate(model, lumen), lumen);
}

void calibrate(const Arguments& arguments)
{
    std::vector<CalibrationSet> sets(static_cast<std::size_t>(arguments.num_sets));
    tbb::parallel_for(std::size_t{0}, sets.size(),
                      [&](std::size_t i) { sets[i] = random_set(seed_of(arguments.seed, i)); });
    write_text(arguments.noise, noise_floor_text(calibrate_noise_floor(sets)));
}

std::vector<Effect> catalogue_without(const std::vector<std::string>& left_out)
{
    std::vector<Effect> kept = effect_catalogue();
    for (const std::string& name : left_out) {
        if (std::erase_if(kept, [&](const Effect& effect) { return effect.name == name; }) == 0)
            throw InputError(fmt::format("effect \"{}\" is not in the catalogue", name));
    }
    return kept;
}

/// Cases side by side, each on one thread: a diagnosis has stretches that nothing shares.
void diagnose_all(const Arguments& arguments)
{
    const std::vector<Effect> catalogue = catalogue_without(arguments.without);
    DiagnoseOptions options;
    if (!arguments.noise.empty()) options.floor = read_noise_floor(arguments.noise);
    fs::create_directories(arguments.answers);
    std::vector<std::string> open;
    for (const std::string& name : cases_in(arguments.data)) {
        if (!fs::exists(arguments.answers / (name + ".json"))) open.push_back(name);
    }
    std::atomic<std::size_t> next = 0;
    const auto work = [&] {
        tbb::task_arena arena(1);
        for (std::size_t i = next++; i < open.size(); i = next++) {
            const Answer answer = arena.execute([&] {
                return answer_to(read_case(arguments.data / open[i], arguments.with_further),
                                 catalogue, options);
            });
            write_text(arguments.answers / (open[i] + ".json"), answer_text(answer));
            fmt::print("{} {}{} ({} deployments){}\n", open[i], first_answer(answer),
                       answer.leaves_doubt ? ", with doubt" : "", answer.num_runs, answer.error);
            std::fflush(stdout);
        }
    };
    std::vector<std::jthread> workers;
    for (int i = 0; i < arguments.jobs; ++i)
        workers.emplace_back(work);
}

/// Digests of the truths as they were sealed, by file name.
std::map<std::string, std::string> sealed_digests(const fs::path& data)
{
    std::ifstream in(data / digests_name);
    std::map<std::string, std::string> digests;
    for (std::string digest, file; in >> digest >> file;)
        digests[file] = digest;
    return digests;
}

void score(const Arguments& arguments)
{
    const std::map<std::string, std::string> digests = sealed_digests(arguments.data);
    std::vector<ScoredCase> cases;
    for (const std::string& name : cases_in(arguments.data)) {
        const std::string file = name + ".json";
        if (!fs::exists(arguments.answers / file)) continue;
        const fs::path truth = arguments.truth / file;
        if (!digests.contains(file) || digests.at(file) != sha256_of_file(truth)) {
            throw InputError(fmt::format("{} is not the truth that was sealed", truth.string()));
        }
        cases.push_back({read_truth(truth), read_answer(arguments.answers / file)});
    }
    if (arguments.shuffles) cases = shuffled(std::move(cases), arguments.seed);
    fmt::print("{} cases are answered.\n\n{}", cases.size(), score_text(score_of(cases)));
}

/// The paper's story: 66 % off the ring spacing in front of the neck.
void write_hidden_push(const fs::path& folder)
{
    hidden::HiddenStory story = hidden::story_of(hidden::sidewall_belief(BRAIDZONE_SOURCE_DIR));
    hidden::add_stretch(
        story.scene,
        {.centre = 15e-3, .half_width = 1.8e-3, .change = -0.66, .ripple = 0.05, .rebound = 0.1});
    std::mt19937 random(2020);
    write_scan(hidden::made_case(std::move(story), {}, {.num_points = 2500}, random).scan, folder);
}

void add_make(CLI::App& app, Arguments& arguments)
{
    CLI::App& verb = *app.add_subcommand("make", "makes hidden cases");
    verb.add_option("DATA", arguments.data)->required();
    verb.add_option("TRUTH", arguments.truth)->required();
    verb.add_option("--seed", arguments.seed)->required();
    verb.add_option("--per-effect", arguments.sizes.per_effect);
    verb.add_option("--effect", arguments.sizes.effects, "only these single effects");
    verb.add_option("--none", arguments.sizes.none);
    verb.add_option("--outside", arguments.sizes.outside);
    verb.add_option("--pairs", arguments.sizes.pairs);
    verb.add_option("--least-detectability", arguments.least_detectability,
                    "d' of both effects of a pair");
    verb.callback([&] { make(arguments); });
}

void add_calibrate(CLI::App& app, Arguments& arguments)
{
    CLI::App& verb = *app.add_subcommand("calibrate", "learns the noise floor");
    verb.add_option("NOISE", arguments.noise)->required();
    verb.add_option("--seed", arguments.seed)->required();
    verb.add_option("--sets", arguments.num_sets);
    verb.callback([&] { calibrate(arguments); });
}

void add_diagnose(CLI::App& app, Arguments& arguments)
{
    CLI::App& verb = *app.add_subcommand("diagnose", "answers the cases that are open");
    verb.add_option("DATA", arguments.data)->required();
    verb.add_option("ANSWERS", arguments.answers)->required();
    verb.add_option("--noise", arguments.noise);
    verb.add_option("--without", arguments.without, "effects to leave out of the catalogue");
    verb.add_flag("--further", arguments.with_further, "with the density and the force as well");
    verb.add_option("--jobs", arguments.jobs, "cases at a time")->check(CLI::PositiveNumber);
    verb.callback([&] { diagnose_all(arguments); });
}

void add_score(CLI::App& app, Arguments& arguments)
{
    CLI::App& verb = *app.add_subcommand("score", "compares answers and truths");
    verb.add_option("DATA", arguments.data)->required();
    verb.add_option("TRUTH", arguments.truth)->required();
    verb.add_option("ANSWERS", arguments.answers)->required();
    verb.add_option("--shuffle-labels", arguments.seed, "deals out the truths anew");
    verb.callback([&] {
        arguments.shuffles = verb.count("--shuffle-labels") > 0;
        score(arguments);
    });
}

void add_hidden_push(CLI::App& app, Arguments& arguments)
{
    CLI::App& verb = *app.add_subcommand("hidden_push", "writes the data of cases/hidden_push");
    verb.add_option("FOLDER", arguments.data)->required();
    verb.callback([&] { write_hidden_push(arguments.data); });
}

}  // namespace
}  // namespace braidzone::blind

int main(int argc, char** argv)
{
    using namespace braidzone::blind;
    CLI::App app("Hidden cases for diagnose");
    app.require_subcommand(1);
    Arguments arguments;
    add_make(app, arguments);
    add_calibrate(app, arguments);
    add_diagnose(app, arguments);
    add_score(app, arguments);
    add_hidden_push(app, arguments);
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        return app.exit(error);
    } catch (const std::exception& error) {
        fmt::print(stderr, "{}\n", error.what());
        return 1;
    }
    return 0;
}
