#include "export/field_vti.hpp"

#include "export/vtk_output.hpp"

#include <vtkCellData.h>
#include <vtkFloatArray.h>
#include <vtkImageAlgorithm.h>
#include <vtkImageData.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkNew.h>
#include <vtkStreamingDemandDrivenPipeline.h>
#include <vtkUnsignedCharArray.h>
#include <vtkXMLImageDataWriter.h>

#include <algorithm>
#include <array>
#include <vector>

namespace braidzone {

namespace {

/// Voxels of a piece of the image. Only one piece is in memory at a time.
constexpr std::size_t piece_size = 4000000;

/// A box of voxels within the grid.
struct PieceBox {
    std::array<int, 3> first{}, size{};

    bool holds(const std::array<int, 3>& voxel) const
    {
        for (std::size_t axis = 0; axis < 3; ++axis)
            if (voxel[axis] < first[axis] || voxel[axis] >= first[axis] + size[axis]) return false;
        return true;
    }
    vtkIdType index(const std::array<int, 3>& voxel) const
    {
        const vtkIdType i = voxel[0] - first[0], j = voxel[1] - first[1], k = voxel[2] - first[2];
        return i + size[0] * (j + size[1] * k);
    }
    vtkIdType num_voxels() const { return static_cast<vtkIdType>(size[0]) * size[1] * size[2]; }
};

/// A touched voxel of the field that lies in a piece.
struct PieceVoxel {
    std::size_t touched = 0;  ///< its place in the field's lists
    vtkIdType index = 0;      ///< in the piece
};

/// One piece of the image with its arrays.
class PieceWriter {
public:
    PieceWriter(vtkFieldData& fields, const PorousField& field, const PieceBox& box)
        : fields_(fields), field_(field), box_(box)
    {
        for (std::size_t i = 0; i < field.voxels.size(); ++i) {
            const std::array<int, 3> place = place_of(field.grid, field.voxels[i]);
            if (box.holds(place)) touched_.push_back({i, box.index(place)});
        }
    }

    /// An array of values of the touched voxels; `elsewhere` for the others.
    void add_sparse(const char* name, const std::vector<double>& values, float elsewhere)
    {
        vtkNew<vtkFloatArray> array;
        array->SetName(name);
        array->SetNumberOfTuples(box_.num_voxels());
        array->FillValue(elsewhere);
        for (const PieceVoxel& voxel : touched_)
            array->SetValue(voxel.index, static_cast<float>(values[voxel.touched]));
        fields_.AddArray(array);
    }

    void add_normal()
    {
        vtkNew<vtkFloatArray> array;
        array->SetName("normal");
        array->SetNumberOfComponents(3);
        array->SetNumberOfTuples(box_.num_voxels());
        array->FillValue(0.0F);
        for (const PieceVoxel& voxel : touched_) {
            const Eigen::Vector3f normal = field_.normal[voxel.touched].cast<float>();
            array->SetTypedTuple(voxel.index, normal.data());
        }
        fields_.AddArray(array);
    }

    void add_wall_distance_and_cell_type()
    {
        vtkNew<vtkFloatArray> distances;
        distances->SetName("wall_distance");
        distances->SetNumberOfTuples(box_.num_voxels());
        vtkNew<vtkUnsignedCharArray> types;
        types->SetName("cell_type");
        types->SetNumberOfTuples(box_.num_voxels());
        vtkIdType index = 0;
        for (int k = box_.first[2]; k < box_.first[2] + box_.size[2]; ++k) {
            for (int j = box_.first[1]; j < box_.first[1] + box_.size[1]; ++j) {
                for (int i = box_.first[0]; i < box_.first[0] + box_.size[0]; ++i, ++index) {
                    const float distance = distance_at(field_.wall_distance, i, j, k);
                    const CellType type = distance < 0.0F ? CellType::fluid : CellType::outside;
                    distances->SetValue(index, distance);
                    types->SetValue(index, static_cast<unsigned char>(type));
                }
            }
        }
        for (const PieceVoxel& voxel : touched_)
            types->SetValue(voxel.index,
                            static_cast<unsigned char>(cell_type(field_, voxel.touched)));
        fields_.AddArray(distances);
        fields_.AddArray(types);
    }

private:
    vtkFieldData& fields_;
    const PorousField& field_;
    PieceBox box_;
    std::vector<PieceVoxel> touched_;
};

/// The field as a source of an image, which makes the piece that is asked for.
class FieldSource : public vtkImageAlgorithm {
public:
    static FieldSource* New()
    {
        auto* source = new FieldSource;
        source->InitializeObjectBase();
        return source;
    }

    /// Both must outlive the source.
    void show(const PorousField& field, const LengthUnit& unit)
    {
        field_ = &field;
        unit_ = &unit;
        darcy_tangential_ = darcy_tangential(field);
        forchheimer_tangential_ = forchheimer_tangential(field);
        linear_ = pressure_loss_linear(field);
        quadratic_ = pressure_loss_quadratic(field);
    }

protected:
    FieldSource() { SetNumberOfInputPorts(0); }

    int RequestInformation(vtkInformation* /*request*/, vtkInformationVector** /*inputs*/,
                           vtkInformationVector* outputs) override
    {
        vtkInformation* information = outputs->GetInformationObject(0);
        const auto& [nx, ny, nz] = field_->grid.dims;
        const std::array<int, 6> whole{0, nx, 0, ny, 0, nz};
        information->Set(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), whole.data(), 6);
        const double spacing = field_->grid.spacing / unit_->metres;
        // VTK's origin is the corner of the first cell.
        const Vec3 corner = field_->grid.origin / unit_->metres - Vec3::Constant(0.5 * spacing);
        information->Set(vtkDataObject::SPACING(), spacing, spacing, spacing);
        information->Set(vtkDataObject::ORIGIN(), corner.data(), 3);
        information->Set(CAN_PRODUCE_SUB_EXTENT(), 1);
        return 1;
    }

    int RequestData(vtkInformation* /*request*/, vtkInformationVector** /*inputs*/,
                    vtkInformationVector* outputs) override
    {
        vtkInformation* information = outputs->GetInformationObject(0);
        std::array<int, 6> extent{};
        information->Get(vtkStreamingDemandDrivenPipeline::UPDATE_EXTENT(), extent.data());
        vtkImageData* image = vtkImageData::GetData(information);
        image->SetExtent(extent.data());
        image->SetSpacing(information->Get(vtkDataObject::SPACING()));
        image->SetOrigin(information->Get(vtkDataObject::ORIGIN()));
        PieceBox box;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            box.first[axis] = extent[2 * axis];
            box.size[axis] = extent[2 * axis + 1] - extent[2 * axis];
        }
        PieceWriter piece(*image->GetCellData(), *field_, box);
        piece.add_sparse("void_fraction", field_->void_fraction, 1.0F);
        piece.add_sparse("surface_density", field_->surface_density, 0.0F);
        piece.add_sparse("darcy_normal", field_->darcy_normal, 0.0F);
        piece.add_sparse("darcy_tangential", darcy_tangential_, 0.0F);
        piece.add_sparse("forchheimer_normal", field_->forchheimer_normal, 0.0F);
        piece.add_sparse("forchheimer_tangential", forchheimer_tangential_, 0.0F);
        piece.add_sparse("pressure_loss_linear", linear_, 0.0F);
        piece.add_sparse("pressure_loss_quadratic", quadratic_, 0.0F);
        piece.add_normal();
        piece.add_wall_distance_and_cell_type();
        image->GetCellData()->SetActiveScalars("darcy_normal");
        add_units(*image, *unit_,
                  {{"void_fraction", "1"},
                   {"surface_density", "1/m"},
                   {"darcy_normal", "1/m^2"},
                   {"darcy_tangential", "1/m^2"},
                   {"forchheimer_normal", "1/m"},
                   {"forchheimer_tangential", "1/m"},
                   {"pressure_loss_linear", "Pa s/m"},
                   {"pressure_loss_quadratic", "Pa s^2/m^2"},
                   {"normal", "1"},
                   {"wall_distance", "m"},
                   {"cell_type", "1"}});
        return 1;
    }

private:
    const PorousField* field_ = nullptr;
    const LengthUnit* unit_ = nullptr;
    std::vector<double> darcy_tangential_, forchheimer_tangential_, linear_, quadratic_;
};

}  // namespace

void write_field_vti(const std::filesystem::path& path, const PorousField& field,
                     const LengthUnit& unit)
{
    vtkNew<FieldSource> source;
    source->show(field, unit);
    vtkNew<vtkXMLImageDataWriter> writer;
    const std::size_t num_pieces = (field.grid.num_voxels() + piece_size - 1) / piece_size;
    writer->SetNumberOfPieces(static_cast<int>(num_pieces));
    writer->SetInputConnection(source->GetOutputPort());
    write_vtk_xml(path, *writer);
}

}  // namespace braidzone
