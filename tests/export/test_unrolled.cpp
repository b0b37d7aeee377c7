#include "core/error.hpp"
#include "export/unrolled.hpp"
#include "support/braids.hpp"
#include "support/devices.hpp"
#include "support/temporary_folder.hpp"

#include <gtest/gtest.h>
#include <vtkCell.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPNGReader.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkXMLPolyDataReader.h>

#include <array>
#include <cmath>
#include <fstream>
#include <iterator>
#include <numbers>

namespace braidzone {
namespace {

const LengthUnit millimetre{"mm", 1e-3};

class Unrolled : public testing::Test {
protected:
    Unrolled()
    {
        device.nominal_length = 8e-3;
        deployment = test::braid_on_cylinder(device, 1.8e-3, 0.12e-3, 10e-3);
        for (std::size_t i = 0; i < deployment.nodes.size(); ++i) {
            deployment.wall_distance[i] = 1e-6 * static_cast<double>(i);
            deployment.contact_pressure[i] = 5000.0;
            // Contact on the half of the device at its distal end.
            deployment.in_contact[i] = static_cast<char>(i < deployment.nodes.size() / 2);
        }
        sheet = make_resistance_sheet(make_braid_surface(deployment, device), BraidStokesLaw{},
                                      Fluid{});
    }

    vtkSmartPointer<vtkPolyData> unrolled() const
    {
        const std::filesystem::path path = folder.path() / "unrolled.vtp";
        write_unrolled(path, deployment, sheet, millimetre);
        vtkNew<vtkXMLPolyDataReader> reader;
        reader->SetFileName(path.c_str());
        reader->Update();
        return reader->GetOutput();
    }

    test::TemporaryFolder folder;
    FlowDiverter device = test::pipeline_4x20();
    Deployment deployment;
    ResistanceSheet sheet;
};

// Every pore of the undeformed device is the same rhombus with diagonals 2 dR0 and 2 dL0, also
// across the cut.
TEST_F(Unrolled, CellsAreEqualRhombi)
{
    const auto data = unrolled();
    const BraidLattice& lattice = deployment.lattice;
    ASSERT_EQ(data->GetNumberOfCells(), lattice.num_rhombi());
    for (vtkIdType cell = 0; cell < data->GetNumberOfCells(); ++cell) {
        std::array<Vec3, 4> corners;
        for (int i = 0; i < 4; ++i) {
            corners[static_cast<std::size_t>(i)] =
                1e-3 * Vec3(data->GetPoint(data->GetCell(cell)->GetPointId(i)));
        }
        EXPECT_NEAR((corners[2] - corners[0] - Vec3(0, 2.0 * lattice.ring_spacing, 0)).norm(), 0.0,
                    1e-12);
        EXPECT_NEAR((corners[3] - corners[1] - Vec3(2.0 * lattice.arm_width, 0, 0)).norm(), 0.0,
                    1e-12);
    }
}

TEST_F(Unrolled, CoversTheForceFreeSurface)
{
    const auto data = unrolled();
    double bounds[6];
    data->GetBounds(bounds);
    const BraidLattice& lattice = deployment.lattice;
    const double circumference = 1e3 * 2.0 * std::numbers::pi * 2e-3;
    // Cells across the cut reach beyond it by one arm.
    EXPECT_NEAR(bounds[0], -1e3 * lattice.arm_width, 1e-9);
    EXPECT_NEAR(bounds[1], circumference, 1e-9);
    EXPECT_NEAR(bounds[2], 0.0, 1e-9);
    EXPECT_NEAR(bounds[3], 1e3 * (lattice.num_rings - 1) * lattice.ring_spacing, 1e-9);
}

TEST_F(Unrolled, FieldsAreThoseOfTheDevice)
{
    const auto data = unrolled();
    vtkDataArray* coverage = data->GetCellData()->GetArray("metal_coverage");
    for (std::size_t i = 0; i < sheet.surface.rhombi.size(); ++i) {
        EXPECT_EQ(coverage->GetTuple1(static_cast<vtkIdType>(i)),
                  sheet.surface.rhombi[i].metal_coverage);
    }
    // A corner shows the node that the rhombus has there: its wall distance is its number.
    vtkDataArray* distance = data->GetPointData()->GetArray("wall_distance");
    for (vtkIdType cell = 0; cell < data->GetNumberOfCells(); ++cell) {
        for (int i = 0; i < 4; ++i) {
            const int node =
                sheet.surface.corners[static_cast<std::size_t>(cell)][static_cast<std::size_t>(i)];
            EXPECT_DOUBLE_EQ(distance->GetTuple1(data->GetCell(cell)->GetPointId(i)), 1e-6 * node);
        }
    }
}

/// Colour of a pixel, counted from the top left corner.
std::array<int, 3> pixel(vtkImageData* image, double x, double y)
{
    int dims[3];
    image->GetDimensions(dims);
    std::array<int, 3> colour{};
    for (int c = 0; c < 3; ++c) {
        colour[static_cast<std::size_t>(c)] = static_cast<int>(image->GetScalarComponentAsDouble(
            static_cast<int>(x), dims[1] - 1 - static_cast<int>(y), 0, c));
    }
    return colour;
}

bool is_yellow(const std::array<int, 3>& colour)
{
    return colour[0] > 200 && colour[1] > 200 && colour[2] < 100;
}

bool is_violet(const std::array<int, 3>& colour)
{
    return colour[0] < 100 && colour[1] < 80 && colour[2] > 80;
}

// The first map is that of the wall contact: dark at the bottom (distal, in contact), yellow at the
// top (free).
TEST_F(Unrolled, PictureShowsContactFromTheDistalEnd)
{
    const std::filesystem::path path = folder.path() / "unrolled.png";
    write_unrolled_picture(path, deployment, sheet);
    vtkNew<vtkPNGReader> reader;
    reader->SetFileName(path.c_str());
    reader->Update();
    vtkImageData* image = reader->GetOutput();
    int dims[3];
    image->GetDimensions(dims);
    ASSERT_GT(dims[0], 1000);
    ASSERT_GT(dims[1], 200);
    const double x = 0.1 * dims[0];
    EXPECT_TRUE(is_yellow(pixel(image, x, 0.3 * dims[1])));
    EXPECT_TRUE(is_violet(pixel(image, x, 0.65 * dims[1])));
    // The margins are white paper.
    EXPECT_EQ(pixel(image, 2, 2), (std::array<int, 3>{255, 255, 255}));
}

TEST_F(Unrolled, PictureIsTheSameBytesEachTime)
{
    const auto content = [&](const char* name) {
        write_unrolled_picture(folder.path() / name, deployment, sheet);
        std::ifstream file(folder.path() / name, std::ios::binary);
        return std::string{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
    };
    const std::string first = content("one.png");
    EXPECT_GT(first.size(), 1000U);
    EXPECT_EQ(first, content("two.png"));
}

TEST_F(Unrolled, UnwritablePathsAreReported)
{
    const std::filesystem::path nowhere = folder.path() / "absent" / "unrolled";
    EXPECT_THROW(write_unrolled(nowhere, deployment, sheet, millimetre), IoError);
    EXPECT_THROW(write_unrolled_picture(nowhere, deployment, sheet), IoError);
}

}  // namespace
}  // namespace braidzone
