#pragma once

#include "core/toml_reader.hpp"

#include <filesystem>
#include <limits>
#include <string>
#include <vector>

namespace braidzone {

// Ranges of case-file values. Each throws ConfigError with file, line, key, what was found and what
// is allowed.

/// The value, if it is positive and no larger than `highest`.
double require_positive(const TomlTable& table, const std::string& key, double value,
                        double highest = std::numeric_limits<double>::infinity());

/// The value, if it is not negative.
double require_not_negative(const TomlTable& table, const std::string& key, double value);

/// A positive quantity [SI], or the fallback if the key is missing.
double positive_or(const TomlTable& table, const std::string& key, Dimension dimension,
                   double fallback);

/// An integer from `lowest` to `highest`, or the fallback if the key is missing.
int integer_in_range(const TomlTable& table, const std::string& key, int fallback, int lowest,
                     int highest);

/// A name out of a list, or the fallback if the key is missing.
std::string one_of(const TomlTable& table, const std::string& key, const std::string& fallback,
                   const std::vector<std::string>& allowed);

/// The file that a key names, relative to the case file's folder; it need not exist.
std::filesystem::path file_path(const TomlTable& table, const std::string& key);

/// Names out of a list, each once and at least one.
/// @return their places in the list
std::vector<std::size_t> some_of(const TomlTable& table, const std::string& key,
                                 const std::vector<std::string>& allowed);

}  // namespace braidzone
