#include "discrepancy/diagnosis.hpp"

#include "core/error.hpp"
#include "discrepancy/artefacts.hpp"
#include "discrepancy/background_estimate.hpp"
#include "discrepancy/hub_slopes.hpp"
#include "discrepancy/measurement_check.hpp"
#include "discrepancy/surface_folds.hpp"
#include "discrepancy/surface_further.hpp"
#include "discrepancy/surface_problem.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <utility>

namespace braidzone {
namespace {

constexpr int fewest_patches = 20;
constexpr double end_zone = 2e-3;          // [m]
constexpr double significant = 0.05;       // family-wise p of a cluster
constexpr double zone_share = 0.3;         // of an effect's largest change
constexpr double smallest_change = 20e-6;  // that belongs to its zone [m]

std::size_t index(Eigen::Index i)
{
    return static_cast<std::size_t>(i);
}

Vec3 mean_of(const std::vector<Vec3>& points)
{
    Vec3 sum = Vec3::Zero();
    for (const Vec3& point : points)
        sum += point;
    return sum / static_cast<double>(points.size());
}

ClusterPlace place_of(const Cluster& cluster, const Diagnosis& diagnosis,
                      const std::vector<char>& in_opening)
{
    ClusterPlace place;
    for (const int i : cluster.patches) {
        const Patch& patch = diagnosis.observations.field.patches[index(i)];
        double open = 0.0;
        for (const int node : patch.nodes)
            open += in_opening[index(node)] != 0 ? 1.0 : 0.0;
        place.neck += patch.area * open / static_cast<double>(patch.nodes.size());
        if (patch.arc_length < diagnosis.setting.from + end_zone ||
            patch.arc_length > diagnosis.setting.to - end_zone) {
            place.ends += patch.area;
        }
    }
    place.neck /= cluster.area;
    place.ends /= cluster.area;
    return place;
}

std::vector<int> zone_of(const Diagnosis& diagnosis)
{
    std::vector<int> zone;
    const Explanation& explanation = diagnosis.explanation;
    if (explanation.best) {
        const Eigen::VectorXd change = (explanation.base_residuals - explanation.residuals_after())
                                           .head(diagnosis.error.num_patches)
                                           .cwiseAbs();
        const double least = std::max(zone_share * change.maxCoeff(), smallest_change);
        for (Eigen::Index i = 0; i < change.size(); ++i) {
            if (change[i] >= least) zone.push_back(static_cast<int>(i));
        }
        return zone;
    }
    for (const Cluster& cluster : diagnosis.map.clusters) {
        if (cluster.p_family_wise < significant)
            zone.insert(zone.end(), cluster.patches.begin(), cluster.patches.end());
    }
    std::sort(zone.begin(), zone.end());
    return zone;
}

/// Before and after, with the model that the verdict names.
void compare(Diagnosis& diagnosis, const DiagnosisProblem& problem, const DiagnoseOptions& options)
{
    const Eigen::Index n = diagnosis.error.num_patches;
    const DiscrepancyField& field = diagnosis.observations.field;
    const Eigen::VectorXd& before = diagnosis.explanation.base_residuals;
    const Eigen::VectorXd& after = diagnosis.explanation.residuals_after();
    if (diagnosis.explanation.best) {
        diagnosis.map_after =
            make_discrepancy_map(field, diagnosis.error, after.head(n), options.clusters);
    }
    diagnosis.zone = zone_of(diagnosis);
    std::vector<int> all(index(n));
    std::iota(all.begin(), all.end(), 0);
    const Eigen::MatrixXd smoothing = smoothing_matrix(field, options.clusters.kernel);
    const Eigen::MatrixXd taking = registration_taken_out(diagnosis.error);
    const auto compared = [&](const std::vector<int>& patches) -> GapComparison {
        return {static_cast<int>(patches.size()), gap_figures(taking * before, smoothing, patches),
                gap_figures(taking * after, smoothing, patches),
                floor_figures(taking, problem.covariance, smoothing, patches)};
    };
    diagnosis.everywhere = compared(all);
    diagnosis.in_zone = compared(diagnosis.zone);
    const std::vector<std::vector<int>> folds = surface_folds(field);
    diagnosis.held_out =
        held_out_gap(problem, diagnosis.explanation, folds, held_out_buffer, options.explain);
    diagnosis.gap_held_out = {static_cast<int>(all.size()),
                              gap_figures(diagnosis.held_out.before, smoothing, all),
                              gap_figures(diagnosis.held_out.after, smoothing, all),
                              floor_figures(held_out_rows(problem, folds, held_out_buffer),
                                            problem.covariance, smoothing, all)};
    diagnosis.background = background_scale(diagnosis.error, after);
}

}  // namespace

ExplainOptions surface_options()
{
    ExplainOptions options;
    options.verdict.offers_unknown = true;
    options.doubts_shapes = true;
    return options;
}

DiagnoseOptions::DiagnoseOptions() : explain(surface_options()) {}

bool Diagnosis::leaves_doubt() const
{
    const Verdict& verdict = explanation.verdict;
    return verdict.has_unexplained_rest || verdict.unknown_lead.has_value() ||
           background > largest_background_scale;
}

EffectSetting effect_setting(const Model& base, const Simulation& simulation,
                             const std::vector<Vec3>& points)
{
    return {.base = base,
            .from = proximal_end(simulation.deployment),
            .to = distal_end(simulation.deployment),
            .middle = mean_of(points)};
}

Diagnosis diagnose(const Model& base, const Lumen& lumen, std::vector<Vec3> points,
                   const MeasuredScalars& scalars, const std::vector<Effect>& catalogue,
                   const DiagnoseOptions& options, const DensityMap& density)
{
    Simulation simulation = simulate(base, lumen);
    require_comparable(points, base.imaging, simulation, lumen);
    require_force_on_device(scalars, simulation.deployment);
    DensityField density_field = make_density_field(density, base.imaging, simulation);
    EffectSetting setting = effect_setting(base, simulation, points);
    DiscrepancyField field =
        make_discrepancy_field(points, base.imaging, simulation, options.patches);
    if (static_cast<int>(field.patches.size()) < fewest_patches) {
        throw InputError(fmt::format(
            "the measured points fill {} patches of the device, {:.3g} mm by {:.3g} degrees with "
            "at least {} points each; {} are needed",
            field.patches.size(), 1e3 * options.patches.length, 360.0 / options.patches.around,
            options.patches.fewest_points, fewest_patches));
    }
    Diagnosis diagnosis{
        .setting = std::move(setting),
        .base = std::move(simulation),
        .openings = {},
        .observations = {std::move(points), std::move(field), scalars, std::move(density_field)}};
    diagnosis.openings = find_openings(diagnosis.base.deployment, lumen.wall);
    diagnosis.artefacts = leave_out_artefacts(
        diagnosis.observations,
        residuals(diagnosis.observations, diagnosis.base, base.imaging, diagnosis.base.surface),
        options.floor);
    set_hub_slopes(diagnosis.observations, base, diagnosis.base, lumen);
    diagnosis.error = make_error_model(diagnosis.observations, options.floor);
    const SurfaceData data{lumen,           diagnosis.setting,
                           diagnosis.base,  diagnosis.observations,
                           diagnosis.error, options.floor};
    DiagnosisProblem problem = surface_problem(data, catalogue);
    if (options.memory != nullptr) problem = options.memory->around(std::move(problem));
    diagnosis.map = make_discrepancy_map(diagnosis.observations.field, diagnosis.error,
                                         problem.residuals({}).head(diagnosis.error.num_patches),
                                         options.clusters);
    const std::vector<char> in_opening =
        nodes_of(diagnosis.openings, diagnosis.base.deployment.lattice.num_nodes());
    for (const Cluster& cluster : diagnosis.map.clusters)
        diagnosis.places.push_back(place_of(cluster, diagnosis, in_opening));

    diagnosis.explanation = explain(problem, options.explain);
    const Explanation& explanation = diagnosis.explanation;
    if (explanation.best) {
        diagnosis.after = model_with(catalogue, diagnosis.setting,
                                     active_effects(explanation.fits[*explanation.best]));
        diagnosis.predicted_after =
            predict(*diagnosis.after, simulate(*diagnosis.after, lumen), lumen);
    }
    diagnosis.predicted_before = predict(base, diagnosis.base, lumen);
    diagnosis.further = further_measurement_of(data, catalogue, explanation);
    compare(diagnosis, problem, options);
    return diagnosis;
}

}  // namespace braidzone
