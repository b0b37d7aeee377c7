#include "export/wires_vtp.hpp"
#include "support/braids.hpp"
#include "support/devices.hpp"
#include "support/temporary_folder.hpp"

#include <gtest/gtest.h>
#include <vtkCell.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkXMLPolyDataReader.h>

#include <cmath>
#include <numbers>
#include <set>
#include <vector>

namespace braidzone {
namespace {

const LengthUnit millimetre{"mm", 1e-3};
constexpr double radius = 2e-3;

class WiresVtp : public testing::Test {
protected:
    WiresVtp()
    {
        device.nominal_length = 5e-3;
        deployment =
            test::braid_on_cylinder(device, radius, make_lattice(device).ring_spacing, 10e-3);
        write_wires(path, deployment, device.wire_diameter, millimetre);
        vtkNew<vtkXMLPolyDataReader> reader;
        reader->SetFileName(path.c_str());
        reader->Update();
        data = reader->GetOutput();
    }

    test::TemporaryFolder folder;
    std::filesystem::path path = folder.path() / "wires.vtp";
    FlowDiverter device = test::pipeline_4x20();
    Deployment deployment;
    vtkSmartPointer<vtkPolyData> data;
};

TEST_F(WiresVtp, HoldsEveryWireOnce)
{
    ASSERT_EQ(data->GetNumberOfLines(), 48);
    std::multiset<int> wires, families;
    for (vtkIdType cell = 0; cell < 48; ++cell) {
        wires.insert(static_cast<int>(data->GetCellData()->GetArray("wire")->GetTuple1(cell)));
        families.insert(static_cast<int>(data->GetCellData()->GetArray("family")->GetTuple1(cell)));
    }
    for (int wire = 0; wire < 48; ++wire)
        EXPECT_EQ(wires.count(wire), 1U);
    EXPECT_EQ(families.count(0), 24U);
    EXPECT_EQ(families.count(1), 24U);
}

// On a cylinder every wire is a helix: it turns by a constant angle for each height, right-handed
// ones anticlockwise about +z as they rise. The spline through crossings 7.5 degrees apart leaves
// the helix by less than R (7.5 degrees)^3, far below a wire's radius.
TEST_F(WiresVtp, WiresAreHelicesOfTheirFamily)
{
    const double turn_per_height =
        std::numbers::pi / 24 / deployment.lattice.ring_spacing;  // [rad/m]
    for (vtkIdType cell = 0; cell < 48; ++cell) {
        const bool right_handed = data->GetCellData()->GetArray("family")->GetTuple1(cell) == 0.0;
        const double sense = right_handed ? 1.0 : -1.0;
        vtkCell* wire = data->GetCell(cell);
        const Vec3 first = 1e-3 * Vec3(data->GetPoint(wire->GetPointId(0)));
        const double first_angle = std::atan2(first.y(), first.x());
        for (vtkIdType i = 0; i < wire->GetNumberOfPoints(); ++i) {
            const Vec3 point = 1e-3 * Vec3(data->GetPoint(wire->GetPointId(i)));
            const double angle = first_angle + sense * turn_per_height * (point.z() - first.z());
            const Vec3 helix(radius * std::cos(angle), radius * std::sin(angle), point.z());
            // The end arms have a neighbour on one side only and bend less.
            const bool at_end = i < 4 || i >= wire->GetNumberOfPoints() - 4;
            EXPECT_NEAR((point - helix).norm(), 0.0, at_end ? 6e-6 : 1e-6);
        }
    }
}

TEST_F(WiresVtp, WiresPassThroughTheCrossings)
{
    std::set<std::array<long, 3>> on_wires;
    const auto rounded = [](const Vec3& p) {
        return std::array<long, 3>{std::lround(1e9 * p[0]), std::lround(1e9 * p[1]),
                                   std::lround(1e9 * p[2])};
    };
    for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i) {
        on_wires.insert(rounded(1e-3 * Vec3(data->GetPoint(i))));
    }
    for (const Vec3& node : deployment.nodes)
        EXPECT_EQ(on_wires.count(rounded(node)), 1U);
    // Each crossing lies on two wires; between crossings three points.
    const int rings = deployment.lattice.num_rings;
    EXPECT_EQ(data->GetNumberOfPoints(), 48 * (4 * (rings - 1) + 1));
}

// On the undeformed device the surface coordinates are angle times R and the distance from the
// distal end.
TEST_F(WiresVtp, SurfaceCoordinatesMapTheWiresOntoTheUnfoldedDevice)
{
    vtkDataArray* coordinates = data->GetPointData()->GetArray("surface_coordinates");
    const double circumference = 2.0 * std::numbers::pi * radius;
    for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i) {
        const Vec3 point = 1e-3 * Vec3(data->GetPoint(i));
        const double around = std::atan2(point.y(), point.x()) * radius;
        const double along = 10e-3 - point.z();
        EXPECT_NEAR(std::remainder(coordinates->GetComponent(i, 0) - around, circumference), 0.0,
                    10e-6);
        EXPECT_NEAR(coordinates->GetComponent(i, 1), along, 10e-6);
        EXPECT_GE(coordinates->GetComponent(i, 0), 0.0);
        EXPECT_LE(coordinates->GetComponent(i, 0), circumference);
    }
}

TEST_F(WiresVtp, RadiusIsInTheFilesUnit)
{
    EXPECT_NEAR(data->GetPointData()->GetArray("radius")->GetTuple1(0), 0.015, 1e-12);
}

}  // namespace
}  // namespace braidzone
