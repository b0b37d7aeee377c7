#include "core/error.hpp"
#include "deploy/deployment_measures.hpp"
#include "export/device_vtp.hpp"
#include "support/braids.hpp"
#include "support/devices.hpp"
#include "support/temporary_folder.hpp"

#include <gtest/gtest.h>
#include <vtkCell.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkStringArray.h>
#include <vtkXMLPolyDataReader.h>

#include <cmath>
#include <numbers>

namespace braidzone {
namespace {

const LengthUnit millimetre{"mm", 1e-3};

/// A short device on a cone, so that no two rings are alike, with node values that count up.
class DeviceVtp : public testing::Test {
protected:
    DeviceVtp()
    {
        device.nominal_length = 3e-3;
        deployment = test::braid_on_cylinder(device, 2e-3, 0.1e-3, 10e-3);
        for (std::size_t i = 0; i < deployment.nodes.size(); ++i) {
            Vec3& node = deployment.nodes[i];
            const double scale = 1.0 + 20.0 * (node.z() - 8e-3);
            node.x() *= scale;
            node.y() *= scale;
            deployment.in_contact[i] = static_cast<char>(i % 3 == 0);
            deployment.wall_distance[i] = 1e-6 * static_cast<double>(i);
            deployment.contact_force[i] = 1e-5 * static_cast<double>(i);
            deployment.contact_pressure[i] = 10.0 * static_cast<double>(i);
        }
        sheet = make_resistance_sheet(make_braid_surface(deployment, device), BraidStokesLaw{},
                                      Fluid{});
        write_device(path, deployment, sheet, millimetre);
        vtkNew<vtkXMLPolyDataReader> reader;
        reader->SetFileName(path.c_str());
        reader->Update();
        data = reader->GetOutput();
    }

    double at_point(const char* name, std::size_t point, int component = 0) const
    {
        return data->GetPointData()->GetArray(name)->GetComponent(static_cast<vtkIdType>(point),
                                                                  component);
    }
    double at_cell(const char* name, std::size_t cell, int component = 0) const
    {
        return data->GetCellData()->GetArray(name)->GetComponent(static_cast<vtkIdType>(cell),
                                                                 component);
    }

    test::TemporaryFolder folder;
    std::filesystem::path path = folder.path() / "device.vtp";
    FlowDiverter device = test::pipeline_4x20();
    Deployment deployment;
    ResistanceSheet sheet;
    vtkSmartPointer<vtkPolyData> data;
};

TEST_F(DeviceVtp, PointsAreTheCrossingsInTheVesselsUnit)
{
    ASSERT_EQ(data->GetNumberOfPoints(), static_cast<vtkIdType>(deployment.nodes.size()));
    for (std::size_t i = 0; i < deployment.nodes.size(); ++i) {
        const Vec3 point(data->GetPoint(static_cast<vtkIdType>(i)));
        EXPECT_NEAR((point - 1e3 * deployment.nodes[i]).norm(), 0.0, 1e-12);
    }
}

TEST_F(DeviceVtp, CellsAreTheRhombiAnticlockwiseFromOutside)
{
    ASSERT_EQ(data->GetNumberOfCells(), deployment.lattice.num_rhombi());
    for (vtkIdType cell = 0; cell < data->GetNumberOfCells(); ++cell) {
        vtkCell* quad = data->GetCell(cell);
        ASSERT_EQ(quad->GetCellType(), VTK_QUAD);
        std::array<Vec3, 4> corners;
        for (int i = 0; i < 4; ++i) {
            const auto index = static_cast<std::size_t>(i);
            EXPECT_EQ(quad->GetPointId(i),
                      sheet.surface.corners[static_cast<std::size_t>(cell)][index]);
            corners[index] = Vec3(data->GetPoint(quad->GetPointId(i)));
        }
        const Vec3 centre = 0.25 * (corners[0] + corners[1] + corners[2] + corners[3]);
        const Vec3 turn = (corners[2] - corners[0]).cross(corners[3] - corners[1]);
        EXPECT_GT(turn.dot(Vec3(centre.x(), centre.y(), 0.0)), 0.0);
    }
}

TEST_F(DeviceVtp, PointFieldsBelongToTheirNodes)
{
    const std::vector<double> expansion = radial_expansion(deployment);
    for (std::size_t i = 0; i < deployment.nodes.size(); ++i) {
        EXPECT_EQ(at_point("wall_contact", i), deployment.in_contact[i]);
        EXPECT_EQ(at_point("wall_distance", i), deployment.wall_distance[i]);
        EXPECT_EQ(at_point("contact_force", i), deployment.contact_force[i]);
        EXPECT_EQ(at_point("contact_pressure", i), deployment.contact_pressure[i]);
        EXPECT_EQ(at_point("radial_expansion", i), expansion[i]);
    }
}

// Node (ring 1, column 0) stands half a node spacing around and one ring spacing along.
TEST_F(DeviceVtp, SurfaceCoordinatesAreThoseOfTheForceFreeDevice)
{
    const BraidLattice& lattice = deployment.lattice;
    EXPECT_EQ(at_point("surface_coordinates", 0, 0), 0.0);
    EXPECT_EQ(at_point("surface_coordinates", 0, 1), 0.0);
    EXPECT_NEAR(at_point("surface_coordinates", 24, 0), std::numbers::pi * 2e-3 / 24, 1e-15);
    EXPECT_NEAR(at_point("surface_coordinates", 24, 1), lattice.ring_spacing, 1e-15);
    for (std::size_t i = 0; i < deployment.nodes.size(); ++i) {
        EXPECT_GE(at_point("surface_coordinates", i, 0), 0.0);
        EXPECT_LT(at_point("surface_coordinates", i, 0), 2.0 * std::numbers::pi * 2e-3 - 1e-6);
    }
}

TEST_F(DeviceVtp, CellFieldsBelongToTheirRhombi)
{
    const BraidSurface& surface = sheet.surface;
    for (std::size_t i = 0; i < surface.rhombi.size(); ++i) {
        EXPECT_EQ(at_cell("metal_coverage", i), surface.rhombi[i].metal_coverage);
        EXPECT_EQ(at_cell("surface_porosity", i), 1.0 - surface.rhombi[i].metal_coverage);
        EXPECT_EQ(at_cell("surface_density_increase", i), surface.density_increase[i]);
        EXPECT_EQ(at_cell("pore_density", i), surface.rhombi[i].pore_density);
        EXPECT_EQ(at_cell("braid_angle", i), surface.rhombi[i].braid_angle);
        EXPECT_EQ(at_cell("pore_area", i), surface.rhombi[i].pore_area);
        EXPECT_EQ(at_cell("inscribed_diameter", i), surface.rhombi[i].inscribed_diameter);
        EXPECT_EQ(at_cell("hydraulic_diameter", i), surface.rhombi[i].hydraulic_diameter);
        EXPECT_EQ(at_cell("wire_spacing_a", i), surface.rhombi[i].spacing_a);
        EXPECT_EQ(at_cell("wire_spacing_b", i), surface.rhombi[i].spacing_b);
        EXPECT_EQ(at_cell("densest_solidity", i), densest_solidity(surface.rhombi[i]));
        EXPECT_EQ(at_cell("wire_length_per_area", i), wire_length_per_area(surface.rhombi[i]));
        EXPECT_EQ(at_cell("metal_volume_per_area", i), metal_volume_per_area(surface.rhombi[i]));
        EXPECT_EQ(at_cell("crossing_angle", i), surface.rhombi[i].crossing_angle);
        EXPECT_EQ(at_cell("jamming_angle", i), surface.rhombi[i].jamming_angle);
        EXPECT_EQ(at_cell("resistance_acting", i), sheet.acting[i]);
        EXPECT_EQ(at_cell("pressure_loss_linear", i), sheet.losses[i].linear);
        EXPECT_EQ(at_cell("pressure_loss_quadratic", i), sheet.losses[i].quadratic);
        EXPECT_EQ(at_cell("contact_pressure", i), surface.contact_pressure[i]);
        for (int c = 0; c < 3; ++c)
            EXPECT_EQ(at_cell("normal", i, c), surface.normals[i][c]);
    }
}

TEST_F(DeviceVtp, StatesTheUnitOfEveryArray)
{
    const auto text = [&](const std::string& name) -> std::string {
        auto* array =
            vtkStringArray::SafeDownCast(data->GetFieldData()->GetAbstractArray(name.c_str()));
        return array == nullptr ? "absent" : array->GetValue(0);
    };
    EXPECT_EQ(text("length_unit"), "mm");
    EXPECT_EQ(text("unit:contact_force"), "N");
    EXPECT_EQ(text("unit:pressure_loss_linear"), "Pa s/m");
    for (vtkFieldData* fields : {static_cast<vtkFieldData*>(data->GetPointData()),
                                 static_cast<vtkFieldData*>(data->GetCellData())}) {
        for (int i = 0; i < fields->GetNumberOfArrays(); ++i) {
            const std::string name = fields->GetArrayName(i);
            EXPECT_NE(text("unit:" + name), "absent") << name;
        }
    }
}

TEST_F(DeviceVtp, UnwritablePathIsReported)
{
    const std::filesystem::path nowhere = folder.path() / "absent" / "device.vtp";
    try {
        write_device(nowhere, deployment, sheet, millimetre);
        FAIL() << "nothing was thrown";
    } catch (const IoError& error) {
        EXPECT_NE(std::string(error.what()).find(nowhere.string()), std::string::npos);
    }
}

}  // namespace
}  // namespace braidzone
