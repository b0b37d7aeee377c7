#include "core/mesh_topology.hpp"
#include "core/surface_labels.hpp"
#include "core/vessel.hpp"
#include "support/shapes.hpp"

#include <gtest/gtest.h>

namespace braidzone {
namespace {

/// A tube whose ends bulge by 0.4 mm, labelled 7 on the wall, 2 and 3 on the caps, which are no
/// flat ones (11 degrees), as VMTK's smooth caps are not.
LabelledSurface bulged()
{
    LabelledSurface surface;
    surface.mesh = test::tube(2e-3, 10e-3, 24, 20);
    surface.label_name = "CellEntityIds";
    surface.labels.assign(surface.mesh.triangles.size(), 7);
    int label = 2;
    for (const std::vector<int>& loop : border_loops(surface.mesh)) {
        const double z = surface.mesh.points[static_cast<std::size_t>(loop[0])].z();
        append_fan(surface.mesh, loop, Vec3(0, 0, z > 5e-3 ? 10.4e-3 : -0.4e-3));
        surface.labels.resize(surface.mesh.triangles.size(), label++);
    }
    return surface;
}

TEST(LabelledCaps, AreTheDiscsBesideTheLargestLabel)
{
    const LabelledCaps found = labelled_caps(bulged());
    ASSERT_EQ(found.caps.size(), 2u);
    EXPECT_TRUE(found.notes.empty());
    EXPECT_EQ(found.caps[0].label, 2);
    EXPECT_EQ(found.caps[0].triangles.size(), 24u);
    EXPECT_LT((found.caps[0].opening.normal + Vec3::UnitZ()).norm(), 1e-12);
    EXPECT_LT((found.caps[1].opening.centre - Vec3(0, 0, 10e-3)).norm(), 1e-12);
}

TEST(LabelledCaps, OpenTheVesselInsideOutToo)
{
    LabelledSurface surface = bulged();
    for (auto& corners : surface.mesh.triangles)
        std::swap(corners[0], corners[1]);
    const Vessel vessel = make_vessel(surface, LengthUnit{});
    ASSERT_EQ(vessel.openings.size(), 2u);
    EXPECT_EQ(vessel.openings[0].kind.find("cap CellEntityIds "), 0u);
    EXPECT_EQ(vessel.notes, (std::vector<std::string>{"turned all normals out of the lumen",
                                                      "opened 2 caps labelled by CellEntityIds"}));
}

// A patch of the side wall with a label of its own is a disc, but no tube leads to it.
TEST(LabelledCaps, AreNotPatchesOfTheWall)
{
    LabelledSurface surface = bulged();
    const std::size_t first = 10 * 48;
    surface.labels[first] = surface.labels[first + 1] = 9;
    const LabelledCaps found = labelled_caps(surface);
    EXPECT_EQ(found.caps.size(), 2u);
    ASSERT_EQ(found.notes.size(), 1u);
    EXPECT_EQ(found.notes[0].find("no cap, kept as wall: CellEntityIds 9, 2 triangles about "), 0u);
}

}  // namespace
}  // namespace braidzone
