#pragma once

#include <string>
#include <vector>

namespace braidzone {

/// Fewest insertions, deletions and replacements of one letter, and swaps of two neighbours, that
/// turn one word into the other (optimal string alignment; Damerau 1964, doi
/// 10.1145/363958.363994).
int edit_distance(const std::string& a, const std::string& b);

/// Help for a name that is not known, to append to a message: `; did you mean "diameter"?` if a
/// known name is near (at most a third of its letters differ), else `; known are a, b, c`. Empty if
/// nothing is known.
std::string did_you_mean(const std::string& name, const std::vector<std::string>& known);

}  // namespace braidzone
