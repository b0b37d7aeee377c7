#include "core/error.hpp"
#include "export/vessel_vtp.hpp"
#include "support/shapes.hpp"
#include "support/temporary_folder.hpp"

#include <gtest/gtest.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkXMLPolyDataReader.h>

#include <array>

namespace braidzone {
namespace {

// A tube of 48 by 10 facets: 960 triangles of wall and a fan of 48 over each end, in centimetres.
TEST(VesselVtp, HoldsTheWallAndACapForEachOpening)
{
    const test::TemporaryFolder folder;
    Vessel vessel = test::tube_vessel(2e-3, 10e-3, 48, 10);
    vessel.unit = {"cm", 1e-2};
    const std::filesystem::path path = folder.path() / "vessel.vtp";
    write_vessel_vtp(path, vessel);
    vtkNew<vtkXMLPolyDataReader> reader;
    reader->SetFileName(path.c_str());
    reader->Update();
    vtkPolyData* data = reader->GetOutput();
    ASSERT_EQ(data->GetNumberOfCells(), 960 + 2 * 48);
    std::array<int, 3> count{};
    vtkDataArray* opening = data->GetCellData()->GetScalars();
    ASSERT_STREQ(opening->GetName(), "opening");
    for (vtkIdType cell = 0; cell < data->GetNumberOfCells(); ++cell)
        ++count[static_cast<std::size_t>(1 + static_cast<int>(opening->GetTuple1(cell)))];
    EXPECT_EQ(count, (std::array{960, 48, 48}));
    EXPECT_NEAR(data->GetBounds()[1], 0.2, 1e-12);
    EXPECT_NEAR(data->GetBounds()[5], 1.0, 1e-12);
}

TEST(VesselVtp, UnwritablePathIsReported)
{
    const test::TemporaryFolder folder;
    EXPECT_THROW(write_vessel_vtp(folder.path() / "absent" / "vessel.vtp",
                                  test::tube_vessel(2e-3, 10e-3, 48, 10)),
                 IoError);
}

}  // namespace
}  // namespace braidzone
