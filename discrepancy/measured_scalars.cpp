#include "discrepancy/measured_scalars.hpp"

#include "core/error.hpp"

#include <fmt/format.h>

#include <string>

namespace braidzone {

MeasuredScalars read_measured_scalars(const TomlTable& table, const Centerline& centerline)
{
    MeasuredScalars scalars;
    for (std::size_t i = 0; i < scalar_names.size(); ++i) {
        const std::string key(scalar_names[i]), sd_key = key + "_sd";
        if (table.has(key) != table.has(sd_key)) {
            const std::string& given = table.has(key) ? key : sd_key;
            throw ConfigError(fmt::format("{} stands without {}; a measured value needs both",
                                          table.where(given), table.has(key) ? sd_key : key));
        }
        if (!table.has(key)) continue;
        MeasuredValue measured;
        measured.value = key != "implanted_length" && table.is_array(key)
                             ? nearest_arc_length(centerline, table.point(key))
                             : table.quantity(key, Dimension::length);
        measured.sd = table.quantity(sd_key, Dimension::length);
        if (!(measured.sd > 0.0)) {
            throw ConfigError(fmt::format("{} = {:.6g} mm; a standard deviation must be positive",
                                          table.where(sd_key), 1e3 * measured.sd));
        }
        scalars.values[i] = measured;
    }
    table.finish();
    return scalars;
}

}  // namespace braidzone
