#pragma once

#include "core/fluid.hpp"
#include "export/foam_block.hpp"

#include <string>
#include <vector>

namespace braidzone {

/// What the meshing dictionaries need to know.
struct FoamMeshingPlan {
    FoamBlock block;
    Vec3 inside = Vec3::Zero();         ///< point in the lumen [m]
    std::vector<std::string> openings;  ///< patch names
    int surface_level = 1;              ///< halvings of the block's cells at the wall
    int device_level = 2;               ///< halvings around the device
    /// Distance from the device within which cells are refined [m]; 0: no device to refine around.
    double device_distance = 0.0;
};

std::string block_mesh_dict(const FoamMeshingPlan& plan);
std::string surface_feature_extract_dict();
std::string snappy_hex_mesh_dict(const FoamMeshingPlan& plan);

/// Steady laminar flow by simpleFoam: SIMPLEC, second-order upwind convection. It ends when the
/// initial residuals of pressure and velocity are below `tolerance`.
struct FoamSolverPlan {
    double tolerance = 1e-5;  ///< [-]
    int most_iterations = 3000;
};

std::string control_dict(const FoamSolverPlan& plan);
std::string fv_schemes();
std::string fv_solution(const FoamSolverPlan& plan);
std::string transport_properties(const Fluid& fluid);
std::string turbulence_properties();

/// Initial and boundary velocity: a flow rate over the inlet, no slip on the wall, free outflow.
/// @param openings   patch names; the one called "inlet" is the inlet
/// @param flow_rate  [m^3/s]
std::string velocity_field(const std::vector<std::string>& openings, double flow_rate);

/// Initial and boundary kinematic pressure p / rho [m^2/s^2]: zero at every outlet.
std::string pressure_field(const std::vector<std::string>& openings);

}  // namespace braidzone
