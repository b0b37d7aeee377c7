#pragma once

#include "deploy/deployment.hpp"
#include "deploy/neck.hpp"
#include "porous/rhombus.hpp"

#include <array>
#include <optional>
#include <vector>

namespace braidzone {

/// The deployed braid as a surface: one entry for each rhombus of the lattice, ring by ring.
struct BraidSurface {
    std::vector<Vec3> points;                 ///< the crossings [m]
    std::vector<std::array<int, 4>> corners;  ///< see `rhombus_corners`
    std::vector<Rhombus> rhombi;              ///< local geometry from mean opposite edges
    std::vector<Vec3> centres;                ///< mean of the corners [m]
    std::vector<Vec3> normals;                ///< unit, from the axis to the wall
    std::vector<double> density_increase;     ///< A0 / A - 1 against the force-free device [-]
    std::vector<double> contact_pressure;     ///< mean of the corners [Pa]
    std::vector<double> wall_distance;        ///< mean of the corners [m]; infinite without a wall
    /// Wire that the rhombus stands for [m]: half of each arm that it shares with a neighbour, all
    /// of an arm at the sheet's edge. They sum to the length of all wires, whereas the sum of
    /// `Rhombus::wire_length` lacks the outer halves of the arms at the edge.
    std::vector<double> wire_length;
};

/// Two surfaces as one, the first one's entries before the second one's.
BraidSurface joined(const BraidSurface& first, const BraidSurface& second);

/// Measures every rhombus of a deployed braid.
///
/// With the corners x0 ... x3 in order, the wire families have the mean edges
///
///     a = (x1 - x0 + x2 - x3) / 2,   b = (x3 - x0 + x2 - x1) / 2
///
/// whose cross product is the vector area of the quadrilateral, flat or not. The circumference is
/// the diagonal x3 - x1 between two nodes of one ring. The force-free area A0 is measured in the
/// same way, on chords, so that an undeformed device has a density increase of 0:
///
///     A0 = 2 dL0 R0 sin(dR0 / R0)
///
/// @throws InputError if a rhombus has no area
BraidSurface make_braid_surface(const Deployment& deployment, const FlowDiverter& device);

/// Measures the rhombi of any braided sheet that lies free of walls (infinite wall distance, no
/// contact pressure), for example a flat one across a channel.
/// @param points           the crossings [m]
/// @param corners          of each rhombus, anticlockwise seen from the side that normals point to
/// @param wire_diameter    [m]; > 0
/// @param force_free_area  A0, for the density increase [m^2]; > 0
/// @throws InputError if a rhombus has no area
BraidSurface make_braid_surface(const std::vector<Vec3>& points,
                                const std::vector<std::array<int, 4>>& corners,
                                double wire_diameter, double force_free_area);

/// Where a rhombus lies with regard to the neck.
enum class NeckPart : char {
    none,      ///< on a landing zone
    opposite,  ///< beside the neck, where the vessel's wall is
    over,      ///< over the neck
};

/// The part of each rhombus of a deployed braid: over the neck if three of its corners or more are
/// nodes of the neck, opposite if its middle ring is one of the neck's.
/// @param openings  of the vessel behind the device; the first one is the neck, if a sac lies
/// behind
std::vector<NeckPart> neck_parts(const Deployment& deployment,
                                 const std::vector<WallOpening>& openings);

/// Figures of a braid surface; those of the neck are absent if there is none. Means are weighted by
/// area, densities too.
struct BraidMeasures {
    double mean_density_increase = 0.0;                ///< [-]
    std::optional<double> mean_density_increase_neck;  ///< over the neck [-]
    /// All round the vessel at the neck, with the side where the wall is [-].
    std::optional<double> mean_density_increase_neck_rings;
    double mean_metal_coverage = 0.0;                ///< [-]
    std::optional<double> mean_metal_coverage_neck;  ///< [-]
    std::optional<double> mean_pore_density_neck;    ///< [1/m^2]
    double wire_length = 0.0;                        ///< of all arms, each once [m]
    double metal_volume = 0.0;                       ///< pi d^2 / 4 times the wire length [m^3]
    double device_area = 0.0;                        ///< [m^2]
};

/// @param parts  one for each rhombus; none at all: no neck
BraidMeasures measure(const BraidSurface& surface, const std::vector<NeckPart>& parts = {});

/// Metal that a rhombus stands for [m^3]: the wire's cross-section times `wire_length`.
double metal_volume(const BraidSurface& surface, std::size_t rhombus);

}  // namespace braidzone
