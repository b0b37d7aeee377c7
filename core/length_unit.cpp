#include "core/length_unit.hpp"

#include "core/error.hpp"

#include <fmt/format.h>

namespace braidzone {

LengthUnit length_unit(const std::string& name)
{
    for (const LengthUnit& unit : {LengthUnit{"m", 1.0}, LengthUnit{"cm", 1e-2},
                                   LengthUnit{"mm", 1e-3}, LengthUnit{"um", 1e-6}}) {
        if (unit.name == name) return unit;
    }
    throw ConfigError(fmt::format("\"{}\" is not a length unit; allowed are m, cm, mm, um", name));
}

}  // namespace braidzone
