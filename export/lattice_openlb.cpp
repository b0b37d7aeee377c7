#include "export/lattice_openlb.hpp"

#include "core/error.hpp"
#include "export/binary_file.hpp"
#include "export/resisting_planes.hpp"
#include "export/vdb_file.hpp"

#include <fmt/format.h>
#include <openvdb/io/File.h>
#include <openvdb/openvdb.h>

#include <iterator>
#include <string>
#include <vector>

namespace braidzone {

namespace {

/// Writes an array of a number a node as text, a line for each x-row.
/// @param plane_text  of the nodes of a plane across z
template <typename PlaneText>
void write_data_array(BinaryFile& file, const char* type, const char* name,
                      const LatticeNodes& nodes, PlaneText plane_text)
{
    file.write(fmt::format(
        "<DataArray type=\"{}\" Name=\"{}\" NumberOfComponents=\"1\" format=\"ascii\">\n", type,
        name));
    for (int k = 0; k < nodes.grid.dims[2]; ++k)
        file.write(plane_text(k));
    file.write("</DataArray>\n");
}

/// Text of a plane of numbers that are 0 but at the resisting nodes.
std::string sparse_plane(const LatticeNodes& nodes, const ResistingPlanes& planes,
                         const std::vector<double>& values, int k)
{
    std::string text;
    const std::size_t first = nodes.grid.index(0, 0, k), end = nodes.grid.index(0, 0, k + 1);
    const auto row = static_cast<std::size_t>(nodes.grid.dims[0]);
    const auto resisting = planes.in_plane(k);
    auto next = resisting.begin();
    for (std::size_t node = first; node < end; ++node) {
        if (next != resisting.end() && static_cast<std::size_t>(nodes.resisting[*next]) == node)
            fmt::format_to(std::back_inserter(text), "{:.9g}", values[*next++]);
        else
            text += '0';
        text += (node + 1) % row == 0 ? '\n' : ' ';
    }
    return text;
}

std::string type_plane(const LatticeNodes& nodes, int k)
{
    std::string text;
    const auto row = static_cast<std::size_t>(nodes.grid.dims[0]);
    for (std::size_t node = nodes.grid.index(0, 0, k); node < nodes.grid.index(0, 0, k + 1); ++node)
        fmt::format_to(std::back_inserter(text), "{}{}", nodes.type[node],
                       (node + 1) % row == 0 ? '\n' : ' ');
    return text;
}

/// VTK's own writer takes whole arrays only, 17 bytes a node.
void write_image(const std::filesystem::path& path, const LatticeNodes& nodes)
{
    const auto& [nx, ny, nz] = nodes.grid.dims;
    const std::string extent = fmt::format("0 {} 0 {} 0 {}", nx - 1, ny - 1, nz - 1);
    BinaryFile file(path);
    file.write(fmt::format(R"(<?xml version="1.0"?>
<VTKFile type="ImageData" version="0.1" byte_order="LittleEndian">
<ImageData WholeExtent="{0}" Origin="0 0 0" Spacing="{1:.17g} {1:.17g} {1:.17g}">
<Piece Extent="{0}">
<PointData>
)",
                           extent, nodes.grid.spacing));
    const ResistingPlanes planes(nodes, 2);
    write_data_array(file, "UInt8", "flags", nodes, [&](int k) { return type_plane(nodes, k); });
    write_data_array(file, "Float64", "darcy_d", nodes,
                     [&](int k) { return sparse_plane(nodes, planes, nodes.darcy, k); });
    write_data_array(file, "Float64", "forchheimer_f", nodes,
                     [&](int k) { return sparse_plane(nodes, planes, nodes.forchheimer, k); });
    file.write("</PointData>\n<CellData>\n</CellData>\n</Piece>\n</ImageData>\n</VTKFile>\n");
    file.close();
}

void write_porosity(const std::filesystem::path& path, const LatticeNodes& nodes,
                    const Fluid& fluid, const LatticeUnits& units)
{
    const double most_drag = 1.0 / (3.0 * units.viscosity_lu);
    if (!(units.largest_drag_lu < most_drag)) {
        throw ConfigError(fmt::format(
            "export.targets: OpenLB's porous collision cannot express a drag of {:.4g} a time "
            "step; "
            "allowed is less than {:.4g} with this spacing and velocity_lu; lower velocity_lu",
            units.largest_drag_lu, most_drag));
    }
    openvdb::initialize();
    constexpr float all_fluid = 1.0F;
    const auto grid = openvdb::FloatGrid::create(all_fluid);
    grid->setName("porosity");
    grid->setGridClass(openvdb::GRID_FOG_VOLUME);
    grid->setSaveFloatAsHalf(false);
    constexpr double millimetres = 1e3;  // OpenVDB refuses voxels as small as ours in metres
    grid->setTransform(
        openvdb::math::Transform::createLinearTransform(millimetres * nodes.grid.spacing));
    grid->insertMeta("length_unit_m", openvdb::DoubleMetadata(1e-3));
    grid->insertMeta("time_step", openvdb::DoubleMetadata(units.time_step));
    grid->insertMeta("viscosity_lu", openvdb::DoubleMetadata(units.viscosity_lu));
    auto accessor = grid->getAccessor();
    const double kinematic_viscosity = fluid.viscosity / fluid.density;
    for (std::size_t i = 0; i < nodes.resisting.size(); ++i) {
        const double a = kinematic_viscosity * nodes.darcy[i] * units.time_step;
        const double d = 1.0 - units.relaxation_time_lu * a / (1.0 + 0.5 * a);
        const auto& [x, y, z] = place_of(nodes.grid, nodes.resisting[i]);
        accessor.setValue({x, y, z}, static_cast<float>(d));
    }
    write_vdb_file<openvdb::io::File, openvdb::Exception>(path, openvdb::GridCPtrVec{grid});
}

}  // namespace

std::vector<LatticeFile> write_openlb(const std::filesystem::path& folder,
                                      const LatticeNodes& nodes, const Fluid& fluid,
                                      const LatticeUnits& units)
{
    write_porosity(folder / "olb_porosity.vdb", nodes, fluid, units);
    write_image(folder / "case.vti", nodes);
    const std::vector<int> shape = shape_of(nodes.grid.dims);
    return {{"olb_porosity.vdb", "OpenVDB float grid \"porosity\"", shape, "by index (i, j, k)"},
            {"case.vti", "VTK image in text: flags, darcy_d [1/m^2], forchheimer_f [1/m]", shape,
             "first index fastest"}};
}

}  // namespace braidzone
