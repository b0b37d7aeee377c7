#pragma once

#include "deploy/neck.hpp"
#include "discrepancy/discrepancy_clusters.hpp"
#include "discrepancy/effect_fit.hpp"
#include "discrepancy/gap.hpp"
#include "discrepancy/verdict.hpp"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace braidzone {

struct DiagnoseOptions {
    NoiseFloor floor;
    PatchOptions patches;
    ClusterOptions clusters;
    FitOptions fit;
    VerdictOptions verdict;
    /// How wrong an effect's shape may be, over its size: what is left of it must not be taken for
    /// a second effect.
    double implementation_error = 0.2;
    /// Told of what is going on, from any thread, one call at a time.
    std::function<void(const std::string&)> on_progress = {};
};

/// Shares of a cluster's area in parts of the device.
struct ClusterPlace {
    double neck = 0.0;  ///< over crossings in front of the vessel's openings
    double ends = 0.0;  ///< within 2 mm of the device's ends
};

/// A diagnosis: what was found, and everything that led to it.
struct Diagnosis {
    EffectSetting setting;
    Simulation base;
    std::vector<WallOpening> openings = {};
    Observations observations;
    ErrorModel error = {};
    Eigen::VectorXd base_residuals = {};    ///< [m]
    DiscrepancyMap map = {};                ///< of the case as it is
    std::vector<ClusterPlace> places = {};  ///< of its clusters
    double chi_square = 0.0;                ///< without an effect
    std::vector<EffectFit> fits = {};       ///< in the catalogue's order
    std::vector<NamedEvidence> named = {};  ///< of the effects that could be simulated
    double log_evidence_unknown = 0.0;
    double log_evidence_scalars = 0.0;  ///< `unknown_scalars_evidence`
    Verdict verdict = {};
    /// The first effect of the verdict, in `fits`; none if it names no effect.
    std::optional<std::size_t> best = {};
    std::optional<Model> after = {};  ///< the base model with that effect
    std::optional<DiscrepancyMap> map_after = {};
    Eigen::VectorXd unexplained = {};  ///< mean of the unknown effect besides it [m]
    std::vector<int> zone = {};        ///< patches that the effect moves, or of the clusters
    GapComparison everywhere = {}, in_zone = {};
    double background = 1.0;  ///< `background_scale` of the best model
    int num_runs = 0;         ///< deployments
};

/// Finds where a measured device differs from the simulated one, and which effect explains it.
///
/// @param base    the case
/// @param points  measured, in the frame of the scan [m]
/// @param catalogue  effects to choose from
/// @throws InputError if the points cannot be compared with the device (`require_comparable`), or
///         fill fewer than 20 patches; else what the deployment of the case throws
Diagnosis diagnose(const Model& base, const Lumen& lumen, std::vector<Vec3> points,
                   const MeasuredScalars& scalars, const std::vector<Effect>& catalogue,
                   const DiagnoseOptions& options = {});

}  // namespace braidzone
