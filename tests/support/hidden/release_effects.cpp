#include "support/hidden/hidden_effect.hpp"
#include "support/hidden/spacing_stretch.hpp"

namespace braidzone::hidden {
namespace {

std::map<std::string, double> hide_stretch(HiddenStory& story, double change, double centre,
                                           std::mt19937& random)
{
    const SpacingStretch stretch{.centre = centre,
                                 .half_width = between(1.4e-3, 2.2e-3, random),
                                 .change = change,
                                 .ripple = between(0.0, 0.1, random),
                                 .rebound = between(0.05, 0.15, random)};
    add_stretch(story.scene, stretch);
    return {{"spacing_change", stretch.change},
            {"centre", stretch.centre},
            {"half_width", stretch.half_width}};
}

std::map<std::string, double> hide_push(HiddenStory& story, EffectSize size, std::mt19937& random)
{
    const double change = -sized(size, {0.15, 0.3, 0.5, 0.7}, random);
    // In front of the neck, where an operator pushes for coverage.
    return hide_stretch(story, change, neck_of(story.belief) + between(-1.5e-3, 1.5e-3, random),
                        random);
}

std::map<std::string, double> hide_pull(HiddenStory& story, EffectSize size, std::mt19937& random)
{
    const double change = sized(size, {0.12, 0.2, 0.35, 0.5}, random);
    return hide_stretch(story, change, along_device(story.belief, random), random);
}

std::map<std::string, double> hide_landing(HiddenStory& story, EffectSize size,
                                           std::mt19937& random)
{
    const double offset = either_sign(sized(size, {0.6e-3, 1e-3, 1.5e-3, 2.5e-3}, random), random);
    story.scene.landing += offset;
    return {{"offset", offset}};
}

std::map<std::string, double> hide_sliding(HiddenStory& story, EffectSize size,
                                           std::mt19937& random)
{
    // The less friction, the stronger.
    story.scene.friction = sized(size, {0.07, 0.045, 0.028, 0.012}, random);
    return {{"friction", story.scene.friction}};
}

}  // namespace

std::vector<EffectMaker> release_effects()
{
    return {{"local_push", true, hide_push},
            {"local_pull", true, hide_pull},
            {"landing_offset", true, hide_landing},
            {"sliding", true, hide_sliding}};
}

}  // namespace braidzone::hidden
