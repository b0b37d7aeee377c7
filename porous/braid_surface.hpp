#pragma once

#include "deploy/deployment.hpp"
#include "porous/rhombus.hpp"

#include <array>
#include <optional>
#include <vector>

namespace braidzone {

/// The deployed braid as a surface: one entry for each rhombus of the lattice, ring by ring.
struct BraidSurface {
    std::vector<Vec3> points;                ///< the crossings [m]
    std::vector<std::array<int, 4>> corners; ///< see `rhombus_corners`
    std::vector<Rhombus> rhombi;             ///< local geometry from mean opposite edges
    std::vector<Vec3> centres;               ///< mean of the corners [m]
    std::vector<Vec3> normals;               ///< unit, from the axis to the wall
    std::vector<double> density_increase;    ///< A0 / A - 1 against the force-free device [-]
    std::vector<double> contact_pressure;    ///< mean of the corners [Pa]
    std::vector<double> wall_distance;       ///< mean of the corners [m]
    double wire_diameter = 0.0;              ///< [m]
};

/// Measures every rhombus of a deployed braid.
BraidSurface make_braid_surface(const Deployment& deployment, const FlowDiverter& device);

/// Figures of a braid surface; those of the neck, over rhombi that are further than `neck_gap` from
/// the wall, are absent if there are none. Means are weighted by area, densities too.
struct BraidMeasures {
    double mean_density_increase = 0.0;                 ///< [-]
    std::optional<double> mean_density_increase_neck;   ///< [-]
    double mean_metal_coverage = 0.0;                   ///< [-]
    std::optional<double> mean_metal_coverage_neck;     ///< [-]
    std::optional<double> mean_pore_density_neck;       ///< [1/m^2]
    double wire_length = 0.0;   ///< of all wires [m]
    double metal_volume = 0.0;  ///< [m^3]
    double device_area = 0.0;   ///< [m^2]
};

BraidMeasures measure(const BraidSurface& surface, double neck_gap);

}  // namespace braidzone
