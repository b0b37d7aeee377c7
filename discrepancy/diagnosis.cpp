#include "discrepancy/diagnosis.hpp"

#include "core/error.hpp"
#include "discrepancy/background_estimate.hpp"
#include "discrepancy/measurement_check.hpp"
#include "discrepancy/unknown_effect.hpp"
#include "discrepancy/unknown_scalars.hpp"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <mutex>
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

std::vector<EffectFit> fit_all(const std::vector<Effect>& catalogue, const FitProblem& problem,
                               const DiagnoseOptions& options)
{
    std::vector<EffectFit> fits(catalogue.size());
    std::mutex one_call;
    std::size_t done = 0;
    tbb::parallel_for(std::size_t{0}, catalogue.size(), [&](std::size_t i) {
        fits[i] = fit_effect(catalogue[i], problem, options.fit);
        const std::scoped_lock lock(one_call);
        ++done;
        if (options.on_progress) {
            options.on_progress(
                fmt::format("fitting effects: {} of {} done", done, catalogue.size()));
        }
    });
    return fits;
}

/// Covariance that allows for a wrong shape of an effect: (rho |m|)^2 more, correlated as the
/// background is.
Eigen::MatrixXd with_implementation_error(const ErrorModel& error, const Eigen::VectorXd& change,
                                          const DiscrepancyField& field,
                                          const DiagnoseOptions& options)
{
    const Eigen::Index n = error.num_patches;
    Eigen::MatrixXd covariance = error.covariance();
    const Eigen::VectorXd size = options.implementation_error * change.head(n);
    covariance.topLeftCorner(n, n) +=
        (size * size.transpose())
            .cwiseProduct(
                (-patch_distances(field).array() / options.floor.background_length).exp().matrix());
    return covariance;
}

/// The unknown effect besides a named one.
UnknownEffect unknown_besides(const Diagnosis& diagnosis, const Whitening& whitening)
{
    return {diagnosis.observations.field, whitening, diagnosis.base_residuals.size()};
}

std::vector<NamedEvidence> weigh(const Diagnosis& diagnosis, const DiagnoseOptions& options)
{
    std::vector<NamedEvidence> all(diagnosis.fits.size());
    tbb::parallel_for(std::size_t{0}, all.size(), [&](std::size_t i) {
        const EffectFit& fit = diagnosis.fits[i];
        if (!fit.failure.empty()) return;
        const Whitening whitening(
            with_implementation_error(diagnosis.error, diagnosis.base_residuals - fit.residuals,
                                      diagnosis.observations.field, options));
        all[i] = {fit.effect, fit.log_evidence,
                  unknown_besides(diagnosis, whitening).log_evidence(whitening(fit.residuals)),
                  unknown_scalars_evidence(diagnosis.error, fit.residuals)};
    });
    std::erase_if(all, [](const NamedEvidence& one) { return one.effect.empty(); });
    return all;
}

std::vector<int> zone_of(const Diagnosis& diagnosis)
{
    std::vector<int> zone;
    if (diagnosis.best) {
        const Eigen::VectorXd change =
            (diagnosis.base_residuals - diagnosis.fits[*diagnosis.best].residuals)
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
void compare(Diagnosis& diagnosis, const std::vector<Effect>& catalogue,
             const DiagnoseOptions& options)
{
    const Eigen::Index n = diagnosis.error.num_patches;
    Eigen::VectorXd after = diagnosis.base_residuals;
    const DiscrepancyField& field = diagnosis.observations.field;
    Eigen::VectorXd change = Eigen::VectorXd::Zero(after.size());
    if (!diagnosis.verdict.effects.empty()) {
        for (std::size_t i = 0; i < diagnosis.fits.size(); ++i) {
            if (diagnosis.fits[i].effect == diagnosis.verdict.effects.front()) diagnosis.best = i;
        }
        const EffectFit& fit = diagnosis.fits[*diagnosis.best];
        after = fit.residuals;
        change = diagnosis.base_residuals - after;
        diagnosis.after = catalogue[*diagnosis.best].apply(diagnosis.setting, fit.values);
        diagnosis.map_after =
            make_discrepancy_map(field, diagnosis.error, after.head(n), options.clusters);
    }
    const Whitening whitening(with_implementation_error(diagnosis.error, change, field, options));
    diagnosis.unexplained = unknown_besides(diagnosis, whitening).mean_field(whitening(after));
    diagnosis.zone = zone_of(diagnosis);
    std::vector<int> all(index(n));
    std::iota(all.begin(), all.end(), 0);
    const Eigen::MatrixXd smoothing = smoothing_matrix(field, options.clusters.kernel);
    diagnosis.everywhere =
        compare_gaps(diagnosis.error, smoothing, diagnosis.base_residuals, after, all);
    diagnosis.in_zone =
        compare_gaps(diagnosis.error, smoothing, diagnosis.base_residuals, after, diagnosis.zone);
    diagnosis.background = background_scale(diagnosis.error, after);
}

}  // namespace

Diagnosis diagnose(const Model& base, const Lumen& lumen, std::vector<Vec3> points,
                   const MeasuredScalars& scalars, const std::vector<Effect>& catalogue,
                   const DiagnoseOptions& options)
{
    Simulation simulation = simulate(base, lumen);
    require_comparable(points, base.imaging, simulation, lumen);
    EffectSetting setting{.base = base,
                          .from = proximal_end(simulation.deployment),
                          .to = distal_end(simulation.deployment),
                          .middle = mean_of(points)};
    DiscrepancyField field =
        make_discrepancy_field(points, base.imaging, simulation, options.patches);
    if (static_cast<int>(field.patches.size()) < fewest_patches) {
        throw InputError(fmt::format(
            "the measured points fill {} patches of the device, {:.3g} mm by {:.3g} degrees with "
            "at least {} points each; {} are needed",
            field.patches.size(), 1e3 * options.patches.length, 360.0 / options.patches.around,
            options.patches.fewest_points, fewest_patches));
    }
    Diagnosis diagnosis{.setting = std::move(setting),
                        .base = std::move(simulation),
                        .openings = {},
                        .observations = {std::move(points), std::move(field), scalars}};
    diagnosis.openings = find_openings(diagnosis.base.deployment, lumen.wall);
    diagnosis.error = make_error_model(diagnosis.observations, options.floor);
    diagnosis.base_residuals = residuals(diagnosis.observations, diagnosis.base, base.imaging);
    const Whitening whitening(diagnosis.error.covariance());
    const Eigen::VectorXd whitened = whitening(diagnosis.base_residuals);
    diagnosis.chi_square = whitened.squaredNorm();
    diagnosis.map = make_discrepancy_map(diagnosis.observations.field, diagnosis.error,
                                         diagnosis.base_residuals.head(diagnosis.error.num_patches),
                                         options.clusters);
    const std::vector<char> in_opening =
        nodes_of(diagnosis.openings, diagnosis.base.deployment.lattice.num_nodes());
    for (const Cluster& cluster : diagnosis.map.clusters)
        diagnosis.places.push_back(place_of(cluster, diagnosis, in_opening));

    diagnosis.fits = fit_all(catalogue,
                             {lumen, diagnosis.setting, diagnosis.base, diagnosis.observations,
                              whitening, diagnosis.base_residuals},
                             options);
    diagnosis.num_runs = 1;
    for (const EffectFit& fit : diagnosis.fits)
        diagnosis.num_runs += fit.num_runs;
    diagnosis.log_evidence_unknown = unknown_besides(diagnosis, whitening).log_evidence(whitened);
    diagnosis.named = weigh(diagnosis, options);
    diagnosis.log_evidence_scalars =
        unknown_scalars_evidence(diagnosis.error, diagnosis.base_residuals);
    diagnosis.verdict = decide(diagnosis.named, diagnosis.log_evidence_unknown,
                               diagnosis.log_evidence_scalars, options.verdict);
    compare(diagnosis, catalogue, options);
    return diagnosis;
}

}  // namespace braidzone
