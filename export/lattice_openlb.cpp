#include "export/lattice_openlb.hpp"

#include "core/error.hpp"
#include "export/vdb_mark.hpp"
#include "export/vtk_output.hpp"

#include <fmt/format.h>
#include <openvdb/io/File.h>
#include <openvdb/openvdb.h>
#include <vtkDoubleArray.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkUnsignedCharArray.h>
#include <vtkXMLImageDataWriter.h>

#include <array>

namespace braidzone {

namespace {

vtkNew<vtkDoubleArray> sparse_array(const char* name, const LatticeNodes& nodes,
                                    const std::vector<double>& values)
{
    vtkNew<vtkDoubleArray> array;
    array->SetName(name);
    array->SetNumberOfComponents(1);
    array->SetNumberOfTuples(static_cast<vtkIdType>(nodes.type.size()));
    array->FillValue(0.0);
    for (std::size_t i = 0; i < values.size(); ++i)
        array->SetValue(nodes.resisting[i], values[i]);
    return array;
}

void write_image(const std::filesystem::path& path, const LatticeNodes& nodes)
{
    const auto& [nx, ny, nz] = nodes.grid.dims;
    const double h = nodes.grid.spacing;
    vtkNew<vtkImageData> image;
    image->SetDimensions(nx, ny, nz);
    image->SetSpacing(h, h, h);
    vtkNew<vtkUnsignedCharArray> flags;
    flags->SetName("flags");
    flags->SetNumberOfComponents(1);
    flags->SetNumberOfTuples(static_cast<vtkIdType>(nodes.type.size()));
    for (std::size_t node = 0; node < nodes.type.size(); ++node)
        flags->SetValue(static_cast<vtkIdType>(node), nodes.type[node]);
    image->GetPointData()->AddArray(flags);
    image->GetPointData()->AddArray(sparse_array("darcy_d", nodes, nodes.darcy));
    image->GetPointData()->AddArray(sparse_array("forchheimer_f", nodes, nodes.forchheimer));
    vtkNew<vtkXMLImageDataWriter> writer;
    writer->SetInputData(image);
    write_vtk_text(path, *writer);
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
    try {
        openvdb::io::File file(path.string());
        file.write({grid});
        file.close();
    } catch (const openvdb::Exception& error) {
        throw IoError(fmt::format("{}: {}", path.string(), error.what()));
    }
    replace_vdb_mark(path);
}

}  // namespace

void write_openlb(const std::filesystem::path& folder, const LatticeNodes& nodes,
                  const Fluid& fluid, const LatticeUnits& units)
{
    write_porosity(folder / "olb_porosity.vdb", nodes, fluid, units);
    write_image(folder / "case.vti", nodes);
}

}  // namespace braidzone
