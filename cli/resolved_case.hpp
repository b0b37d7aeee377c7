#pragma once

#include "cli/case_file.hpp"

#include <nlohmann/json.hpp>

#include <string>

namespace braidzone {

/// A case with every value explicit, defaults and library values included: same sections and keys
/// as the case file, dimensional values as strings with their SI unit, absolute paths.
nlohmann::ordered_json resolved_case(const Case& job);

/// The same as a case file: `read_case` of this text gives an equal case.
std::string resolved_case_text(const Case& job);

}  // namespace braidzone
