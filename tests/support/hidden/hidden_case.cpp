#include "support/hidden/hidden_case.hpp"

#include "core/phantom_file.hpp"
#include "support/devices_of_any_size.hpp"
#include "support/hidden/hidden_density.hpp"
#include "support/hidden/smooth_field.hpp"

#include <array>
#include <limits>
#include <numbers>
#include <utility>

namespace braidzone::hidden {

namespace {

/// A Pipeline of 4 x 20 mm with the library's scale of forces.
FlowDiverter library_device()
{
    FlowDiverter device = test::pipeline(4e-3);
    device.force_scale = 61.0;
    return device;
}

/// The motion that undoes that of the scan, as the catalogue's `registration` has it.
void set_registration(HiddenCase& made)
{
    for (HiddenEffect& effect : made.effects) {
        if (effect.name != "registration") continue;
        constexpr std::array axes = {"x", "y", "z"};
        for (int i = 0; i < 3; ++i) {
            const std::string axis = axes[static_cast<std::size_t>(i)];
            effect.values["shift_" + axis] = -made.scan.shift[i];
            effect.values["rotation_" + axis] = -made.scan.rotation[i];
        }
    }
}

/// What happens in a random vessel. An effect that is left out draws its numbers all the same.
HiddenStory random_story(std::span<const EffectChoice> effects, std::optional<std::size_t> left_out,
                         std::mt19937& random)
{
    HiddenStory story = story_of(random_belief(random));
    for (std::size_t i = 0; i < effects.size(); ++i) {
        HiddenStory elsewhere = story;
        hide(effects[i].name, effects[i].size, left_out == i ? elsewhere : story, random);
    }
    return story;
}

ScanErrors without_scatter(ScanErrors errors)
{
    errors.num_points = 8000;
    errors.num_holes = 0;
    errors.streak_width = errors.missing_end = errors.unevenness = 0.0;
    errors.noise_sd = errors.bias_sd = errors.voxel_pull = 0.0;
    errors.shift_sd = errors.angle_sd = 0.0;
    errors.outlier_share = errors.artefact_share = 0.0;
    errors.end_sd = 0.0;
    return errors;
}

}  // namespace

Belief random_belief(std::mt19937& random)
{
    constexpr double degree = std::numbers::pi / 180.0;
    Belief belief;
    const double radius = between(1.82e-3, 1.95e-3, random);
    belief.phantom.segments = {
        {8e-3, 0.0, 0.0}, {14e-3, between(20.0, 60.0, random) * degree, 0.0}, {8e-3, 0.0, 0.0}};
    belief.phantom.proximal_radius = radius;
    belief.phantom.distal_radius = radius - between(0.0, 0.1e-3, random);
    belief.phantom.blend_radius = 0.4e-3;
    belief.phantom.sacs = {{.position = between(13.5e-3, 16.5e-3, random),
                            .direction = std::numbers::pi,
                            .diameter = 7e-3,
                            .height = 7e-3,
                            .neck = between(4e-3, 5e-3, random)}};
    belief.device = library_device();
    belief.landing = between(24.5e-3, 25.5e-3, random);
    return belief;
}

Belief sidewall_belief(const std::filesystem::path& source)
{
    return {read_phantom(TomlTable::read_file(source / "cases/sidewall_aneurysm/phantom.toml")),
            library_device(), 25e-3};
}

HiddenStory story_of(const Belief& belief)
{
    HiddenStory story;
    story.belief = belief;
    story.scene.phantom = belief.phantom;
    story.scene.device = belief.device;
    story.scene.landing = belief.landing;
    return story;
}

HiddenCase made_case(HiddenStory story, const Background& background, const ScanErrors& errors,
                     std::mt19937& random)
{
    std::normal_distribution<double> normal;
    HiddenScene& scene = story.scene;
    scene.landing += background.landing_sd * normal(random);
    scene.device.radial_coefficient *= 1.0 + background.spring_sd * normal(random);
    scene.device.surface_coefficient *= 1.0 + background.spring_sd * normal(random);
    scene.device.braid_ratio *= 1.0 + background.braid_ratio_sd * normal(random);
    const SmoothField rough(background.wall_sd, background.correlation_length, random);
    const WallLevel given = scene.unevenness;
    scene.unevenness = [=](const Vec3& point) { return given(point) + rough(point); };
    HiddenCase made{.belief = story.belief,
                    .scan = {},
                    .effects = story.effects,
                    .device = placed_device(scene),
                    .true_device = scene.device};
    made.scan = scanned(made.device, story.scan, errors, random);
    set_registration(made);
    return made;
}

FurtherData further_data(const HiddenCase& made, std::uint32_t seed)
{
    constexpr double everywhere = std::numeric_limits<double>::infinity();
    constexpr double force_sd = 0.15;
    std::mt19937 random(seed);
    std::normal_distribution<double> normal;
    FurtherData data{.density = counted_pores(made.device, made.true_device, {}, random),
                     .force = {}};
    for (DensityPlace& place : data.density.places)
        place.point = as_scanned(made.scan, place.point);
    const double force = wall_force(made.device, -everywhere, everywhere);
    data.force.force = {force * (1.0 + force_sd * normal(random)), force_sd * force};
    return data;
}

HiddenCase random_case(std::span<const EffectChoice> effects, std::uint32_t seed)
{
    std::mt19937 random(seed);
    HiddenStory story = random_story(effects, std::nullopt, random);
    const ScanErrors errors = random_scan_errors(random);
    HiddenCase made = made_case(std::move(story), {}, errors, random);
    made.seed = seed;
    return made;
}

HiddenCase clean_case(std::span<const EffectChoice> effects, std::uint32_t seed,
                      std::optional<std::size_t> left_out)
{
    std::mt19937 random(seed);
    HiddenStory story = random_story(effects, left_out, random);
    HiddenCase made =
        made_case(std::move(story), {}, without_scatter(random_scan_errors(random)), random);
    made.seed = seed;
    return made;
}

}  // namespace braidzone::hidden
