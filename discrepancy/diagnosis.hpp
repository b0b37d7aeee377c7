#pragma once

#include "deploy/neck.hpp"
#include "discrepancy/device_prediction.hpp"
#include "discrepancy/discrepancy_clusters.hpp"
#include "discrepancy/effect.hpp"
#include "discrepancy/explanation.hpp"
#include "discrepancy/further_measurement.hpp"
#include "discrepancy/gap.hpp"
#include "discrepancy/held_out.hpp"
#include "discrepancy/residual_memory.hpp"

#include <optional>
#include <vector>

namespace braidzone {

/// Of a surface: effects in reality are not quite of the shape that they have here, and where an
/// unknown effect is about as probable as a known one, both are answers.
ExplainOptions surface_options();

struct DiagnoseOptions {
    NoiseFloor floor;
    PatchOptions patches;
    ClusterOptions clusters;
    ExplainOptions explain;            ///< `surface_options`
    ResidualMemory* memory = nullptr;  ///< of deployments that an interrupted diagnosis made

    DiagnoseOptions();
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
    std::vector<Patch> artefacts = {};  ///< that were left out (`leave_out_artefacts`)
    ErrorModel error = {};
    DiscrepancyMap map = {};                ///< of the case as it is
    std::vector<ClusterPlace> places = {};  ///< of its clusters
    Explanation explanation = {};           ///< residuals in the units of `residuals`
    FurtherMeasurement further = {};        ///< that would tell the answers apart
    std::optional<Model> after = {};        ///< the base model with the best answer's effects
    std::optional<DiscrepancyMap> map_after = {};
    DevicePrediction predicted_before = {};  ///< of the case as it is
    std::optional<DevicePrediction> predicted_after = {};
    std::vector<int> zone = {};  ///< patches that the effects move, or of the clusters
    GapComparison everywhere = {}, in_zone = {};
    HeldOutGap held_out = {};  ///< in the blocks of `surface_folds`
    GapComparison gap_held_out = {};
    double background = 1.0;  ///< `background_scale` of the best model

    /// True if the best answer does not explain all: a structured gap remains, the rest scatters
    /// more than the noise floor allows, or something unknown may be the cause in its place.
    bool leaves_doubt() const;
};

/// What the effects start from, for measured points.
EffectSetting effect_setting(const Model& base, const Simulation& simulation,
                             const std::vector<Vec3>& points);

/// Finds where a measured device differs from the simulated one, and which effect explains it.
///
/// @param base    the case
/// @param points  measured, in the frame of the scan [m]
/// @param catalogue  effects to choose from
/// @param density  measured in the same frame; no places if it was not
/// @throws InputError if the points cannot be compared with the device (`require_comparable`), or
///         fill fewer than 20 patches, the density map does not lie over the device
///         (`make_density_field`), or a measured force acts on a stretch without device; else what
///         the deployment of the case throws
Diagnosis diagnose(const Model& base, const Lumen& lumen, std::vector<Vec3> points,
                   const MeasuredScalars& scalars, const std::vector<Effect>& catalogue,
                   const DiagnoseOptions& options = {}, const DensityMap& density = {});

}  // namespace braidzone
