// A sidewall aneurysm with something hidden in its measurement, from a generator with mechanics of
// its own (support/hidden).

#include "core/error.hpp"
#include "discrepancy/blind/case_folder.hpp"
#include "discrepancy/diagnosis.hpp"
#include "support/hidden/hidden_density.hpp"
#include "support/hidden/spacing_stretch.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace braidzone {
namespace {

using testing::ElementsAre;

hidden::Belief belief()
{
    return hidden::sidewall_belief(BRAIDZONE_SOURCE_DIR);
}

const Lumen& sidewall()
{
    static const Lumen lumen = blind::believed_lumen(belief().phantom);
    return lumen;
}

std::vector<Effect> catalogue_of(const std::vector<std::string>& names)
{
    std::vector<Effect> chosen;
    for (const Effect& effect : effect_catalogue()) {
        if (std::find(names.begin(), names.end(), effect.name) != names.end())
            chosen.push_back(effect);
    }
    return chosen;
}

hidden::ScannedDevice scan_of(hidden::HiddenStory story, std::uint32_t seed)
{
    std::mt19937 random(seed);
    return hidden::made_case(std::move(story), {}, {}, random).scan;
}

/// A push in front of the neck.
hidden::HiddenStory push_story(double change)
{
    hidden::HiddenStory story = hidden::story_of(belief());
    hidden::add_stretch(
        story.scene,
        {.centre = 15e-3, .half_width = 1.8e-3, .change = change, .ripple = 0.05, .rebound = 0.1});
    return story;
}

/// One effect at a time: how often a second one is found that is not there is a matter of rates
/// (blind/README.md).
Diagnosis diagnosed(const hidden::HiddenStory& story, std::uint32_t seed,
                    const std::vector<Effect>& catalogue)
{
    const hidden::ScannedDevice scan = scan_of(story, seed);
    DiagnoseOptions options;
    options.explain.search.most_effects = 1;
    return diagnose(blind::believed_model(belief()), sidewall(), scan.points, scan.ends, catalogue,
                    options);
}

}  // namespace

TEST(Diagnose, NamesAndPlacesAHiddenPush)
{
    const Diagnosis found = diagnosed(push_story(-0.6), 4,
                                      catalogue_of({"local_push", "nominal_diameter", "blooming",
                                                    "vessel_offset", "landing_offset"}));
    EXPECT_EQ(found.explanation.verdict.finding, Finding::named);
    std::string answers;
    for (const Answer& answer : found.explanation.verdict.answers)
        answers += fmt::format(" [{}]", fmt::join(answer.effects, " "));
    ASSERT_EQ(found.explanation.verdict.answers.size(), 1u) << answers;
    EXPECT_THAT(found.explanation.verdict.answers.front().effects, ElementsAre("local_push"));
    const EffectFit& fit = found.explanation.fits[*found.explanation.best];
    std::string ends;
    for (const FitMode& mode : fit.modes)
        ends += fmt::format(" {:.2f} mm: {:.1f}", 1e3 * mode.values[1], mode.log_evidence);
    EXPECT_NEAR(fit.effects.front().values[1], 15e-3, 1e-3) << ends;
    EXPECT_LT(found.in_zone.after.rms, found.in_zone.before.rms);
    ASSERT_TRUE(found.after.has_value());
    EXPECT_EQ(found.after->schedule.windows.size(), 1u);
}

// Neither ends nor length: pores counted to 15 %, and the force on the wall to 10 %.
TEST(Diagnose, FindsAPushByTheDensityOfItsWires)
{
    constexpr double everywhere = std::numeric_limits<double>::infinity();
    std::mt19937 random(4);
    const hidden::HiddenCase made = hidden::made_case(push_story(-0.6), {}, {}, random);
    const DensityMap density = hidden::counted_pores(made.device, made.true_device, {}, random);
    const double force = hidden::wall_force(made.device, -everywhere, everywhere);
    MeasuredScalars scalars;
    scalars.contact_force = {.force = {force, 0.1 * force}};
    DiagnoseOptions options;
    options.explain.search.most_effects = 1;
    const Diagnosis found =
        diagnose(blind::believed_model(belief()), sidewall(), made.scan.points, scalars,
                 catalogue_of({"local_push", "nominal_diameter", "vessel_offset", "braid_ratio"}),
                 options, density);
    ASSERT_EQ(found.explanation.verdict.finding, Finding::named);
    EXPECT_THAT(found.explanation.verdict.answers.front().effects, ElementsAre("local_push"));
    const double length = made.device.arc_length.front() - made.device.arc_length.back();
    ASSERT_TRUE(found.predicted_after.has_value());
    EXPECT_GT(found.predicted_before.implanted_length, length + 1e-3);
    EXPECT_NEAR(found.predicted_after->implanted_length, length, 0.6e-3);
    EXPECT_GT(*found.predicted_after->mean_density_increase_neck,
              *found.predicted_before.mean_density_increase_neck + 0.3);
    // Residuals of the densities are down to their noise.
    const ResidualRows rows = residual_rows(found.observations);
    const auto misfit = [&](const Eigen::VectorXd& residuals) {
        return residuals.segment(rows.density, rows.num_density)
                   .cwiseQuotient(
                       found.error.white.segment(rows.density, rows.num_density).cwiseSqrt())
                   .squaredNorm() /
               static_cast<double>(rows.num_density);
    };
    EXPECT_GT(misfit(found.explanation.base_residuals), 3.0);
    EXPECT_LT(misfit(found.explanation.residuals_after()), 1.6);
}

TEST(Diagnose, RefusesAForceWhereNoDeviceLies)
{
    const hidden::ScannedDevice scan = scan_of(hidden::story_of(belief()), 2);
    MeasuredScalars scalars;
    scalars.contact_force = {.force = {0.1, 0.02}, .from = 1e-3, .to = 3e-3};
    try {
        diagnose(blind::believed_model(belief()), sidewall(), scan.points, scalars, {});
        FAIL();
    } catch (const InputError& error) {
        EXPECT_THAT(error.what(),
                    testing::HasSubstr("the measured contact force acts from 1 to 3 mm along the "
                                       "centerline, the simulated device lies from"));
    }
}

TEST(Diagnose, FindsNothingWhereNothingIsHidden)
{
    const Diagnosis found =
        diagnosed(hidden::story_of(belief()), 2,
                  catalogue_of({"nominal_diameter", "blooming", "vessel_offset"}));
    EXPECT_EQ(found.explanation.verdict.finding, Finding::nothing_missing);
    EXPECT_FALSE(found.after.has_value());
}

// A dent that no deployment makes: never one name without a flag.
TEST(Diagnose, DoesNotNameWhatItDoesNotKnow)
{
    const CrossSection at = section_at(sidewall().centerline, 20e-3);
    const Vec3 place = at.origin + 1.9e-3 * at.normal;
    hidden::HiddenStory story = hidden::story_of(belief());
    story.scene.unevenness = [=](const Vec3& p) {
        return -0.4e-3 * std::exp(-0.5 * (p - place).squaredNorm() / 1.2e-6);
    };
    const Diagnosis found = diagnosed(
        story, 3, catalogue_of({"nominal_diameter", "blooming", "vessel_offset", "registration"}));
    EXPECT_TRUE(found.explanation.verdict.finding == Finding::unknown ||
                found.explanation.verdict.has_unexplained_rest);
    ASSERT_FALSE(found.map.clusters.empty());
    EXPECT_LT(found.map.clusters.front().p_family_wise, 0.05);
    EXPECT_NEAR(found.map.clusters.front().arc_length, 20e-3, 1e-3);
    Eigen::Index deepest = 0;
    found.explanation.unexplained.minCoeff(&deepest);
    EXPECT_LT(found.explanation.unexplained[deepest], -0.1e-3);
}

// The catalogue without the effect that is there: another name must not take its place unflagged.
TEST(Diagnose, SaysUnknownWithoutTheEffectInTheCatalogue)
{
    const Diagnosis found =
        diagnosed(push_story(-0.66), 1, catalogue_of({"blooming", "braid_ratio"}));
    EXPECT_NE(found.explanation.verdict.finding, Finding::nothing_missing);
    EXPECT_TRUE(found.explanation.verdict.finding == Finding::unknown ||
                found.explanation.verdict.has_unexplained_rest);
}

// Without a neck the wall holds the device all along, and a push leaves no trace on the surface:
// nothing is named, and not even that of the paper, 0.66, is said to have been seen.
TEST(Diagnose, CannotTellAPushWhereTheWallHoldsTheWholeDevice)
{
    hidden::Belief tube = belief();
    tube.phantom.sacs.clear();
    hidden::HiddenStory story = hidden::story_of(tube);
    hidden::add_stretch(story.scene, {.centre = 15e-3, .half_width = 1.8e-3, .change = -0.66});
    const DiagnoseOptions options;
    const Diagnosis found =
        diagnose(blind::believed_model(tube), blind::believed_lumen(tube.phantom),
                 scan_of(story, 6).points, {}, catalogue_of({"local_push"}), options);
    EXPECT_EQ(found.explanation.verdict.finding, Finding::nothing_missing);
    const auto& limit = found.explanation.limits.front();
    EXPECT_TRUE(!limit || limit->amplitude > 0.66);
}

TEST(Diagnose, ReportsAnEffectThatCannotBeSimulated)
{
    Effect broken = catalogue_of({"nominal_diameter"}).front();
    broken.apply = [](const EffectSetting&, const std::vector<double>&) -> Model {
        throw GeometryError("the device breaks");
    };
    const Diagnosis found = diagnosed(hidden::story_of(belief()), 2, {broken});
    EXPECT_EQ(found.explanation.fits.front().failure, "the device breaks");
    EXPECT_TRUE(found.explanation.named.empty());
    EXPECT_EQ(found.explanation.verdict.finding, Finding::nothing_missing);
}

TEST(Diagnose, RefusesTooFewPatches)
{
    const hidden::ScannedDevice scan = scan_of(hidden::story_of(belief()), 2);
    std::vector<Vec3> few;
    for (std::size_t i = 0; i < scan.points.size(); i += 40)
        few.push_back(scan.points[i]);
    try {
        diagnose(blind::believed_model(belief()), sidewall(), few, {}, {});
        FAIL();
    } catch (const InputError& error) {
        EXPECT_THAT(error.what(), testing::HasSubstr("patches of the device, 0.8 mm by 30 degrees "
                                                     "with at least 4 points each; 20 are needed"));
    }
}

}  // namespace braidzone
