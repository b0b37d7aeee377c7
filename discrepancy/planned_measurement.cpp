#include "discrepancy/planned_measurement.hpp"

#include <algorithm>
#include <cmath>

namespace braidzone {
namespace {

/// A point of the vessel's frame where the scan shows it.
Vec3 as_scanned(const Imaging& imaging, const Vec3& point)
{
    const double angle = imaging.rotation.norm();
    Vec3 turned = point - imaging.shift - imaging.pivot;
    if (angle > 0.0) turned = Eigen::AngleAxisd(-angle, imaging.rotation / angle) * turned;
    return turned + imaging.pivot;
}

}  // namespace

Observations planned_observations(const Simulation& base, const Imaging& imaging,
                                  const PlannedMeasurement& plan, const PatchOptions& options)
{
    Observations observations;
    const TriangleMesh& mesh = base.surface.middle();
    const double outwards = base.surface.half_thickness() + imaging.blooming;
    for (int t = 0; t < static_cast<int>(mesh.triangles.size()); ++t) {
        const auto& [a, b, c] = mesh.triangles[static_cast<std::size_t>(t)];
        const Vec3 middle =
            (mesh.points[static_cast<std::size_t>(a)] + mesh.points[static_cast<std::size_t>(b)] +
             mesh.points[static_cast<std::size_t>(c)]) /
            3.0;
        observations.points.push_back(
            as_scanned(imaging, middle + outwards * area_vector(mesh, t).normalized()));
    }
    observations.field = make_discrepancy_field(observations.points, imaging, base, options);
    for (Patch& patch : observations.field.patches) {
        patch.point_sd = plan.point_sd;
        const auto planned = static_cast<std::size_t>(plan.points_per_patch);
        if (patch.points.size() > planned) patch.points.resize(planned);
    }
    observations.scalars.values[0] = {distal_end(base.deployment), plan.end_sd};
    observations.scalars.values[1] = {proximal_end(base.deployment), plan.end_sd};
    return observations;
}

}  // namespace braidzone
