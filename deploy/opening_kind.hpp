#pragma once

#include "core/centerline.hpp"
#include "core/vessel.hpp"
#include "core/wall_tree.hpp"
#include "deploy/neck.hpp"

#include <string_view>
#include <vector>

namespace braidzone {

/// "sac", "branch", "end".
std::string_view name_of(OpeningKind kind);

/// The ends of a device that an opening takes in.
struct OpeningEnds {
    bool distal = false;
    bool proximal = false;
};

OpeningEnds ends_of(const WallOpening& opening, const BraidLattice& lattice);

/// The middle of an opening: the mean of its nodes, the middle of its rings if it has none [m].
Vec3 middle_of(const WallOpening& opening, const Deployment& deployment);

/// Where a device lies.
struct VesselAround {
    const Vessel& vessel;
    const WallTree& wall;  ///< of that vessel, without lining
    const Centerline& centerline;
};

/// Tells the mouths of sacs, the ostia of branches and poor ends apart by what lies behind, and
/// adds the parts of the device that are free of the wall all round.
///
/// The wall is parted along the parent vessel's tube (`tube_along`) into regions (`wall_regions`),
/// and sacs from the branches beside them (`part_sacs_from_branches`). A node of an opening looks
/// into the region which its ray from the hub hits; a ray that hits nothing leaves through one of
/// the vessel's openings.
///
/// - branch: the region reaches an opening of the vessel at neither end of the centerline; a sac
///   beside it is a region of its own
/// - end: else, if the opening has nodes in an end ring of the device, so that flow passes around
///   it, or its rays leave through the vessel's own inlet or outlet
/// - sac: else
///
/// An opening whose nodes all see the parent vessel's own wall, as where the hubs are drawn into a
/// wide neck and away from the wall opposite to it, is none.
///
/// An opening that looks into two regions (three nodes or more each) becomes two; openings of one
/// kind on the same region become one, so that a neck which wires cross counts once.
///
/// A node is free if the wall behind it is more than 1.2 times as far from the hub as the node
/// itself. Connected free nodes that are in none of these openings and take a quarter of an end
/// ring are an end; those that are at no end of the device and take all of a ring are a fusiform
/// sac, which the device closes off on both sides. Other free nodes are malapposed.
///
/// The result is independent of the wall's triangles as long as they are smaller than the mouths.
///
/// @param openings    as `find_openings` finds them
/// @param neck_given  the first opening was given (`NeckOptions::given`) and stays as it is
/// @return sacs, then branches, then ends, each largest area first; a given neck before them
std::vector<WallOpening> told_apart(const std::vector<WallOpening>& openings,
                                    const Deployment& deployment, const VesselAround& around,
                                    bool neck_given = false);

}  // namespace braidzone
