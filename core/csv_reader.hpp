#pragma once

#include "core/error.hpp"

#include <filesystem>
#include <fstream>
#include <optional>
#include <string>

namespace braidzone {

/// Reads a file of comma-separated values line by line: a header, then what follows it. Lines come
/// without their end, whether that is of Unix or of Windows. `csv_fields` takes them apart.
class CsvReader {
public:
    /// Opens the file and reads its first line.
    /// @throws IoError if it cannot be read
    explicit CsvReader(const std::filesystem::path& path);

    /// The first line; empty if the file is.
    const std::string& header() const { return header_; }

    /// The next line; none at the end.
    /// @throws IoError if the file cannot be read to its end
    std::optional<std::string> next();

    /// Number of the line that was read last; the header is line 1.
    int line_number() const { return line_number_; }

    /// What to throw about a line: "FILE:LINE: finding".
    InputError refusal(int line, const std::string& finding) const;
    /// The same about the line that was read last.
    InputError refusal(const std::string& finding) const;

private:
    std::filesystem::path path_;
    std::ifstream file_;
    std::string header_;
    int line_number_ = 0;
};

}  // namespace braidzone
