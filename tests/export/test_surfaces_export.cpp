#include "core/error.hpp"
#include "core/mesh_topology.hpp"
#include "core/surface_check.hpp"
#include "core/surface_io.hpp"
#include "export/surfaces_export.hpp"
#include "support/braids.hpp"
#include "support/devices.hpp"
#include "support/shapes.hpp"
#include "support/temporary_folder.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkSTLReader.h>

#include <fstream>
#include <numbers>

namespace braidzone {
namespace {

namespace fs = std::filesystem;

constexpr double radius = 2e-3, length = 6e-3;

/// A braid of 2 mm on the wall of a tube of 96 facets.
class SurfacesExport : public testing::Test {
protected:
    SurfacesExport()
    {
        device.nominal_length = 2e-3;
        braid = test::braid_on_cylinder(device, radius, make_lattice(device).ring_spacing, 4e-3);
        options.distance_spacing = 0.2e-3;
    }

    fs::path folder() const { return folder_.path() / "surfaces"; }

    std::vector<std::string> write()
    {
        return write_surfaces(folder(), vessel, wall, {{"", braid, device.wire_diameter}}, options,
                              {"Braidzone 1.2.3", "abc"});
    }

    nlohmann::json json() const
    {
        return nlohmann::json::parse(std::ifstream(folder() / "surfaces.json"));
    }

    /// As VTK reads it, corners merged [in the file's unit].
    TriangleMesh read_by_vtk(const std::string& name) const
    {
        vtkNew<vtkSTLReader> reader;
        reader->SetFileName((folder() / name).c_str());
        reader->Update();
        TriangleMesh mesh;
        vtkPolyData* data = reader->GetOutput();
        for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
            mesh.points.emplace_back(data->GetPoint(i));
        vtkNew<vtkIdList> corners;
        for (vtkIdType i = 0; i < data->GetNumberOfCells(); ++i) {
            data->GetCellPoints(i, corners);
            mesh.triangles.push_back({static_cast<int>(corners->GetId(0)),
                                      static_cast<int>(corners->GetId(1)),
                                      static_cast<int>(corners->GetId(2))});
        }
        return mesh;
    }

    test::TemporaryFolder folder_;
    FlowDiverter device = test::pipeline_4x20();
    Deployment braid;
    Vessel vessel = test::tube_vessel(radius, length, 96, 30);
    WallTree wall{vessel};
    SurfacesOptions options;
};

TEST_F(SurfacesExport, EveryFileIsClosedAndSoundAsVtkReadsIt)
{
    EXPECT_TRUE(write().empty());
    for (const char* name : {"vessel.stl", "device.stl", "wires.stl"}) {
        const TriangleMesh mesh = read_by_vtk(name);
        SurfaceDefects defects = find_defects(mesh);
        EXPECT_TRUE(border_loops(mesh).empty()) << name;
        EXPECT_EQ(defects.num_components, std::string(name) == "wires.stl" ? 48 : 1) << name;
        defects.num_components = 1;
        EXPECT_TRUE(is_sound(defects)) << name << ": " << describe(defects);
        EXPECT_GT(enclosed_volume(mesh), 0.0) << name;
        EXPECT_EQ(json()["files"][name]["num_triangles"], mesh.triangles.size());
    }
}

// A prism of 96 sides: 96 / 2 R^2 sin(2 pi / 96) L.
TEST_F(SurfacesExport, VesselHoldsTheLumensVolume)
{
    options.parts = {SurfacePart::vessel};
    write();
    const double exact = 48.0 * radius * radius * std::sin(std::numbers::pi / 48.0) * length;
    EXPECT_NEAR(1e-9 * enclosed_volume(read_by_vtk("vessel.stl")), exact, 1e-6 * exact);
    EXPECT_NEAR(json()["files"]["vessel.stl"]["volume_m3"].get<double>(), exact, 1e-9 * exact);
    ASSERT_EQ(json()["openings"].size(), 2U);
    EXPECT_NEAR(json()["openings"][0]["normal_outwards"][2].get<double>() *
                    json()["openings"][1]["normal_outwards"][2].get<double>(),
                -1.0, 1e-12);
}

TEST_F(SurfacesExport, CoordinatesAreInTheVesselsUnitWhichTheHeaderNames)
{
    options.parts = {SurfacePart::device};
    vessel.unit = {"cm", 1e-2};
    write();
    const Box box = bounding_box(read_by_vtk("device.stl"));
    EXPECT_NEAR(box.upper.z(), 0.4, 1e-6);  // the distal end at 4 mm
    std::string header(80, ' ');
    std::ifstream(folder() / "device.stl", std::ios::binary).read(header.data(), 80);
    EXPECT_THAT(header, testing::HasSubstr("coordinates in cm"));
    EXPECT_FALSE(header.starts_with("solid"));
    EXPECT_EQ(json()["length_unit"], "cm");
    EXPECT_EQ(json()["length_unit_m"], 1e-2);
    EXPECT_EQ(json()["generator"], "Braidzone 1.2.3");
    EXPECT_EQ(json()["case_hash"], "abc");
}

TEST_F(SurfacesExport, WritesThePartsAskedForOnly)
{
    options.parts = {SurfacePart::distance};
    write();
    EXPECT_TRUE(fs::exists(folder() / "vessel_distance.vdb"));
    EXPECT_TRUE(fs::exists(folder() / "README.md"));
    for (const char* name : {"vessel.stl", "device.stl", "wires.stl"})
        EXPECT_FALSE(fs::exists(folder() / name)) << name;
    EXPECT_EQ(json()["files"].size(), 1U);
}

TEST_F(SurfacesExport, ShellIsTwoWireDiametersThickUnlessSaidOtherwise)
{
    options.parts = {SurfacePart::device};
    write();
    EXPECT_DOUBLE_EQ(json()["files"]["device.stl"]["thickness_m"].get<double>(), 60e-6);
    const double thin = json()["files"]["device.stl"]["volume_m3"];
    options.shell_thickness = 120e-6;
    write();
    EXPECT_DOUBLE_EQ(json()["files"]["device.stl"]["thickness_m"].get<double>(), 120e-6);
    // Twice as thick; on a radius that is smaller by 30 um.
    EXPECT_NEAR(json()["files"]["device.stl"]["volume_m3"].get<double>() / thin,
                2.0 * (2.0 - 0.0615) / (2.0 - 0.0315), 0.01);
}

// Rings 10 um apart, as in `WireTubes`.
TEST_F(SurfacesExport, SaysIfWiresOverlap)
{
    braid = test::braid_on_cylinder(device, 1.8e-3, 10e-6, 4e-3);
    options.parts = {SurfacePart::wires};
    const std::vector<std::string> notes = write();
    ASSERT_EQ(notes.size(), 1U);
    EXPECT_THAT(notes.front(), testing::HasSubstr("surfaces/wires.stl: wires overlap in"));
    EXPECT_EQ(json()["notes"][0], notes.front());
    EXPECT_GT(json()["files"]["wires.stl"]["num_overlaps"], 0);
}

// A groove of 0.5 mm around the braid, 0.2 mm wide, in a solid of 0.4 mm.
TEST_F(SurfacesExport, SaysIfTheShellCrossesItself)
{
    options.parts = {SurfacePart::device};
    options.shell_thickness = 0.4e-3;
    braid = test::braid_on_cylinder(device, 1.6e-3, make_lattice(device).ring_spacing, 4e-3);
    for (int column = 0; column < braid.lattice.nodes_per_ring; ++column)
        braid.nodes[static_cast<std::size_t>(braid.lattice.node(8, column))].head<2>() *= 0.7;
    const std::vector<std::string> notes = write();
    ASSERT_EQ(notes.size(), 1U);
    EXPECT_THAT(notes.front(), testing::HasSubstr("surfaces/device.stl: "));
    EXPECT_THAT(notes.front(), testing::HasSubstr("pairs of intersecting triangles"));
}

// A sharp rib of the wall, 0.2 mm high, between two nodes of a ring: the flat triangles cut it.
TEST_F(SurfacesExport, SaysIfTheShellCutsTheWall)
{
    options.parts = {SurfacePart::device};
    TriangleMesh& mesh = vessel.wall;
    // Off the nodes' angles, which are multiples of 7.5 degrees; 96 points a ring of the wall.
    for (std::size_t ring = 0; ring < 31; ++ring)
        mesh.points[96 * ring + 1] *= 0.1;
    const std::vector<std::string> notes = write();
    ASSERT_FALSE(notes.empty());
    EXPECT_THAT(notes,
                testing::Contains(testing::HasSubstr("surfaces/device.stl cuts the vessel")));
}

// The second one lies on the lining that stands for the first: its inner surface, two wires inside.
TEST_F(SurfacesExport, TwoDevicesDoNotCutEachOther)
{
    const Deployment second = test::braid_on_cylinder(device, radius - 2.0 * device.wire_diameter,
                                                      make_lattice(device).ring_spacing, 4e-3);
    options.parts = {SurfacePart::device, SurfacePart::wires};
    write_surfaces(folder(), vessel, wall,
                   {{"", braid, device.wire_diameter}, {"second_", second, device.wire_diameter}},
                   options);
    for (const std::string name : {"device.stl", "wires.stl"}) {
        const TriangleMesh both = test::joined(read_by_vtk(name), read_by_vtk("second_" + name));
        const SurfaceDefects defects = find_defects(both);
        EXPECT_TRUE(defects.intersecting_triangles.empty()) << name << ": " << describe(defects);
    }
}

std::string message_of(const FlowDiverter& device, const SurfacesOptions& options)
{
    try {
        require_possible_wires(device, options);
    } catch (const ConfigError& error) {
        return error.what();
    }
    return "";
}

TEST(PossibleWires, NeedAPatternThatClosesAroundTheBraid)
{
    FlowDiverter device = test::pipeline_4x20();
    SurfacesOptions options;
    EXPECT_EQ(message_of(device, options), "");
    device.num_wires = 50;
    EXPECT_EQ(message_of(device, options),
              "export.braid_pattern = \"2-over-2\" does not close around a braid of 50 wires: half "
              "of their number must be a multiple of 2");
    options.parts = {SurfacePart::vessel};
    EXPECT_EQ(message_of(device, options), "");
}

// 48 wires, 191 gaps or so, 64 pieces and 64 facets: 75 million triangles.
TEST(PossibleWires, AreRefusedAboveTheLimitBeforeAnythingIsDone)
{
    SurfacesOptions options;
    options.wires.facets = 64;
    options.wires.pieces_per_arm = 64;
    EXPECT_THAT(message_of(test::pipeline_4x20(), options),
                testing::AllOf(testing::HasSubstr("export.wire_facets = 64 and export.wire_pieces "
                                                  "= 64 would make wires.stl of 7"),
                               testing::HasSubstr("20 million at most")));
}

}  // namespace
}  // namespace braidzone
