#include "discrepancy/model.hpp"

#include "core/error.hpp"

#include <fmt/format.h>

#include <utility>

namespace braidzone {
namespace {

Deployment deploy_in(const Model& model, const Lumen& lumen, const DeployOptions& options)
{
    return deploy(model.device, lumen.centerline, lumen.wall, model.landing_distal, model.schedule,
                  options);
}

/// Straight to the shape at rest where that can be solved for, by the case's own motion elsewhere.
Deployment deploy_in(const Model& model, const Lumen& lumen)
{
    DeployOptions options = model.options;
    options.num_frames = 0;
    if (options.hub_freedom == 0.0 && !options.hoop_migration &&
        options.axial == AxialMotion::locked) {
        options.motion = Motion::none;
        Deployment deployment = deploy_in(model, lumen, options);
        if (deployment.converged) return deployment;
    }
    options.motion = model.options.motion;
    return deploy_in(model, lumen, options);
}

}  // namespace

std::optional<Lumen> changed_lumen(const Model& model, const Lumen& lumen)
{
    const bool is_straighter = model.straightening.share > 0.0;
    if (model.wall_offset == 0.0) {
        if (!is_straighter) return std::nullopt;
        return straightened_lumen(lumen, model.straightening);
    }
    Lumen moved = with_moved_wall(lumen, model.wall_offset);
    if (!is_straighter) return moved;
    return straightened_lumen(moved, model.straightening);
}

Simulation simulate(const Model& model, const Lumen& lumen)
{
    const std::optional<Lumen> changed = changed_lumen(model, lumen);
    Deployment deployment = deploy_in(model, changed ? *changed : lumen);
    if (!deployment.converged) {
        throw ConvergenceError(fmt::format(
            "the deployment did not come to rest in {} steps: the largest force on a free node is "
            "{:.6g} N, the tolerance {:.6g} N",
            deployment.steps, deployment.max_force_residual, deployment.force_tolerance));
    }
    DeviceSurface surface(
        deployment, imaged_sheet(deployment, model.device.wire_diameter, model.imaging.chain));
    return {std::move(deployment), std::move(surface), model.device};
}

double distal_end(const Deployment& deployment)
{
    return deployment.ring_arc_length.front();
}

double proximal_end(const Deployment& deployment)
{
    return deployment.ring_arc_length.back();
}

}  // namespace braidzone
