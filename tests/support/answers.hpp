#pragma once

#include "discrepancy/explanation.hpp"

#include <string>
#include <vector>

namespace braidzone::test {

/// The names of all answers, "density", "viscosity + leakage"; the finding if there are none.
inline std::vector<std::string> answers(const Explanation& explanation)
{
    std::vector<std::string> names;
    for (const Answer& answer : explanation.verdict.answers)
        names.push_back(name_of(explanation.fits[answer.fit]));
    if (names.empty()) names.push_back(name_of(explanation.verdict.finding));
    return names;
}

}  // namespace braidzone::test
