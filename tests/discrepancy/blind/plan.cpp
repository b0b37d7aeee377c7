#include "discrepancy/blind/plan.hpp"

#include "core/error.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <random>

namespace braidzone::blind {
namespace {

std::vector<std::string> names_where(bool in_catalogue)
{
    std::vector<std::string> names;
    for (const hidden::EffectMaker& maker : hidden::effect_makers()) {
        if (maker.in_catalogue == in_catalogue) names.emplace_back(maker.name);
    }
    return names;
}

hidden::EffectSize size_in_turn(int turn)
{
    return static_cast<hidden::EffectSize>(turn % 3);
}

/// Weak effects often cannot be seen: a pair with one is hardly a pair.
hidden::EffectSize size_of_two(int turn)
{
    return turn % 2 == 0 ? hidden::EffectSize::medium : hidden::EffectSize::strong;
}

/// A push and a pull make no pair: together they are neither.
bool can_be_together(const std::string& first, const std::string& second)
{
    const auto is_spacing = [](const std::string& name) {
        return name == "local_push" || name == "local_pull";
    };
    return first != second && !(is_spacing(first) && is_spacing(second));
}

PlannedCase random_pair(hidden::EffectSize first_size, hidden::EffectSize second_size,
                        std::mt19937& random)
{
    const std::vector<std::string> names = names_where(true);
    std::uniform_int_distribution<std::size_t> any(0, names.size() - 1);
    std::string first, second;
    do {
        first = names[any(random)];
        second = names[any(random)];
    } while (!can_be_together(first, second));
    return {"pair", {{first, first_size}, {second, second_size}}};
}

}  // namespace

PlannedCase another_pair(const PlannedCase& pair, std::uint32_t seed)
{
    std::mt19937 random(seed);
    return random_pair(pair.effects.at(0).size, pair.effects.at(1).size, random);
}

std::vector<PlannedCase> make_plan(const PlanSizes& sizes, std::uint32_t seed)
{
    std::mt19937 random(seed);
    const std::vector<std::string> known = names_where(true), outside = names_where(false);
    for (const std::string& name : sizes.effects) {
        if (std::find(known.begin(), known.end(), name) == known.end()) {
            throw InputError(fmt::format("effect \"{}\" is not known; there are {}", name,
                                         fmt::join(known, ", ")));
        }
    }
    std::vector<PlannedCase> plan;
    for (const std::string& name : sizes.effects.empty() ? known : sizes.effects) {
        for (int i = 0; i < sizes.per_effect; ++i)
            plan.push_back({"single", {{name, size_in_turn(i)}}});
    }
    for (int i = 0; i < sizes.none; ++i)
        plan.push_back({"none", {}});
    const int kinds = static_cast<int>(outside.size());
    for (int i = 0; i < sizes.outside; ++i) {
        plan.push_back(
            {"outside", {{outside[static_cast<std::size_t>(i % kinds)], size_in_turn(i / kinds)}}});
    }
    for (int i = 0; i < sizes.pairs; ++i)
        plan.push_back(random_pair(size_of_two(i), size_of_two(i / 2), random));
    std::shuffle(plan.begin(), plan.end(), random);
    return plan;
}

}  // namespace braidzone::blind
