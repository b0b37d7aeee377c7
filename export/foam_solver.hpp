#pragma once

#include "export/foam_flow.hpp"
#include "export/foam_form.hpp"

#include <string>
#include <vector>

namespace braidzone {

/// How a case is solved. Without `flow.waveform` steady by simpleFoam (SIMPLEC), until the initial
/// residuals of pressure and velocity are below `tolerance`; with it by pimpleFoam over
/// `flow.cycles` periods. Baffles make SIMPLEC diverge: with them SIMPLE, relaxed to 0.3 for
/// pressure and 0.7 for velocity.
struct FoamSolverPlan {
    double tolerance = 1e-5;  ///< of steady flow [-]
    int most_iterations = 3000;
    double iteration = 1.0;  ///< by which steady flow's time counts on [s]
    FoamFlow flow = {};
    FoamForm form = FoamForm::zones;         ///< of the device
    std::vector<std::string> openings = {};  ///< patches whose flow rates are written
};

/// "simpleFoam" or "pimpleFoam".
std::string solver_name(const FoamFlow& flow);

/// Text of system/controlDict. It goes on from the latest time there is, so that a stopped run is
/// continued by calling the solver again; pulsatile flow is written 20 times a period, and the last
/// period is kept.
std::string control_dict(const FoamSolverPlan& plan);

/// The steady flow from which a pulsatile one starts: simpleFoam at the waveform's first flow rate,
/// its iterations a billionth of a period each. From rest, the sudden flow would stir the sac, and
/// behind a device that takes a second to calm down.
FoamSolverPlan start_of(const FoamSolverPlan& pulsatile);

/// Text of system/fvSchemes: second order in space (convection: linear upwind) and, pulsatile, in
/// time (backward). On a box with a sac the inflow through the treated neck is 0.6 % off with 50
/// time steps a period and 0.2 % with 200; with Euler's scheme 4.1 and 1.3 %.
std::string fv_schemes(const FoamSolverPlan& plan = {});

/// Text of system/fvSolution. Pulsatile flow has two outer correctors: in that box one is 1 % off
/// and two 0.02 %, against five.
std::string fv_solution(const FoamSolverPlan& plan);

}  // namespace braidzone
