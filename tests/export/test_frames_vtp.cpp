#include "core/error.hpp"
#include "export/frames_vtp.hpp"
#include "support/devices.hpp"
#include "support/temporary_folder.hpp"

#include <gtest/gtest.h>
#include <vtkCell.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkStringArray.h>
#include <vtkXMLDataElement.h>
#include <vtkXMLPolyDataReader.h>
#include <vtkXMLUtilities.h>

#include <string>

namespace braidzone {
namespace {

const LengthUnit millimetre{"mm", 1e-3};

/// Two frames of a short device whose nodes' places count up.
class FramesVtp : public testing::Test {
protected:
    FramesVtp()
    {
        FlowDiverter device = test::pipeline_4x20();
        device.nominal_length = 2e-3;
        lattice = make_lattice(device);
        for (const int frame : {0, 1}) {
            frames.push_back({.step = 40 * frame, .num_released = 3 + 4 * frame, .nodes = {}});
            for (int node = 0; node < lattice.num_nodes(); ++node)
                frames.back().nodes.emplace_back(1e-3 * node, -2e-3 * node, 5e-3 + 1e-3 * frame);
        }
    }

    vtkSmartPointer<vtkPolyData> read(const std::string& name) const
    {
        vtkNew<vtkXMLPolyDataReader> reader;
        reader->SetFileName((folder.path() / name).c_str());
        reader->Update();
        return reader->GetOutput();
    }

    test::TemporaryFolder folder;
    BraidLattice lattice;
    std::vector<Frame> frames;
};

TEST_F(FramesVtp, PointsAreTheCrossingsInTheVesselsUnit)
{
    write_frames(folder.path() / "frames.pvd", lattice, frames, millimetre);
    for (const int frame : {0, 1}) {
        const auto data = read("frames/frame_000" + std::to_string(frame) + ".vtp");
        ASSERT_EQ(data->GetNumberOfPoints(), lattice.num_nodes());
        for (int node = 0; node < lattice.num_nodes(); ++node) {
            const Vec3 point(data->GetPoint(node));
            EXPECT_NEAR((point - Vec3(node, -2.0 * node, 5.0 + frame)).norm(), 0.0, 1e-9) << node;
        }
    }
}

TEST_F(FramesVtp, CellsAreTheRhombi)
{
    write_frames(folder.path() / "frames.pvd", lattice, frames, millimetre);
    const auto data = read("frames/frame_0000.vtp");
    ASSERT_EQ(data->GetNumberOfCells(), lattice.num_rhombi());
    for (int rhombus = 0; rhombus < lattice.num_rhombi(); ++rhombus) {
        const auto corners = rhombus_corners(lattice, rhombus / lattice.nodes_per_ring,
                                             rhombus % lattice.nodes_per_ring);
        ASSERT_EQ(data->GetCell(rhombus)->GetNumberOfPoints(), 4);
        for (int corner = 0; corner < 4; ++corner) {
            EXPECT_EQ(data->GetCell(rhombus)->GetPointId(corner),
                      corners[static_cast<std::size_t>(corner)]);
        }
    }
}

TEST_F(FramesVtp, FlagTheReleasedRingsAndStateStepAndUnits)
{
    write_frames(folder.path() / "frames.pvd", lattice, frames, millimetre);
    for (const int frame : {0, 1}) {
        const auto data = read("frames/frame_000" + std::to_string(frame) + ".vtp");
        vtkDataArray* released = data->GetPointData()->GetArray("released");
        ASSERT_NE(released, nullptr);
        for (int node = 0; node < lattice.num_nodes(); ++node) {
            const bool expected = node < lattice.nodes_per_ring * (frame == 0 ? 3 : 7);
            EXPECT_EQ(released->GetComponent(node, 0), expected ? 1.0 : 0.0) << node;
        }
        EXPECT_EQ(data->GetFieldData()->GetArray("step")->GetComponent(0, 0), 40.0 * frame);
        const auto text = [&](const char* name) -> std::string {
            auto* array =
                vtkStringArray::SafeDownCast(data->GetFieldData()->GetAbstractArray(name));
            return array == nullptr ? "absent" : array->GetValue(0);
        };
        EXPECT_EQ(text("length_unit"), "mm");
        EXPECT_EQ(text("unit:released"), "1");
        EXPECT_EQ(text("unit:step"), "1");
    }
}

TEST_F(FramesVtp, TheCollectionNamesEachFrameWithItsStep)
{
    write_frames(folder.path() / "frames.pvd", lattice, frames, millimetre);
    const auto root = vtkSmartPointer<vtkXMLDataElement>::Take(
        vtkXMLUtilities::ReadElementFromFile((folder.path() / "frames.pvd").c_str()));
    ASSERT_NE(root, nullptr);
    EXPECT_STREQ(root->GetName(), "VTKFile");
    EXPECT_STREQ(root->GetAttribute("type"), "Collection");
    vtkXMLDataElement* collection = root->FindNestedElementWithName("Collection");
    ASSERT_NE(collection, nullptr);
    ASSERT_EQ(collection->GetNumberOfNestedElements(), 2);
    for (const int frame : {0, 1}) {
        vtkXMLDataElement* entry = collection->GetNestedElement(frame);
        EXPECT_STREQ(entry->GetName(), "DataSet");
        EXPECT_EQ(std::string(entry->GetAttribute("timestep")), std::to_string(40 * frame));
        EXPECT_EQ(std::string(entry->GetAttribute("file")),
                  "frames/frame_000" + std::to_string(frame) + ".vtp");
        EXPECT_TRUE(std::filesystem::exists(folder.path() / entry->GetAttribute("file")));
    }
}

TEST_F(FramesVtp, AFrameOfAnotherLatticeIsRefused)
{
    frames[1].nodes.pop_back();
    try {
        write_frames(folder.path() / "frames.pvd", lattice, frames, millimetre);
        FAIL() << "nothing was thrown";
    } catch (const InputError& error) {
        EXPECT_EQ(std::string(error.what()),
                  "the frame of step 40 has " + std::to_string(lattice.num_nodes() - 1) +
                      " nodes; the lattice has " + std::to_string(lattice.num_nodes()));
    }
}

TEST_F(FramesVtp, AFolderThatCannotBeMadeIsReported)
{
    folder.write("taken", "a file");
    try {
        write_frames(folder.path() / "taken" / "frames.pvd", lattice, frames, millimetre);
        FAIL() << "nothing was thrown";
    } catch (const IoError& error) {
        const std::string what = error.what();
        EXPECT_NE(what.find((folder.path() / "taken" / "frames").string()), std::string::npos);
        EXPECT_NE(what.find("cannot be made"), std::string::npos) << what;
    }
}

}  // namespace
}  // namespace braidzone
