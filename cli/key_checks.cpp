#include "cli/key_checks.hpp"

#include "core/error.hpp"
#include "core/nearest_name.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace braidzone {

double require_positive(const TomlTable& table, const std::string& key, double value,
                        double highest)
{
    if (value > 0.0 && value <= highest) return value;
    throw ConfigError(fmt::format("{} = {:.6g} is out of range; it must be positive{}",
                                  table.where(key), value,
                                  value > highest ? fmt::format(", {:.6g} at most", highest) : ""));
}

double require_not_negative(const TomlTable& table, const std::string& key, double value)
{
    if (value >= 0.0) return value;
    throw ConfigError(fmt::format("{} = {:.6g} is negative", table.where(key), value));
}

double positive_or(const TomlTable& table, const std::string& key, Dimension dimension,
                   double fallback)
{
    const double value = table.quantity_or(key, dimension, fallback);
    if (value > 0.0) return value;
    throw ConfigError(fmt::format("{} = {:.6g} {} is out of range; it must be positive",
                                  table.where(key), value, si_unit(dimension)));
}

int integer_in_range(const TomlTable& table, const std::string& key, int fallback, int lowest,
                     int highest)
{
    const long value = table.integer_or(key, fallback);
    if (value >= lowest && value <= highest) return static_cast<int>(value);
    throw ConfigError(fmt::format("{} = {} is out of range; allowed are {} to {}", table.where(key),
                                  value, lowest, highest));
}

std::string one_of(const TomlTable& table, const std::string& key, const std::string& fallback,
                   const std::vector<std::string>& allowed)
{
    const std::string name = table.text_or(key, fallback);
    if (std::find(allowed.begin(), allowed.end(), name) != allowed.end()) return name;
    throw ConfigError(fmt::format("{} = \"{}\" is not known{}", table.where(key), name,
                                  did_you_mean(name, allowed)));
}

std::filesystem::path file_path(const TomlTable& table, const std::string& key)
{
    const std::string text = table.text(key);
    if (text.empty())
        throw ConfigError(fmt::format("{} is empty; expected is a file", table.where(key)));
    return (table.folder() / text).lexically_normal();
}

std::vector<std::size_t> some_of(const TomlTable& table, const std::string& key,
                                 const std::vector<std::string>& allowed)
{
    std::vector<std::size_t> places;
    for (const std::string& name : table.texts(key)) {
        const auto found = std::find(allowed.begin(), allowed.end(), name);
        if (found == allowed.end()) {
            throw ConfigError(fmt::format("{}: \"{}\" is not known{}", table.where(key), name,
                                          did_you_mean(name, allowed)));
        }
        const auto place = static_cast<std::size_t>(found - allowed.begin());
        if (std::find(places.begin(), places.end(), place) != places.end())
            throw ConfigError(fmt::format("{}: \"{}\" is given twice", table.where(key), name));
        places.push_back(place);
    }
    if (!places.empty()) return places;
    throw ConfigError(
        fmt::format("{} is empty; known are {}", table.where(key), fmt::join(allowed, ", ")));
}

}  // namespace braidzone
