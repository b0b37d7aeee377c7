#include "export/field_vti.hpp"

#include "export/vtk_output.hpp"

#include <vtkCellData.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkUnsignedCharArray.h>
#include <vtkXMLImageDataWriter.h>

#include <algorithm>
#include <vector>

namespace braidzone {

namespace {

/// An array of all voxels from values of the touched ones; `elsewhere` for the others.
void add_sparse(vtkFieldData& fields, const char* name, const PorousField& field,
                const std::vector<double>& values, float elsewhere)
{
    vtkNew<vtkFloatArray> array;
    array->SetName(name);
    array->SetNumberOfTuples(static_cast<vtkIdType>(field.grid.num_voxels()));
    array->FillValue(elsewhere);
    for (std::size_t i = 0; i < values.size(); ++i) {
        array->SetValue(field.voxels[i], static_cast<float>(values[i]));
    }
    fields.AddArray(array);
}

void add_normal(vtkFieldData& fields, const PorousField& field)
{
    vtkNew<vtkFloatArray> array;
    array->SetName("normal");
    array->SetNumberOfComponents(3);
    array->SetNumberOfTuples(static_cast<vtkIdType>(field.grid.num_voxels()));
    array->FillValue(0.0F);
    for (std::size_t i = 0; i < field.normal.size(); ++i) {
        const Eigen::Vector3f normal = field.normal[i].cast<float>();
        array->SetTypedTuple(field.voxels[i], normal.data());
    }
    fields.AddArray(array);
}

void add_cell_type(vtkFieldData& fields, const PorousField& field)
{
    vtkNew<vtkUnsignedCharArray> array;
    array->SetName("cell_type");
    array->SetNumberOfTuples(static_cast<vtkIdType>(field.cell_type.size()));
    for (std::size_t i = 0; i < field.cell_type.size(); ++i) {
        array->SetValue(static_cast<vtkIdType>(i), static_cast<unsigned char>(field.cell_type[i]));
    }
    fields.AddArray(array);
}

}  // namespace

void write_field_vti(const std::filesystem::path& path, const PorousField& field,
                     const LengthUnit& unit)
{
    const double spacing = field.grid.spacing / unit.metres;
    // VTK's origin is the corner of the first cell.
    const Vec3 corner = field.grid.origin / unit.metres - Vec3::Constant(0.5 * spacing);
    const auto& [nx, ny, nz] = field.grid.dims;
    vtkNew<vtkImageData> image;
    image->SetOrigin(corner.data());
    image->SetSpacing(spacing, spacing, spacing);
    image->SetDimensions(nx + 1, ny + 1, nz + 1);

    vtkFieldData& fields = *image->GetCellData();
    add_sparse(fields, "void_fraction", field, field.void_fraction, 1.0F);
    add_sparse(fields, "surface_density", field, field.surface_density, 0.0F);
    add_sparse(fields, "darcy_normal", field, field.darcy_normal, 0.0F);
    add_sparse(fields, "darcy_tangential", field, field.darcy_tangential, 0.0F);
    add_sparse(fields, "forchheimer_normal", field, field.forchheimer_normal, 0.0F);
    add_normal(fields, field);
    vtkNew<vtkFloatArray> wall_distance;
    wall_distance->SetName("wall_distance");
    wall_distance->SetNumberOfTuples(static_cast<vtkIdType>(field.wall_distance.size()));
    std::copy(field.wall_distance.begin(), field.wall_distance.end(), wall_distance->GetPointer(0));
    fields.AddArray(wall_distance);
    add_cell_type(fields, field);

    add_units(*image, unit,
              {{"void_fraction", "1"},
               {"surface_density", "1/m"},
               {"darcy_normal", "1/m^2"},
               {"darcy_tangential", "1/m^2"},
               {"forchheimer_normal", "1/m"},
               {"normal", "1"},
               {"wall_distance", "m"},
               {"cell_type", "1"}});
    vtkNew<vtkXMLImageDataWriter> writer;
    write_vtk_xml(path, *writer, *image);
}

}  // namespace braidzone
