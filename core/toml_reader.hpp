#pragma once

#include "core/key_range.hpp"
#include "core/quantity.hpp"
#include "core/vector.hpp"

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace braidzone {

/// A TOML table read strictly: every value has the type and unit that the reader asks for, and
/// `finish` refuses keys that nobody asked for.
///
/// Messages name the place as `file.toml:14: device.wire_diameter`. A dimensional value is a
/// string with its unit; a bare number there is an error. Tables are cheap handles on one parsed
/// document; overrides (`--set section.key=value`) are applied before any value is read.
class TomlTable {
public:
    /// Parses a file and applies overrides of the form "section.key=value"; a value that is not
    /// valid TOML is taken as a string, so that `--set device.diameter="4 mm"` works in a shell.
    /// @throws IoError if the file cannot be read; ConfigError if it is not TOML or an override
    ///         is malformed
    static TomlTable read_file(const std::filesystem::path& path,
                               const std::vector<std::string>& overrides = {});

    bool has(const std::string& key) const;

    // Required values: ConfigError if the key is missing or of another type.
    std::string text(const std::string& key) const;
    /// Dimensionless; a float, or an integer that a double holds exactly (up to 2^53).
    double number(const std::string& key) const;
    long integer(const std::string& key) const;
    bool boolean(const std::string& key) const;
    double quantity(const std::string& key, Dimension dimension) const;  ///< SI
    Vec3 point(const std::string& key) const;  ///< ["x mm", "y mm", "z mm"], [m]; 10 m at most
    std::vector<double> quantities(const std::string& key, Dimension dimension) const;
    std::vector<double> numbers(const std::string& key) const;
    std::vector<std::string> texts(const std::string& key) const;

    // The same with a default for a missing key.
    std::string text_or(const std::string& key, const std::string& fallback) const;
    double number_or(const std::string& key, double fallback) const;
    long integer_or(const std::string& key, long fallback) const;
    bool boolean_or(const std::string& key, bool fallback) const;
    double quantity_or(const std::string& key, Dimension dimension, double fallback) const;

    /// True if the value of the key is an array (a point rather than an arc length, say).
    bool is_array(const std::string& key) const;
    /// True if it is a string (a name rather than a number, say).
    bool is_text(const std::string& key) const;

    /// A sub-table; ConfigError if it is missing or not a table.
    TomlTable table(const std::string& key) const;
    /// A sub-table; an empty one, at the place of this table, if the key is missing.
    TomlTable table_or_empty(const std::string& key) const;
    /// An array of tables (`[[export]]`); empty if the key is missing.
    std::vector<TomlTable> tables(const std::string& key) const;
    /// The keys of this table in the order of the file.
    std::vector<std::string> keys() const;

    /// Refuses every key, here and in the sub-tables that were opened, that was never asked for.
    /// @throws ConfigError "unknown key ..., did you mean ...?"
    void finish() const;

    /// Refuses numeric values that were read, here and in the sub-tables that were opened, if they
    /// lie outside the range of their key: "case.toml:14: device.diameter = "4 m" is out of range;
    /// allowed are 0.5 mm to 60 mm".
    /// @param ranges  one for each numeric key of the file; every number of an array is held to it
    /// @throws ConfigError; std::logic_error for a numeric key without a range
    void require_ranges(const KeyRanges& ranges) const;

    /// "case.toml:14: device.diameter", for messages about the value of a key.
    std::string where(const std::string& key) const;
    /// The folder of the file: relative paths in it start here.
    std::filesystem::path folder() const;
    /// The whole document, overrides applied, as TOML text.
    std::string document_text() const;

    struct State;

private:
    explicit TomlTable(std::shared_ptr<State> state);
    std::shared_ptr<State> state_;
};

}  // namespace braidzone
