#include "discrepancy/measured_scalars.hpp"

#include "core/error.hpp"

#include <fmt/format.h>

#include <string>

namespace braidzone {
namespace {

/// True if both keys are there, false if none is.
bool has_both(const TomlTable& table, const std::string& key, const std::string& other,
              const std::string& reason)
{
    if (table.has(key) == table.has(other)) return table.has(key);
    const bool has_first = table.has(key);
    throw ConfigError(fmt::format("{} stands without {}; {}", table.where(has_first ? key : other),
                                  has_first ? other : key, reason));
}

bool has_value(const TomlTable& table, const std::string& key)
{
    return has_both(table, key, key + "_sd", "a measured value needs both");
}

/// The standard deviation of a value.
double sd_of(const TomlTable& table, const std::string& value_key, Dimension dimension)
{
    const std::string key = value_key + "_sd";
    const double sd = table.quantity(key, dimension);
    if (sd > 0.0) return sd;
    const std::string found = dimension == Dimension::length ? fmt::format("{:.6g} mm", 1e3 * sd)
                                                             : format_quantity(sd, dimension);
    throw ConfigError(
        fmt::format("{} = {}; a standard deviation must be positive", table.where(key), found));
}

std::optional<MeasuredContactForce> contact_force_of(const TomlTable& table)
{
    const std::string key = "contact_force", from = key + "_from", to = key + "_to";
    const bool has_stretch = has_both(table, from, to, "a stretch has two ends");
    if (!has_value(table, key)) {
        if (!has_stretch) return std::nullopt;
        throw ConfigError(fmt::format("{} stands without {}", table.where(from), key));
    }
    MeasuredContactForce measured;
    measured.force = {table.quantity(key, Dimension::force), sd_of(table, key, Dimension::force)};
    if (!(measured.force.value > 0.0)) {
        throw ConfigError(fmt::format("{} = {:.6g} N; a force on the wall must be positive",
                                      table.where(key), measured.force.value));
    }
    if (!has_stretch) return measured;
    measured.from = table.quantity(from, Dimension::length);
    measured.to = table.quantity(to, Dimension::length);
    if (!(measured.from < measured.to)) {
        throw ConfigError(fmt::format("{} = {:.6g} mm; it must be less than {} = {:.6g} mm",
                                      table.where(from), 1e3 * measured.from, to,
                                      1e3 * measured.to));
    }
    return measured;
}

/// Places on a centerline of 2 m at most, and forces up to a hundred times that of a stiff device.
const KeyRanges& scalar_ranges()
{
    static const KeyRanges ranges = {
        {"distal_end", "-2 m", "2 m"},         {"distal_end_sd", "0 mm", "2 m"},
        {"proximal_end", "-2 m", "2 m"},       {"proximal_end_sd", "0 mm", "2 m"},
        {"implanted_length", "0 mm", "2 m"},   {"implanted_length_sd", "0 mm", "2 m"},
        {"contact_force", "0 N", "1000 N"},    {"contact_force_sd", "0 N", "1000 N"},
        {"contact_force_from", "-2 m", "2 m"}, {"contact_force_to", "-2 m", "2 m"}};
    return ranges;
}

}  // namespace

MeasuredScalars read_measured_scalars(const TomlTable& table, const Centerline& centerline)
{
    MeasuredScalars scalars;
    for (std::size_t i = 0; i < scalar_names.size(); ++i) {
        const std::string key(scalar_names[i]);
        if (!has_value(table, key)) continue;
        MeasuredValue measured;
        measured.value = key != "implanted_length" && table.is_array(key)
                             ? nearest_arc_length(centerline, table.point(key))
                             : table.quantity(key, Dimension::length);
        measured.sd = sd_of(table, key, Dimension::length);
        scalars.values[i] = measured;
    }
    scalars.contact_force = contact_force_of(table);
    table.finish();
    table.require_ranges(scalar_ranges());
    return scalars;
}

}  // namespace braidzone
