#include "cli/pipeline.hpp"

#include "cli/case_geometry.hpp"
#include "core/error.hpp"
#include "deploy/device_lining.hpp"
#include "deploy/opening_kind.hpp"
#include "discrepancy/lumen.hpp"
#include "porous/braid_surface.hpp"

#include <fmt/format.h>

#include <utility>

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

/// A device at rest in the vessel, or in what lines it.
Deployment deploy_to_rest(const FlowDiverter& device, double landing,
                          const ReleaseSchedule& schedule, const DeployOptions& options,
                          const Centerline& centerline, const WallTree& wall)
{
    Deployment deployment = deploy(device, centerline, wall, landing, schedule, options);
    require_convergence(deployment);
    return deployment;
}

ResistanceSheet resistance_of(const Case& job, const Deployment& deployment,
                              const FlowDiverter& device)
{
    return make_resistance_sheet(make_braid_surface(deployment, device), job.law, job.fluid,
                                 job.sheet);
}

Lumen as_straight_as_stated(Lumen lumen, const VesselStraightening& straightening)
{
    if (straightening.share == 0.0) return lumen;
    return straightened_lumen(lumen, straightening);
}

Deployment deploy_second(const Case& job, const SecondDevice& second, double landing,
                         const Deployment& first, const Vessel& vessel,
                         const Centerline& centerline)
{
    const WallTree lined_wall(vessel, inner_surface(first, job.device.wire_diameter));
    try {
        Deployment deployment = deploy_to_rest(second.device, landing, second.schedule,
                                               job.deployment, centerline, lined_wall);
        measure_wall_distance_through(deployment, first, lined_wall,
                                      static_cast<int>(vessel.wall.triangles.size()));
        return deployment;
    } catch (const GeometryError& error) {
        throw GeometryError(fmt::format("second_device: {}", error.what()));
    } catch (const ConvergenceError& error) {
        throw ConvergenceError(fmt::format("second_device: {}", error.what()));
    }
}

}  // namespace

Chain run_chain(const Case& job, Stage last, Progress& progress)
{
    progress.begin("vessel", "reading the vessel");
    Vessel given = read_vessel(job.vessel);
    WallTree given_wall(given);
    progress.begin("centerline", "finding the centerline");
    GivenCenterline found = find_centerline(job.vessel, given, given_wall);
    const Centerline given_line = resample(found.line);
    // Places are given on the vessel as its file has it.
    const auto landing = [&](const PlaceOnCenterline& place) {
        return arc_length_at(place, given_line);
    };
    auto [vessel, wall, centerline] = as_straight_as_stated(
        {std::move(given), std::move(given_wall), given_line}, job.vessel.straightening);
    progress.begin("deploy", "deploying the device");
    Deployment deployment = deploy_to_rest(job.device, landing(job.landing_distal), job.schedule,
                                           job.deployment, centerline, wall);
    const NeckOptions neck{.given = job.neck};
    const auto openings_behind = [&](const Deployment& lying) {
        return told_apart(find_openings(lying, wall, neck), lying, {vessel, wall, centerline},
                          neck.given.has_value());
    };
    std::vector<WallOpening> openings = openings_behind(deployment);
    std::optional<SecondDeployment> second;
    if (job.second_device) {
        second.emplace();
        second->deployment =
            deploy_second(job, *job.second_device, landing(job.second_device->landing_distal),
                          deployment, vessel, centerline);
        second->openings = openings_behind(second->deployment);
    }
    ResistanceSheet sheet, resistance;
    std::optional<PorousField> field;
    if (last != Stage::check) {
        progress.begin("porous", "computing the flow resistance");
        sheet = resistance = resistance_of(job, deployment, job.device);
        if (second) {
            second->sheet = resistance_of(job, second->deployment, job.second_device->device);
            resistance = joined(sheet, second->sheet);
        }
    }
    if (last == Stage::porous || last == Stage::exports)
        field = deposit(resistance, vessel, job.deposit);
    progress.end();
    return {std::move(vessel),     std::move(wall),       std::move(centerline),
            std::move(deployment), std::move(openings),   std::move(sheet),
            std::move(second),     std::move(resistance), std::move(field),
            std::move(found.notes)};
}

int inlet_of(const Chain& chain)
{
    return nearest_opening(chain.vessel, chain.centerline.sections.front().origin);
}

double wall_gap(const FlowDiverter& device)
{
    return 3.0 * device.wire_diameter;
}

}  // namespace braidzone
