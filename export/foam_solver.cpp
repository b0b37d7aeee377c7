#include "export/foam_solver.hpp"

#include "export/foam_format.hpp"
#include "export/foam_function.hpp"

#include <fmt/format.h>

namespace braidzone {

namespace {

constexpr int writes_per_period = 20;

std::string system_header(const char* object)
{
    return foam_header("dictionary", "system", object);
}

std::string steady_control(const FoamSolverPlan& plan)
{
    return fmt::format(R"(endTime         {};
deltaT          {};
writeControl    timeStep;
writeInterval   200;
purgeWrite      1;
)",
                       plan.most_iterations * plan.iteration, plan.iteration);
}

std::string pulsatile_control(const FoamFlow& flow)
{
    const double one = period(*flow.waveform);
    return fmt::format(R"(endTime         {end};  // {cycles} periods of {one} s
deltaT          {first};
adjustTimeStep  yes;
maxCo           {courant};
maxDeltaT       {largest};
writeControl    adjustableRunTime;
writeInterval   {write};
purgeWrite      {kept};
)",
                       fmt::arg("end", flow.cycles * one), fmt::arg("cycles", flow.cycles),
                       fmt::arg("one", one), fmt::arg("first", one / 10000.0),
                       fmt::arg("courant", flow.max_courant), fmt::arg("largest", one / 200.0),
                       fmt::arg("write", one / writes_per_period),
                       fmt::arg("kept", writes_per_period + 1));
}

std::string patch_function(const std::string& name, const std::string& patch,
                           const std::string& operation, const std::string& field)
{
    return value_function({name, "surfaceFieldValue", "patch", patch, operation, field});
}

}  // namespace

std::string solver_name(const FoamFlow& flow)
{
    return flow.waveform ? "pimpleFoam" : "simpleFoam";
}

FoamSolverPlan start_of(const FoamSolverPlan& pulsatile)
{
    FoamSolverPlan start = pulsatile;
    // Enough for a start; where it stalls, as in a channel without friction, no more is gained.
    start.most_iterations = 500;
    start.iteration = 1e-9 * period(*pulsatile.flow.waveform);
    start.flow.waveform.reset();
    return start;
}

std::string control_dict(const FoamSolverPlan& plan)
{
    std::string functions = "// Mean kinematic pressure over the inlet [m^2/s^2].\n" +
                            patch_function("inletPressure", "inlet", "areaAverage", "p") +
                            "// Flow rates out of the vessel [m^3/s]; negative at the inlet.\n";
    for (const std::string& opening : plan.openings)
        functions += patch_function(opening + "Flow", opening, "sum", "phi");
    return system_header("controlDict") +
           fmt::format(R"(application     {};
startFrom       latestTime;
startTime       0;
stopAt          endTime;
{}writeFormat     binary;
writePrecision  12;
writeCompression off;
timeFormat      general;
timePrecision   8;
runTimeModifiable no;

functions
{{
{}#includeIfPresent "fdFunctions"
}}
)",
                       solver_name(plan.flow),
                       plan.flow.waveform ? pulsatile_control(plan.flow) : steady_control(plan),
                       functions);
}

std::string fv_schemes(const FoamSolverPlan& plan)
{
    const bool steady = !plan.flow.waveform;
    return system_header("fvSchemes") + fmt::format(R"(ddtSchemes
{{
    default         {};
}}
gradSchemes
{{
    default         Gauss linear;
}}
divSchemes
{{
    default         none;
    div(phi,U)      {}Gauss linearUpwind grad(U);
    div((nuEff*dev2(T(grad(U))))) Gauss linear;
}}
laplacianSchemes
{{
    default         Gauss linear limited corrected 0.5;
}}
interpolationSchemes
{{
    default         linear;
}}
snGradSchemes
{{
    default         limited corrected 0.5;
}}
)",
                                                    steady ? "steadyState" : "backward",
                                                    steady ? "bounded " : "");
}

std::string fv_solution(const FoamSolverPlan& plan)
{
    const bool baffles = plan.form == FoamForm::baffles;
    const char* relaxation =
        baffles ? "fields { p 0.3; }\n    equations { U 0.7; }" : "equations { U 0.9; }";
    const std::string algorithm =
        plan.flow.waveform ? R"(PIMPLE
{
    nOuterCorrectors 2;
    nCorrectors     2;
    nNonOrthogonalCorrectors 0;
}
)"
                           : fmt::format(R"(SIMPLE
{{
    consistent      {1};
    nNonOrthogonalCorrectors 0;
    residualControl
    {{
        p               {0};
        U               {0};
    }}
}}

relaxationFactors
{{
    {2}
}}
)",
                                         plan.tolerance, baffles ? "no" : "yes", relaxation);
    const char* last = plan.flow.waveform ? R"(    pFinal
    {
        $p;
        relTol          0.001;
    }
    UFinal
    {
        $U;
        relTol          0.001;
    }
)"
                                          : "";
    return system_header("fvSolution") + fmt::format(R"(solvers
{{
    p
    {{
        solver          GAMG;
        smoother        GaussSeidel;
        tolerance       1e-9;
        relTol          0.01;
    }}
    U
    {{
        solver          smoothSolver;
        smoother        symGaussSeidel;
        tolerance       1e-10;
        relTol          0.1;
    }}
{}}}

{})",
                                                     last, algorithm);
}

}  // namespace braidzone
