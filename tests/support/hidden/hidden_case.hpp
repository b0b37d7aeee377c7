#pragma once

#include "discrepancy/density_map.hpp"
#include "support/hidden/hidden_effect.hpp"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>

namespace braidzone::hidden {

/// Imperfections of every vessel and device, whether an effect is hidden or not.
struct Background {
    double wall_sd = 0.02e-3;            ///< of the true wall about the given one [m]
    double correlation_length = 2.2e-3;  ///< of it [m]
    double landing_sd = 0.15e-3;         ///< [m]
    double spring_sd = 0.08;             ///< relative
    double braid_ratio_sd = 0.01;        ///< relative
};

/// An effect to hide.
struct EffectChoice {
    std::string name;
    EffectSize size = EffectSize::medium;
};

/// A case with its data and its truth.
struct HiddenCase {
    Belief belief;
    ScannedDevice scan;
    std::vector<HiddenEffect> effects;
    HiddenDevice device;
    FlowDiverter true_device;  ///< that was placed
    std::uint32_t seed = 0;    ///< of a random case
};

/// What may be measured besides the scan, in its frame.
struct FurtherData {
    DensityMap density;
    MeasuredContactForce force;  ///< of the whole device on the wall
};

/// Counts pores as `DensityPicture` has it, and measures the force to 15 %.
FurtherData further_data(const HiddenCase& made, std::uint32_t seed);

/// A sidewall aneurysm of a random vessel, with a 4 mm device in front of its neck.
Belief random_belief(std::mt19937& random);

/// The shipped case `cases/sidewall_aneurysm`: a 4 x 20 mm device that lands at 25 mm.
/// @param source  the project's folder
Belief sidewall_belief(const std::filesystem::path& source);

/// Where the story begins: what happened is what the user believes.
HiddenStory story_of(const Belief& belief);

/// Lets the story happen with its imperfections, and scans it.
HiddenCase made_case(HiddenStory story, const Background& background, const ScanErrors& errors,
                     std::mt19937& random);

/// A case of a random vessel with effects hidden in it; none for a case without.
HiddenCase random_case(std::span<const EffectChoice> effects, std::uint32_t seed);

/// The same case with a scan that is dense all over the device, neither noisy nor misplaced, and
/// ends that are exact: two of these differ by effects alone.
/// @param left_out  index of an effect that did not happen
HiddenCase clean_case(std::span<const EffectChoice> effects, std::uint32_t seed,
                      std::optional<std::size_t> left_out = std::nullopt);

}  // namespace braidzone::hidden
