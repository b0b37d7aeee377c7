#pragma once

#include "support/hidden/hidden_scan.hpp"
#include "support/hidden/hidden_scene.hpp"

#include <array>
#include <functional>
#include <map>
#include <random>
#include <string>
#include <string_view>
#include <vector>

namespace braidzone::hidden {

/// What the user of a case believes.
struct Belief {
    Phantom phantom;
    FlowDiverter device;
    double landing = 0.0;  ///< arc length of the distal end [m]
};

enum class EffectSize { weak, medium, strong };

/// "weak", "medium" or "strong".
std::string_view name_of(EffectSize size);

/// An effect that was hidden: the truth about it.
struct HiddenEffect {
    std::string name;
    EffectSize size = EffectSize::medium;
    /// Its parameters [SI], named as those of the catalogue's effect where both mean the same.
    std::map<std::string, double> values = {};
};

/// Case in the making.
struct HiddenStory {
    Belief belief;
    HiddenScene scene;
    HiddenScan scan;
    std::vector<HiddenEffect> effects;
};

/// An effect that can be hidden.
struct EffectMaker {
    std::string_view name;
    bool in_catalogue;  ///< whether the diagnosis can know it
    /// Hides it in the story.
    /// @return its parameters
    std::function<std::map<std::string, double>(HiddenStory&, EffectSize, std::mt19937&)> hide;
};

/// All of them, the catalogue's first.
const std::vector<EffectMaker>& effect_makers();

/// Hides an effect and adds it to the story's effects.
/// @throws std::invalid_argument if there is no such effect
void hide(std::string_view name, EffectSize size, HiddenStory& story, std::mt19937& random);

// By what they change; each list in a file of its own.
std::vector<EffectMaker> release_effects();
std::vector<EffectMaker> device_effects();
std::vector<EffectMaker> vessel_effects();
std::vector<EffectMaker> scan_effects();
std::vector<EffectMaker> unknown_effects();

/// Bounds of the three sizes: weak between the first two, and so on.
using SizeBounds = std::array<double, 4>;

double sized(EffectSize size, const SizeBounds& bounds, std::mt19937& random);
double between(double low, double high, std::mt19937& random);
double either_sign(double value, std::mt19937& random);

/// Arc length of a place on the device away from its ends [m].
double along_device(const Belief& belief, std::mt19937& random);

/// Arc length of the middle of the sac's neck [m].
double neck_of(const Belief& belief);

}  // namespace braidzone::hidden
