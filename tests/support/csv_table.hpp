#pragma once

#include "core/csv_fields.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace braidzone::test {

/// Numbers under named columns.
struct CsvTable {
    std::vector<std::string> columns;
    std::vector<std::vector<double>> rows;

    /// @throws std::out_of_range if there is no such row or column
    double at(std::size_t row, const std::string& column) const
    {
        const auto found = std::find(columns.begin(), columns.end(), column);
        return rows.at(row).at(static_cast<std::size_t>(found - columns.begin()));
    }
};

/// @throws std::runtime_error if the file is missing, has no row, or has a field that is no number
inline CsvTable read_csv_table(const std::filesystem::path& path)
{
    std::ifstream file(path);
    CsvTable table;
    std::string line;
    if (std::getline(file, line)) {
        for (const std::string_view field : csv_fields(line))
            table.columns.emplace_back(field);
    }
    while (std::getline(file, line)) {
        std::vector<double> row;
        for (const std::string_view field : csv_fields(line)) {
            const std::optional<double> number = csv_number(field);
            if (!number) throw std::runtime_error(path.string() + ": not a number: " + line);
            row.push_back(*number);
        }
        if (row.size() != table.columns.size()) {
            throw std::runtime_error(path.string() + ": not one field a column: " + line);
        }
        table.rows.push_back(row);
    }
    if (table.rows.empty()) throw std::runtime_error(path.string() + ": missing or empty");
    return table;
}

}  // namespace braidzone::test
