// Deploys devices in random siphons and counts what goes wrong. See README.md beside it.
//
//     siphon_campaign FIRST_SEED LAST_SEED [LINES.csv]
//
// Seeds that LINES.csv already holds are not computed again.

#include "verification/siphons/outcome.hpp"

#include <fmt/format.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <set>
#include <sstream>
#include <string>

namespace braidzone::test {
namespace {

std::set<unsigned> seeds_in(const std::filesystem::path& lines)
{
    std::set<unsigned> seeds;
    std::ifstream file(lines);
    for (std::string line; std::getline(file, line);)
        if (!line.empty()) seeds.insert(static_cast<unsigned>(std::stoul(line)));
    return seeds;
}

std::string without_commas(std::string text)
{
    for (char& letter : text)
        if (letter == ',' || letter == '\n') letter = ';';
    return text;
}

/// seed, tightest bend, force-free, pushed, inverted, jammed, outside, mouths, found, invented,
/// contact, s, unmade, refused
std::string line_of(unsigned seed, const Siphon& siphon, const Outcome& outcome)
{
    return fmt::format("{},{:.3f},{},{},{},{},{},{},{},{},{:.3f},{:.2f},{},{}", seed,
                       siphon.tightest_bend, int{siphon.force_free}, int{siphon.push.has_value()},
                       outcome.inverted, outcome.jammed, outcome.outside, outcome.mouths,
                       outcome.found, outcome.invented, outcome.contact, outcome.cpu_time,
                       without_commas(outcome.unmade), without_commas(outcome.refused));
}

struct Totals {
    int made = 0, unmade = 0, too_small = 0, refused = 0, inverted = 0, jammed = 0, outside = 0;
    int mouths = 0, found = 0, invented = 0;
    double time = 0.0;
    std::string failing;
};

void add(Totals& totals, unsigned seed, const Outcome& outcome)
{
    if (!outcome.unmade.empty()) {
        ++totals.unmade;
        return;
    }
    ++totals.made;
    // A device of 0.95 times the vessel's width may rightly be refused.
    if (outcome.refused.find("too small") != std::string::npos) {
        ++totals.too_small;
        return;
    }
    totals.refused += !outcome.refused.empty();
    totals.inverted += outcome.inverted > 0;
    totals.jammed += outcome.jammed > 0;
    totals.outside += outcome.outside > 0;
    totals.mouths += outcome.mouths;
    totals.found += outcome.found;
    totals.invented += outcome.invented;
    totals.time += outcome.cpu_time;
    if (!outcome.refused.empty() || outcome.inverted > 0 || outcome.jammed > 0 ||
        outcome.outside > 0 || outcome.found < outcome.mouths || outcome.invented > 0) {
        totals.failing += fmt::format(" {}", seed);
    }
}

}  // namespace
}  // namespace braidzone::test

int main(int argc, char** argv)
{
    using namespace braidzone::test;
    if (argc < 3) {
        std::cerr << "siphon_campaign FIRST_SEED LAST_SEED [LINES.csv]\n";
        return 2;
    }
    const auto first = static_cast<unsigned>(std::stoul(argv[1]));
    const auto last = static_cast<unsigned>(std::stoul(argv[2]));
    const std::filesystem::path lines = argc > 3 ? argv[3] : "";
    const std::set<unsigned> done = seeds_in(lines);
    std::ofstream file;
    if (!lines.empty()) file.open(lines, std::ios::app);
    Totals totals;
    for (unsigned seed = first; seed <= last; ++seed) {
        if (done.count(seed) != 0) continue;
        const Siphon siphon = random_siphon(seed);
        const Outcome outcome = outcome_of(siphon);
        add(totals, seed, outcome);
        const std::string line = line_of(seed, siphon, outcome);
        (lines.empty() ? std::cout : file) << line << std::endl;
    }
    std::cout << fmt::format(
        "{} siphons, {} not made\nrefused as too small for the vessel {}\nelse refused {}\n"
        "with inverted rhombi {}\nwith jammed ones {}\nwith nodes outside {}\n"
        "mouths found {} of {}, {} where nothing is\nCPU time {:.2f} s each\nfailing seeds:{}\n",
        totals.made, totals.unmade, totals.too_small, totals.refused, totals.inverted,
        totals.jammed, totals.outside, totals.found, totals.mouths, totals.invented,
        totals.time / std::max(1, totals.made), totals.failing);
    return EXIT_SUCCESS;
}
