#include "export/device_vtp.hpp"

#include "export/braid_cells.hpp"

namespace braidzone {

void write_device(const std::filesystem::path& path, const Deployment& deployment,
                  const ResistanceSheet& sheet, const LengthUnit& unit)
{
    write_braid_cells(path, deployed_layout(deployment, sheet.surface), deployment, sheet, unit);
}

}  // namespace braidzone
