#pragma once

#include "export/foam_case.hpp"
#include "export/foam_scripts.hpp"
#include "export/foam_solver.hpp"
#include "export/text_file.hpp"
#include "external/openfoam.hpp"
#include "porous/resistance_sheet.hpp"
#include "support/braids.hpp"
#include "support/foam_poly_mesh.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace braidzone::test {

/// Writes a case on a mesh made here, with the flow's files and Allrun as the export writes them.
/// To Allrun it looks meshed; applying the device to it is left to the test (BRAIDZONE=true).
inline void write_box_case(const std::filesystem::path& folder, const FoamMesh& mesh,
                           const std::vector<FoamOpening>& openings, const FoamFlow& flow,
                           const Fluid& fluid)
{
    write_poly_mesh(folder, mesh);
    write_text_file(folder / "constant/polyMesh/cellLevel", "");
    write_foam_flow(folder, openings, flow, fluid);
    FoamRunPlan run;
    run.program = "true";
    run.case_file = "case.toml";
    run.solver = solver_name(flow);
    run.extent = mesh.points.back() - mesh.points.front();
    write_text_file(folder / "Allrun", allrun_script(run));
}

/// Runs Allrun; more ranks than processors are allowed.
inline bool allrun(const std::filesystem::path& folder, const std::string& arguments)
{
    return run_in(folder,
                  "unset BRAIDZONE; export MPIRUN='mpirun --oversubscribe --mca "
                  "mpi_yield_when_idle 1'; sh ./Allrun " +
                      arguments,
                  "log.Allrun");
}

/// The wall lets flow slip along it.
inline void let_slip(const std::filesystem::path& folder)
{
    replace_in(folder / "0/U", "wall { type noSlip; }", "wall { type slip; }");
}

/// Boundary conditions for more walls than the one that the export knows of.
inline void add_walls(const std::filesystem::path& folder, const std::vector<std::string>& patches,
                      const std::string& velocity = "noSlip")
{
    for (const std::string& patch : patches) {
        replace_in(folder / "0/U", "    wall {",
                   "    " + patch + " { type " + velocity + "; }\n    wall {");
        replace_in(folder / "0/p", "    wall {",
                   "    " + patch + " { type zeroGradient; }\n    wall {");
    }
}

/// A flat sheet, its normal along `axis` and its corner at `corner`, of dp = a v + b v |v| with
/// a = 490 Pa s/m and b = 330 kg/m^3.
inline ResistanceSheet flat_sheet(int axis, const Vec3& corner, double width_next,
                                  double width_last)
{
    const int count = 10;
    const auto unit = [](int i) { return Vec3(Vec3::Unit(i % 3)); };
    const auto surface = flat_braid(corner, unit(axis + 1) * (width_next / count), count,
                                    unit(axis + 2) * (width_last / count), count, 30e-6);
    return make_resistance_sheet(surface, ConstantLaw{{490.0, 330.0}}, Fluid{});
}

}  // namespace braidzone::test
