#include "export/foam_case.hpp"

#include "core/error.hpp"
#include "core/wall_tree.hpp"
#include "export/foam_dictionaries.hpp"
#include "export/foam_format.hpp"
#include "export/foam_porous_source.hpp"
#include "export/foam_resistance.hpp"
#include "export/foam_scripts.hpp"
#include "export/foam_surfaces.hpp"
#include "export/text_file.hpp"

#include <fmt/format.h>

#include <cmath>

namespace braidzone {

namespace {

void check(const FoamCaseOptions& options, const Vessel& vessel)
{
    if (!(options.inlet_velocity > 0.0) || !std::isfinite(options.inlet_velocity))
        throw InputError(
            fmt::format("inlet velocity {:.6g} m/s; must be positive", options.inlet_velocity));
    if (options.inlet < 0 || options.inlet >= static_cast<int>(vessel.openings.size()))
        throw InputError(fmt::format("inlet is opening {}; the vessel has openings 0 to {}",
                                     options.inlet, vessel.openings.size() - 1));
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

}  // namespace

void write_foam_case(const std::filesystem::path& folder, const Vessel& vessel,
                     const ResistanceSheet& sheet, const Fluid& fluid,
                     const FoamCaseOptions& options)
{
    check(options, vessel);
    const std::vector<std::string> openings = patch_names(vessel, options.inlet);
    const std::string device = acting_device_stl(sheet);

    FoamMeshingPlan plan;
    plan.inside = point_in_lumen(vessel, WallTree(vessel));
    plan.block = block_around(vessel, plan.inside, options.coarse_cell);
    plan.openings = openings;
    plan.surface_level = options.surface_refinement;
    plan.device_level = options.device_refinement;
    // The kernel's half-width and one cell more, so that cells within the kernel are alike.
    const double device_cell = std::ldexp(options.coarse_cell, -options.device_refinement);
    if (!device.empty())
        plan.device_distance = (FoamDepositOptions{}.kernel_half_width + 1.0) * device_cell;

    const auto system = folder / "system", constant = folder / "constant";
    write_text_file(system / "blockMeshDict", block_mesh_dict(plan));
    write_text_file(system / "surfaceFeatureExtractDict", surface_feature_extract_dict());
    write_text_file(system / "snappyHexMeshDict", snappy_hex_mesh_dict(plan));
    const FoamSolverPlan solver;
    write_text_file(system / "controlDict", control_dict(solver));
    write_text_file(system / "fvSchemes", fv_schemes());
    write_text_file(system / "fvSolution", fv_solution(solver));

    write_text_file(constant / "triSurface" / "vessel.stl", vessel_stl(vessel, openings));
    if (!device.empty()) write_text_file(constant / "triSurface" / "device.stl", device);
    write_text_file(constant / "transportProperties", transport_properties(fluid));
    write_text_file(constant / "turbulenceProperties", turbulence_properties());
    // There are no zones before there is a mesh: `export --onto` fills these in.
    write_porous_sources(folder, {});

    const Opening& inlet = vessel.openings[static_cast<std::size_t>(options.inlet)];
    write_text_file(folder / "0" / "U",
                    velocity_field(openings, options.inlet_velocity * inlet.area));
    write_text_file(folder / "0" / "p", pressure_field(openings));

    write_script(folder / "Allrun", allrun_script(options.program, options.case_file));
    write_script(folder / "Allclean", allclean_script());
    write_text_file(folder / "README.md", foam_readme());
}

}  // namespace braidzone
