#pragma once

#include <string>
#include <vector>

namespace braidzone {

/// What is physically sensible for a numeric key of a TOML file, both ends allowed, as a person
/// writes it: "0.5 mm" for a quantity, "0.5" for a number. Wide enough for every use that is known,
/// so that what lies outside is a slip of a unit or of a key.
struct KeyRange {
    std::string key;  ///< dotted; tables of an array alike: "deployment.push_pull.from"
    std::string lowest;
    std::string highest;
};

using KeyRanges = std::vector<KeyRange>;

}  // namespace braidzone
