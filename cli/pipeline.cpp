#include "cli/pipeline.hpp"

#include "cli/case_geometry.hpp"
#include "core/error.hpp"
#include "porous/braid_surface.hpp"

#include <fmt/format.h>

namespace braidzone {
namespace {

void require_convergence(const Deployment& deployment)
{
    if (deployment.converged) return;
    throw ConvergenceError(
        fmt::format("the deployment did not come to rest in {} steps: the largest force on a free "
                    "node is {:.6g} "
                    "N, the tolerance {:.6g} N; raise deployment.max_settling_steps or "
                    "deployment.residual_tolerance",
                    deployment.steps, deployment.max_force_residual, deployment.force_tolerance));
}

}  // namespace

Chain run_chain(const Case& job, Stage last, Progress& progress)
{
    progress.begin("vessel", "reading the vessel");
    Vessel vessel = read_vessel(job.vessel);
    WallTree wall(vessel);
    progress.begin("centerline", "finding the centerline");
    Centerline centerline = resample(find_centerline(job.vessel, vessel, wall));
    const double landing = arc_length_at(job.landing_distal, centerline);
    progress.begin("deploy", "deploying the device");
    Deployment deployment =
        deploy(job.device, centerline, wall, landing, job.schedule, job.deployment);
    require_convergence(deployment);
    progress.begin("porous", "computing the flow resistance");
    const BraidSurface surface = make_braid_surface(deployment, job.device);
    ResistanceSheet sheet = make_resistance_sheet(surface, job.law, job.fluid, job.sheet);
    std::optional<PorousField> field;
    if (last != Stage::deploy) field = deposit(sheet, vessel, job.deposit);
    progress.end();
    return {std::move(vessel),     std::move(wall),  std::move(centerline),
            std::move(deployment), std::move(sheet), std::move(field)};
}

double neck_gap(const FlowDiverter& device)
{
    return 3.0 * device.wire_diameter;
}

}  // namespace braidzone
