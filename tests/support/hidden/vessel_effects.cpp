#include "core/phantom_axis.hpp"
#include "support/hidden/hidden_effect.hpp"
#include "support/hidden/straightened_bend.hpp"

#include <algorithm>
#include <cmath>

namespace braidzone::hidden {
namespace {

/// Mean contact pressure of Zavodszky et al. 2020, Table 3 [Pa].
constexpr double typical_pressure = 4400.0;

/// The true vessel was narrower or wider than it was segmented; never so wide that the device would
/// lie loose in it.
std::map<std::string, double> hide_offset(HiddenStory& story, EffectSize size, std::mt19937& random)
{
    const Belief& belief = story.belief;
    const double room = belief.device.nominal_radius() - 0.03e-3 - belief.phantom.proximal_radius;
    double offset = either_sign(sized(size, {0.05e-3, 0.08e-3, 0.12e-3, 0.18e-3}, random), random);
    if (offset > room) offset = -offset;
    story.scene.phantom.proximal_radius += offset;
    story.scene.phantom.distal_radius += offset;
    return {{"wall_offset", offset}};
}

/// Springs that have stiffened by half where a typical pressure has displaced them.
std::map<std::string, double> hide_compliance(HiddenStory& story, EffectSize size,
                                              std::mt19937& random)
{
    const double displacement = sized(size, {0.05e-3, 0.08e-3, 0.13e-3, 0.2e-3}, random);
    WallSprings& springs = story.scene.springs;
    springs.stiffness = typical_pressure / (1.5 * displacement);
    springs.stiffening = 0.5 * springs.stiffness / std::pow(displacement, 2);
    return {{"displacement", displacement}};
}

std::map<std::string, double> hide_straightening(HiddenStory& story, EffectSize size,
                                                 std::mt19937& random)
{
    const double share = sized(size, {0.15, 0.25, 0.4, 0.6}, random);
    HiddenScene& scene = story.scene;
    const double to = story.belief.landing, from = to - story.belief.device.nominal_length;
    scene.phantom.segments = straightened(scene.phantom.segments, share);
    scene.frame = aligned(make_axis(scene.phantom.segments),
                          make_axis(story.belief.phantom.segments), from, to);
    return {{"share", share}};
}

}  // namespace

std::vector<EffectMaker> vessel_effects()
{
    return {{"vessel_offset", true, hide_offset},
            {"wall_compliance", true, hide_compliance},
            {"vessel_straightening", true, hide_straightening}};
}

}  // namespace braidzone::hidden
