#include "core/error.hpp"
#include "export/field_vti.hpp"
#include "support/fields.hpp"
#include "support/temporary_folder.hpp"

#include <gtest/gtest.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkSmartPointer.h>
#include <vtkStringArray.h>
#include <vtkXMLImageDataReader.h>

#include <cmath>
#include <fstream>
#include <iterator>

namespace braidzone {
namespace {

const LengthUnit millimetre{"mm", 1e-3};

vtkSmartPointer<vtkImageData> read(const std::filesystem::path& path)
{
    vtkNew<vtkXMLImageDataReader> reader;
    reader->SetFileName(path.c_str());
    reader->Update();
    return reader->GetOutput();
}

std::string content(const std::filesystem::path& path)
{
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

class FieldVti : public testing::Test {
protected:
    FieldVti()
    {
        write_field_vti(path, field, millimetre);
        image = read(path);
    }

    /// The image's cell around a point of the field [m], found by VTK from the geometry.
    vtkIdType cell_at(const Vec3& point) const
    {
        Vec3 position = point / millimetre.metres;
        int sub_id = 0;
        double coordinates[3], weights[8];
        return image->FindCell(position.data(), nullptr, -1, 0.0, sub_id, coordinates, weights);
    }
    double value(const char* name, vtkIdType cell, int component = 0) const
    {
        return image->GetCellData()->GetArray(name)->GetComponent(cell, component);
    }

    test::TemporaryFolder folder;
    std::filesystem::path path = folder.path() / "field.vti";
    PorousField field = test::asymmetric_field();
    vtkSmartPointer<vtkImageData> image;
};

TEST_F(FieldVti, EveryVoxelIsFoundAtItsPlace)
{
    ASSERT_EQ(image->GetNumberOfCells(), 4 * 5 * 6);
    for (int k = 0; k < 6; ++k) {
        for (int j = 0; j < 5; ++j) {
            for (int i = 0; i < 4; ++i) {
                const vtkIdType cell = cell_at(field.grid.centre(i, j, k));
                const std::size_t index = field.grid.index(i, j, k);
                EXPECT_EQ(value("wall_distance", cell),
                          static_cast<double>(distance_at(field.wall_distance, i, j, k)));
                EXPECT_EQ(value("cell_type", cell),
                          static_cast<int>(test::expected_cell_type(field, index)));
            }
        }
    }
}

TEST_F(FieldVti, TouchedVoxelsHoldTheirValues)
{
    const std::array<Vec3, 2> places{field.grid.centre(1, 2, 3), field.grid.centre(2, 0, 5)};
    for (std::size_t i = 0; i < 2; ++i) {
        const vtkIdType cell = cell_at(places[i]);
        EXPECT_FLOAT_EQ(value("void_fraction", cell), field.void_fraction[i]);
        EXPECT_FLOAT_EQ(value("surface_density", cell), field.surface_density[i]);
        EXPECT_FLOAT_EQ(value("darcy_normal", cell), field.darcy_normal[i]);
        EXPECT_FLOAT_EQ(value("darcy_tangential", cell), 2.0 * field.darcy_normal[i]);
        EXPECT_FLOAT_EQ(value("forchheimer_normal", cell), field.forchheimer_normal[i]);
        EXPECT_FLOAT_EQ(value("forchheimer_tangential", cell), 0.5 * field.forchheimer_normal[i]);
        EXPECT_FLOAT_EQ(value("pressure_loss_linear", cell), pressure_loss_linear(field)[i]);
        EXPECT_FLOAT_EQ(value("pressure_loss_quadratic", cell), pressure_loss_quadratic(field)[i]);
        for (int c = 0; c < 3; ++c) {
            EXPECT_FLOAT_EQ(value("normal", cell, c), field.normal[i][c]);
        }
    }
}

TEST_F(FieldVti, OtherVoxelsAreFreeOfMetalAndResistance)
{
    int untouched = 0;
    for (vtkIdType cell = 0; cell < image->GetNumberOfCells(); ++cell) {
        if (cell == field.voxels[0] || cell == field.voxels[1]) continue;
        ++untouched;
        EXPECT_EQ(value("void_fraction", cell), 1.0);
        for (const char* name :
             {"surface_density", "darcy_normal", "darcy_tangential", "forchheimer_normal"}) {
            EXPECT_EQ(value(name, cell), 0.0) << name;
        }
        for (int c = 0; c < 3; ++c)
            EXPECT_EQ(value("normal", cell, c), 0.0);
    }
    EXPECT_EQ(untouched, 118);
}

TEST_F(FieldVti, StatesItsUnits)
{
    const auto text = [&](const char* name) -> std::string {
        auto* array = vtkStringArray::SafeDownCast(image->GetFieldData()->GetAbstractArray(name));
        return array == nullptr ? "absent" : array->GetValue(0);
    };
    EXPECT_EQ(text("length_unit"), "mm");
    EXPECT_EQ(text("unit:darcy_normal"), "1/m^2");
    EXPECT_EQ(text("unit:wall_distance"), "m");
    for (int i = 0; i < image->GetCellData()->GetNumberOfArrays(); ++i) {
        const std::string name = image->GetCellData()->GetArrayName(i);
        EXPECT_NE(text(("unit:" + name).c_str()), "absent") << name;
    }
}

// Single precision keeps the resistance integral to far better than 1e-6.
TEST_F(FieldVti, KeepsTheResistanceIntegral)
{
    vtkDataArray* darcy = image->GetCellData()->GetArray("darcy_normal");
    double sum = 0.0;
    for (vtkIdType i = 0; i < darcy->GetNumberOfTuples(); ++i)
        sum += darcy->GetComponent(i, 0);
    const double edge = image->GetSpacing()[0] * millimetre.metres;
    const double exact = resistance_integral(field);
    EXPECT_NEAR(sum * edge * edge * edge, exact, 1e-6 * exact);
}

TEST_F(FieldVti, IsTheSameBytesEachTime)
{
    const std::filesystem::path again = folder.path() / "again.vti";
    write_field_vti(again, field, millimetre);
    EXPECT_EQ(content(again), content(path));
}

TEST_F(FieldVti, UnwritablePathIsReported)
{
    const std::filesystem::path nowhere = folder.path() / "absent" / "field.vti";
    try {
        write_field_vti(nowhere, field, millimetre);
        FAIL() << "nothing was thrown";
    } catch (const IoError& error) {
        EXPECT_NE(std::string(error.what()).find(nowhere.string()), std::string::npos);
    }
}

}  // namespace
}  // namespace braidzone
