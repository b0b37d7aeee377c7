#include "support/hidden/hidden_effect.hpp"

#include <numbers>

namespace braidzone::hidden {
namespace {

Vec3 random_direction(std::mt19937& random)
{
    std::normal_distribution<double> normal;
    const double x = normal(random), y = normal(random), z = normal(random);
    return Vec3(x, y, z).normalized();
}

/// The whole motion of the scan, its nuisance besides, is known when it is scanned.
std::map<std::string, double> hide_registration(HiddenStory& story, EffectSize size,
                                                std::mt19937& random)
{
    constexpr double degree = std::numbers::pi / 180.0;
    const double shift = sized(size, {0.25e-3, 0.35e-3, 0.5e-3, 0.8e-3}, random);
    const double angle =
        sized(size, {1.5 * degree, 2.5 * degree, 3.5 * degree, 5.0 * degree}, random);
    story.scan.shift += shift * random_direction(random);
    story.scan.rotation += angle * random_direction(random);
    return {{"shift", shift}, {"rotation", angle}};
}

/// A higher threshold than half loses the surface altogether before long.
std::map<std::string, double> hide_blooming(HiddenStory& story, EffectSize size,
                                            std::mt19937& random)
{
    const double blooming = between(0.0, 1.0, random) < 0.4
                                ? -sized(size, {0.05e-3, 0.07e-3, 0.09e-3, 0.12e-3}, random)
                                : sized(size, {0.06e-3, 0.1e-3, 0.15e-3, 0.22e-3}, random);
    story.scan.blooming += blooming;
    return {{"blooming", blooming}};
}

}  // namespace

std::vector<EffectMaker> scan_effects()
{
    return {{"registration", true, hide_registration}, {"blooming", true, hide_blooming}};
}

}  // namespace braidzone::hidden
