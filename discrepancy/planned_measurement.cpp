#include "discrepancy/planned_measurement.hpp"

#include "discrepancy/contact_force.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>

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

/// The ring that is nearest to an arc length.
int ring_at(const Deployment& deployment, double arc_length)
{
    int nearest = 0;
    for (int ring = 0; ring < deployment.lattice.num_rings; ++ring) {
        const auto off = [&](int i) {
            return std::abs(deployment.ring_arc_length[static_cast<std::size_t>(i)] - arc_length);
        };
        if (off(ring) < off(nearest)) nearest = ring;
    }
    return nearest;
}

/// Pores counted in squares beside each other all over the device.
DensityField planned_density(const Simulation& base, const Imaging& imaging,
                             const PlannedMeasurement& plan)
{
    const Deployment& deployment = base.deployment;
    const BraidLattice& lattice = deployment.lattice;
    const double from = proximal_end(deployment), to = distal_end(deployment);
    const int num_along = std::max(1, static_cast<int>((to - from) / plan.density_window));
    const int num_around = std::max(
        4, static_cast<int>(2.0 * std::numbers::pi * lattice.nominal_radius / plan.density_window));
    DensityMap map;
    for (int i = 0; i < num_along; ++i) {
        const int ring = ring_at(deployment, std::lerp(from, to, (i + 0.5) / num_along));
        for (int j = 0; j < num_around; ++j) {
            const int node = lattice.node(ring, j * lattice.nodes_per_ring / num_around);
            map.places.push_back(
                {.point = as_scanned(imaging, deployment.nodes[static_cast<std::size_t>(node)]),
                 .window = plan.density_window});
        }
    }
    DensityField field = make_density_field(map, imaging, base);
    for (std::size_t i = 0; i < field.places.size(); ++i) {
        field.places[i].value = field.scale[static_cast<Eigen::Index>(i)];
        field.places[i].sd = plan.density_sd * field.places[i].value;
    }
    return field;
}

std::vector<int> row_range(Eigen::Index first, Eigen::Index count)
{
    std::vector<int> rows;
    for (Eigen::Index i = 0; i < count; ++i)
        rows.push_back(static_cast<int>(first + i));
    return rows;
}

/// Both ends, or the one that was not measured.
std::string ends_text(const Observations& measured, const PlannedMeasurement& plan)
{
    const bool has_distal = measured.scalars.values[0].has_value();
    const bool has_proximal = measured.scalars.values[1].has_value();
    const char* which = has_distal ? "the proximal end" : "the distal end";
    return fmt::format("{} to {:.2g} mm", has_distal || has_proximal ? which : "both ends",
                       1e3 * plan.end_sd);
}

/// Puts the rows of a channel to those that were measured, or to a further channel.
void assign(PlannedRows& rows, const std::vector<int>& those, bool was_measured,
            const std::string& name, const std::string& measurement)
{
    if (those.empty()) return;
    if (was_measured) {
        rows.measured.insert(rows.measured.end(), those.begin(), those.end());
    } else if (!rows.channels.empty() && rows.channels.back().name == name) {
        auto& known = rows.channels.back().rows;
        known.insert(known.end(), those.begin(), those.end());
    } else {
        rows.channels.push_back({name, measurement, those});
    }
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
        patch.weights.assign(patch.points.size(), 1.0 / static_cast<double>(patch.points.size()));
    }
    observations = with_further_channels(observations, base, imaging, plan);
    observations.scalars.values[2].reset();  // the ends tell it
    return observations;
}

Observations with_further_channels(const Observations& measured, const Simulation& base,
                                   const Imaging& imaging, const PlannedMeasurement& plan)
{
    constexpr double everywhere = std::numeric_limits<double>::infinity();
    Observations planned = measured;
    const double distal = distal_end(base.deployment), proximal = proximal_end(base.deployment);
    const std::array<MeasuredValue, 3> predicted = {
        MeasuredValue{distal, plan.end_sd}, MeasuredValue{proximal, plan.end_sd},
        MeasuredValue{distal - proximal, plan.length_sd}};
    for (std::size_t i = 0; i < predicted.size(); ++i) {
        if (!planned.scalars.values[i]) planned.scalars.values[i] = predicted[i];
    }
    if (planned.density.places.empty()) planned.density = planned_density(base, imaging, plan);
    const double force = contact_force(base.deployment, -everywhere, everywhere);
    if (!planned.scalars.contact_force && force > 0.0)
        planned.scalars.contact_force = {.force = {force, plan.force_sd * force}};
    return planned;
}

PlannedRows planned_rows(const Observations& measured, const Observations& planned,
                         const PlannedMeasurement& plan)
{
    const ResidualRows all = residual_rows(planned);
    PlannedRows rows;
    assign(rows, row_range(0, all.num_patches), true, "surface", "");
    int row = static_cast<int>(all.lengths);
    for (std::size_t i = 0; i < planned.scalars.values.size(); ++i) {
        if (!planned.scalars.values[i]) continue;
        const bool is_end = i < 2;
        assign(rows, {row++}, measured.scalars.values[i].has_value(),
               is_end ? "end_markers" : "implanted_length",
               is_end ? ends_text(measured, plan)
                      : fmt::format("the implanted length to {:.2g} mm", 1e3 * plan.length_sd));
    }
    assign(rows, row_range(all.density, all.num_density), !measured.density.places.empty(),
           "density_map",
           fmt::format("the density of the wires to {:.2g} % in squares of {:.2g} mm",
                       100.0 * plan.density_sd, 1e3 * plan.density_window));
    assign(rows, row_range(all.force, all.num_force), measured.scalars.contact_force.has_value(),
           "contact_force",
           fmt::format("the force on the wall to {:.2g} %", 100.0 * plan.force_sd));
    return rows;
}

}  // namespace braidzone
