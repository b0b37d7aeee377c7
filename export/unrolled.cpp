#include "export/unrolled.hpp"

#include "export/braid_cells.hpp"

namespace braidzone {

void write_unrolled(const std::filesystem::path& path, const Deployment& deployment,
                    const ResistanceSheet& sheet, const LengthUnit& unit)
{
    write_braid_cells(path, unrolled_layout(deployment.lattice), deployment, sheet, unit);
}

}  // namespace braidzone
