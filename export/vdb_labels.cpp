#include "export/vdb_labels.hpp"

#include "core/error.hpp"

#include <fmt/format.h>

namespace braidzone {

void require_vdb_spacing(const std::string& key, double spacing, const LengthUnit& unit)
{
    constexpr double least = 1.45e-5;
    if (spacing / unit.metres >= least) return;
    throw ConfigError(fmt::format(
        "{} = {:.6g} mm is {:.6g} of the vessel's length unit, {}; OpenVDB takes voxels "
        "of {:.3g} or more: state the vessel in a smaller unit, or raise {}",
        key, 1e3 * spacing, spacing / unit.metres, unit.name, least, key));
}

}  // namespace braidzone
