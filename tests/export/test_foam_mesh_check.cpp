#include "core/error.hpp"
#include "export/foam_mesh_check.hpp"
#include "support/foam_box.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>
#include <limits>
#include <utility>

namespace braidzone {
namespace {

using testing::HasSubstr;

// 2 x 2 x 2 cubes: 12 faces between them, 24 outside; patches inlet (12 to 15), outlet (16 to 19),
// wall (20 to 35).
FoamMesh block()
{
    return test::foam_box({2, 2, 2}, 1.0);
}

std::string message_for(const FoamMesh& mesh)
{
    try {
        require_closed_mesh(mesh, "case/constant/polyMesh");
    } catch (const InputError& error) {
        return error.what();
    }
    return "accepted";
}

std::string message_after(const std::function<void(FoamMesh&)>& damage)
{
    FoamMesh mesh = block();
    damage(mesh);
    return message_for(mesh);
}

TEST(RequireClosedMesh, TakesABlock)
{
    EXPECT_EQ(message_for(block()), "accepted");
}

// Patches may stand in any order, and some have no faces (`defaultFaces` of blockMesh).
TEST(RequireClosedMesh, TakesPatchesInAnyOrderAndEmptyOnes)
{
    const std::string message = message_after([](FoamMesh& mesh) {
        std::swap(mesh.patches[0], mesh.patches[2]);
        mesh.patches.push_back({"defaultFaces", "empty", 0, 0});
    });
    EXPECT_EQ(message, "accepted");
}

TEST(RequireClosedMesh, RefusesNeighbourEqualToOwner)
{
    EXPECT_THAT(message_after([](FoamMesh& mesh) { mesh.neighbour[3] = mesh.owner[3]; }),
                HasSubstr("face 3 lies between owner"));
}

TEST(RequireClosedMesh, RefusesCellsThatAreNotClosed)
{
    // Face 0 lies between cells 0 and 1; turned to cells 0 and 7 it closes neither 1 nor 7.
    EXPECT_THAT(message_after([](FoamMesh& mesh) { mesh.neighbour[0] = 7; }),
                HasSubstr("is not closed"));
    EXPECT_THAT(message_after([](FoamMesh& mesh) { std::swap(mesh.faces[0], mesh.faces[1]); }),
                HasSubstr("is not closed"));
}

// Labels by which something would be sized: 2147483647 + 1 overflows, 2147483646 takes gigabytes.
TEST(RequireClosedMesh, RefusesLabelsBeyondWhatTheFacesCanBound)
{
    for (const int label : {std::numeric_limits<int>::max(), std::numeric_limits<int>::max() - 1,
                            200000000, 18, -1, std::numeric_limits<int>::min()}) {
        EXPECT_THAT(message_after([&](FoamMesh& mesh) { mesh.owner[30] = label; }),
                    HasSubstr("face 30 has cell " + std::to_string(label) +
                              "; allowed 0 to 17, for 36 faces"));
        EXPECT_THAT(message_after([&](FoamMesh& mesh) { mesh.neighbour[2] = label; }),
                    HasSubstr("face 2 has cell"));
    }
}

TEST(RequireClosedMesh, RefusesFacesOnNoPatch)
{
    EXPECT_THAT(message_after([](FoamMesh& mesh) { mesh.patches[1].num_faces = 2; }),
                HasSubstr("faces 18 to 19 on the boundary belong to no patch"));
    EXPECT_THAT(message_after([](FoamMesh& mesh) { mesh.patches.pop_back(); }),
                HasSubstr("faces 20 to 35 on the boundary belong to no patch"));
    EXPECT_THAT(message_after([](FoamMesh& mesh) {
                    for (FoamPatch& patch : mesh.patches)
                        patch.num_faces = 0;
                }),
                HasSubstr("faces 12 to 35 on the boundary belong to no patch"));
}

TEST(RequireClosedMesh, RefusesFacesOnTwoPatches)
{
    EXPECT_THAT(message_after([](FoamMesh& mesh) { mesh.patches[0].num_faces = 6; }),
                HasSubstr("face 16 belongs to patch outlet and is one of patch inlet, too"));
}

TEST(RequireClosedMesh, RefusesInternalFacesOnAPatch)
{
    EXPECT_THAT(message_after([](FoamMesh& mesh) {
                    mesh.patches[0].start_face = 10;
                    mesh.patches[0].num_faces = 6;
                }),
                HasSubstr("face 10 belongs to patch inlet and is an internal face"));
}

TEST(RequireClosedMesh, RefusesPatchesBeyondTheFaces)
{
    EXPECT_THAT(message_after([](FoamMesh& mesh) {
                    mesh.patches[2].num_faces = std::numeric_limits<int>::max();
                }),
                HasSubstr("patch wall has faces 20 to 2147483666; there are 36"));
}

}  // namespace
}  // namespace braidzone
