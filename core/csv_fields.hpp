#pragma once

#include <optional>
#include <string_view>
#include <vector>

namespace braidzone {

/// The fields of a line of comma-separated values, without the blanks around them. Quotes have no
/// meaning.
std::vector<std::string_view> csv_fields(std::string_view line);

/// The finite number that a field is; none if it is anything else.
std::optional<double> csv_number(std::string_view field);

}  // namespace braidzone
