#pragma once

#include "support/hidden/hidden_case.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace braidzone::blind {

/// How many cases of each kind to make.
struct PlanSizes {
    int per_effect = 0;  ///< for each single effect of the catalogue
    int none = 0;
    int outside = 0;                        ///< in turn of each kind
    int pairs = 0;                          ///< of any two unlike effects of the catalogue
    std::vector<std::string> effects = {};  ///< only these single effects; empty: all
};

/// A case to be made.
struct PlannedCase {
    std::string kind;
    std::vector<hidden::EffectChoice> effects;
};

/// Another two effects, of the same sizes.
PlannedCase another_pair(const PlannedCase& pair, std::uint32_t seed);

/// Cases in random order, so that a case's number tells nothing; sizes weak, medium and strong in
/// turn.
/// @throws InputError for an effect that is not known
std::vector<PlannedCase> make_plan(const PlanSizes& sizes, std::uint32_t seed);

}  // namespace braidzone::blind
