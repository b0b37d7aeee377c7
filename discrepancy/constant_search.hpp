#pragma once

#include <cmath>

namespace braidzone {

/// The positive constants of a structure at which a function of it is largest, near a start: one
/// constant at a time by factors that shrink from 1.5 to 1.03, over and over.
/// @param constants  pointers to members of type double; one that is 0 stays so
/// @param value      of a structure; called in one thread
template <typename Structure, typename Constants, typename Value>
Structure best_constants(const Structure& start, const Constants& constants, const Value& value)
{
    constexpr int most_rounds = 6;
    Structure best = start;
    double best_value = value(best);
    for (const double step : {0.4, 0.2, 0.1, 0.05, 0.03}) {
        bool has_moved = true;
        for (int round = 0; has_moved && round < most_rounds; ++round) {
            has_moved = false;
            for (const auto constant : constants) {
                for (const double direction : {1.0, -1.0}) {
                    Structure trial = best;
                    trial.*constant *= std::exp(direction * step);
                    const double trial_value = value(trial);
                    if (trial_value <= best_value) continue;
                    best_value = trial_value;
                    best = trial;
                    has_moved = true;
                    break;
                }
            }
        }
    }
    return best;
}

}  // namespace braidzone
