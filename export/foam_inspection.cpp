#include "export/foam_inspection.hpp"

#include "export/foam_field.hpp"

#include <fmt/format.h>

namespace braidzone {

std::vector<std::filesystem::path> write_inspection_fields(const std::filesystem::path& foam_case,
                                                           const FoamMesh& mesh,
                                                           const CellResistance& resistance,
                                                           const std::vector<FoamZone>& zones)
{
    const std::filesystem::path start = start_folder(foam_case);
    const std::size_t num_cells = mesh.cell_volumes.size();
    std::vector<std::string> darcy(num_cells, "0"), forchheimer(num_cells, "0");
    std::vector<std::string> normal(num_cells, "(0 0 0)"), zone_of(num_cells, "-1");
    for (std::size_t i = 0; i < resistance.cells.size(); ++i) {
        const auto cell = static_cast<std::size_t>(resistance.cells[i]);
        darcy[cell] = fmt::format("{:.9g}", resistance.darcy[i]);
        forchheimer[cell] = fmt::format("{:.9g}", resistance.forchheimer[i]);
        const Vec3& n = resistance.normal[i];
        normal[cell] = fmt::format("({:.9g} {:.9g} {:.9g})", n.x(), n.y(), n.z());
    }
    std::vector<std::string> voids(num_cells, "1"), density(num_cells, "0");
    for (std::size_t i = 0; i < resistance.metal.cells.size(); ++i) {
        const auto cell = static_cast<std::size_t>(resistance.metal.cells[i]);
        voids[cell] = fmt::format("{:.9g}", resistance.metal.void_fraction[i]);
        density[cell] = fmt::format("{:.9g}", resistance.metal.surface_density[i]);
    }
    for (std::size_t zone = 0; zone < zones.size(); ++zone)
        for (const int cell : zones[zone].cells)
            zone_of[static_cast<std::size_t>(cell)] = std::to_string(zone);

    const std::string no_dimension = "[0 0 0 0 0 0 0]";
    const auto folder = foam_case / start;
    write_foam_field(folder, {"fdDarcy", "scalar", "[0 -2 0 0 0 0 0]", "0"}, darcy, mesh);
    write_foam_field(folder, {"fdForchheimer", "scalar", "[0 -1 0 0 0 0 0]", "0"}, forchheimer,
                     mesh);
    write_foam_field(folder, {"fdNormal", "vector", no_dimension, "(0 0 0)"}, normal, mesh);
    write_foam_field(folder, {"fdVoidFraction", "scalar", no_dimension, "1"}, voids, mesh);
    write_foam_field(folder, {"fdSurfaceDensity", "scalar", "[0 -1 0 0 0 0 0]", "0"}, density,
                     mesh);
    write_foam_field(folder, {"fdZone", "scalar", no_dimension, "-1"}, zone_of, mesh);
    return {start / "fdDarcy",        start / "fdForchheimer",    start / "fdNormal",
            start / "fdVoidFraction", start / "fdSurfaceDensity", start / "fdZone"};
}

}  // namespace braidzone
