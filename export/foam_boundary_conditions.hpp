#pragma once

#include "export/foam_flow.hpp"
#include "export/foam_outlets.hpp"

#include <string>
#include <vector>

namespace braidzone {

/// Initial and boundary velocity, 0/U: a flow rate over the inlet, flat profile, constant or
/// repeating; no slip on the wall; at an outlet its share of the flow rate
/// (flowRateOutletVelocity), or free outflow.
std::string velocity_field(const std::vector<FoamOpening>& openings, const FoamFlow& flow);

/// Initial and boundary kinematic pressure p / rho, 0/p [m^2/s^2]: the outlet's pressure, or zero
/// gradient where its share of the flow is prescribed.
/// @param density  [kg/m^3]
std::string pressure_field(const std::vector<FoamOpening>& openings, double density);

/// What holds at an opening, for people to read: "inflow, 2.8 mL/s in, flat profile".
std::string opening_condition(const FoamOpening& opening, const FoamFlow& flow);

}  // namespace braidzone
