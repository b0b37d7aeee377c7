#include "export/foam_case.hpp"

#include "core/error.hpp"
#include "core/wall_tree.hpp"
#include "export/foam_boundary_conditions.hpp"
#include "export/foam_dictionaries.hpp"
#include "export/foam_figures.hpp"
#include "export/foam_fluid.hpp"
#include "export/foam_porous_source.hpp"
#include "export/foam_readme.hpp"
#include "export/foam_resistance.hpp"
#include "export/foam_scripts.hpp"
#include "export/foam_solver.hpp"
#include "export/foam_surfaces.hpp"
#include "export/text_file.hpp"

#include <fmt/format.h>

#include <cmath>

namespace braidzone {

namespace {

void check(const FoamFlow& flow)
{
    if (!(flow.inlet_velocity > 0.0) || !std::isfinite(flow.inlet_velocity))
        throw InputError(
            fmt::format("inlet velocity {:.6g} m/s; must be positive", flow.inlet_velocity));
    if (flow.cycles < 1)
        throw InputError(fmt::format("{} cycles of the waveform; allowed: 1 or more", flow.cycles));
    if (!(flow.max_courant > 0.0) || !std::isfinite(flow.max_courant))
        throw InputError(
            fmt::format("largest Courant number {:.6g}; must be positive", flow.max_courant));
    if (flow.rheology) validate(*flow.rheology);
}

void check(const FoamCaseOptions& options)
{
    for (const int level : {options.surface_refinement, options.device_refinement})
        if (level < 0 || level > 6)
            throw InputError(fmt::format("refinement by {} halvings; allowed: 0 to 6", level));
}

void write_script(const std::filesystem::path& file, const std::string& text)
{
    write_text_file(file, text);
    using std::filesystem::perms;
    std::error_code error;
    std::filesystem::permissions(file, perms::owner_exec | perms::group_exec | perms::others_exec,
                                 std::filesystem::perm_options::add, error);
    if (error) throw IoError(fmt::format("{}: {}", file.string(), error.message()));
}

void write_solver(const std::filesystem::path& system, const FoamSolverPlan& plan)
{
    write_text_file(system / "controlDict", control_dict(plan));
    write_text_file(system / "fvSchemes", fv_schemes(plan));
    write_text_file(system / "fvSolution", fv_solution(plan));
}

}  // namespace

void write_foam_flow(const std::filesystem::path& folder, const std::vector<FoamOpening>& openings,
                     const FoamFlow& flow, const Fluid& fluid, FoamForm form)
{
    check(flow);
    FoamSolverPlan solver;
    solver.flow = flow;
    solver.form = form;
    for (const FoamOpening& opening : openings)
        solver.openings.push_back(opening.name);
    const auto constant = folder / "constant";
    write_solver(folder / "system", solver);
    if (flow.waveform) write_solver(folder / "system.start", start_of(solver));
    write_text_file(constant / "transportProperties", transport_properties(fluid, flow.rheology));
    write_text_file(constant / "turbulenceProperties", turbulence_properties());
    write_text_file(folder / "0" / "U", velocity_field(openings, flow));
    write_text_file(folder / "0" / "p", pressure_field(openings, fluid.density));
    write_script(folder / "flow_figures", flow_figures_script(flow, fluid.density));
}

void write_foam_case(const std::filesystem::path& folder, const Vessel& vessel,
                     const ResistanceSheet& sheet, const Fluid& fluid,
                     const FoamCaseOptions& options)
{
    check(options);
    const std::vector<FoamOpening> openings =
        foam_openings(vessel, options.inlet, options.flow.outlets);
    const std::vector<std::string> patches = patch_names(vessel, options.inlet);
    const std::string device = acting_device_stl(sheet);

    FoamMeshingPlan plan;
    plan.inside = point_in_lumen(vessel, WallTree(vessel));
    plan.block = block_around(vessel, plan.inside, options.coarse_cell);
    plan.openings = patches;
    plan.surface_level = options.surface_refinement;
    plan.device_level = options.device_refinement;
    // The kernel's half-width and one cell more, so that cells within the kernel are alike.
    const double device_cell = std::ldexp(options.coarse_cell, -options.device_refinement);
    if (!device.empty())
        plan.device_distance = (FoamDepositOptions{}.kernel_half_width + 1.0) * device_cell;

    plan.follows_device = !device.empty() && options.form == FoamForm::baffles;

    write_foam_flow(folder, openings, options.flow, fluid, options.form);
    const auto system = folder / "system", constant = folder / "constant";
    write_text_file(system / "blockMeshDict", block_mesh_dict(plan));
    write_text_file(system / "surfaceFeatureExtractDict", surface_feature_extract_dict());
    write_text_file(system / "snappyHexMeshDict", snappy_hex_mesh_dict(plan));

    write_text_file(constant / "triSurface" / "vessel.stl", vessel_stl(vessel, patches));
    if (!device.empty()) write_text_file(constant / "triSurface" / "device.stl", device);
    // There are no zones before there is a mesh: `export --onto` fills these in.
    write_porous_sources(folder, {});

    FoamRunPlan run;
    run.program = options.program;
    run.case_file = options.case_file;
    run.solver = solver_name(options.flow);
    run.form = options.form;
    run.extent = plan.block.upper() - plan.block.lower;
    write_script(folder / "Allrun", allrun_script(run));
    write_script(folder / "Allclean", allclean_script());
    write_text_file(folder / "README.md", foam_readme(options.flow, openings, options.form));
}

}  // namespace braidzone
