// A sidewall aneurysm with something hidden in its measurement, from the generator that shares
// neither lattice nor mesh nor schedule with the solver under test
// (support/hidden_measurement.hpp).

#include "core/error.hpp"
#include "core/phantom_file.hpp"
#include "discrepancy/diagnosis.hpp"
#include "support/devices_of_any_size.hpp"
#include "support/hidden_measurement.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

namespace braidzone {
namespace {

using testing::ElementsAre;

Phantom sidewall_phantom()
{
    return read_phantom(TomlTable::read_file(std::filesystem::path(BRAIDZONE_SOURCE_DIR) /
                                             "cases/sidewall_aneurysm/phantom.toml"));
}

constexpr double landing = 25e-3;

FlowDiverter device()
{
    FlowDiverter device = test::pipeline(4e-3);
    device.force_scale = 61.0;
    return device;
}

const Lumen& sidewall()
{
    static const Lumen lumen = [] {
        PhantomVessel made = make_phantom(sidewall_phantom());
        Vessel vessel = make_vessel(made.wall, LengthUnit{});
        WallTree wall(vessel);
        return Lumen{std::move(vessel), std::move(wall), resample(made.centerline)};
    }();
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

Model base_model()
{
    Model model;
    model.device = device();
    model.landing_distal = landing;
    return model;
}

Diagnosis diagnosed(const test::Hidden& hidden, std::uint32_t seed,
                    const std::vector<Effect>& catalogue)
{
    const test::HiddenMeasurement measured =
        test::hidden_measurement(sidewall_phantom(), device(), landing, hidden, seed);
    return diagnose(base_model(), sidewall(), measured.points, measured.ends, catalogue);
}

}  // namespace

TEST(Diagnose, NamesAndPlacesAHiddenPush)
{
    const Diagnosis found = diagnosed({.spacing = test::smooth_spacing(15e-3, 1.8e-3, -0.6)}, 4,
                                      catalogue_of({"local_push", "nominal_diameter", "blooming",
                                                    "vessel_offset", "landing_offset"}));
    EXPECT_EQ(found.explanation.verdict.finding, Finding::named);
    ASSERT_EQ(found.explanation.verdict.answers.size(), 1u);
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

TEST(Diagnose, FindsNothingWhereNothingIsHidden)
{
    const Diagnosis found =
        diagnosed({}, 2, catalogue_of({"nominal_diameter", "blooming", "vessel_offset"}));
    EXPECT_EQ(found.explanation.verdict.finding, Finding::nothing_missing);
    EXPECT_FALSE(found.after.has_value());
}

// A dent that no deployment makes: never one name without a flag.
TEST(Diagnose, DoesNotNameWhatItDoesNotKnow)
{
    const CrossSection at = section_at(sidewall().centerline, 20e-3);
    const Vec3 place = at.origin + 1.9e-3 * at.normal;
    const Diagnosis found = diagnosed(
        {.dent =
             [=](const Vec3& p) {
                 return -0.3e-3 * std::exp(-0.5 * (p - place).squaredNorm() / 1.2e-6);
             }},
        3, catalogue_of({"nominal_diameter", "blooming", "vessel_offset", "registration"}));
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
    const Diagnosis found = diagnosed({.spacing = test::smooth_spacing(15e-3, 1.8e-3, -0.66)}, 1,
                                      catalogue_of({"blooming", "braid_ratio"}));
    EXPECT_NE(found.explanation.verdict.finding, Finding::nothing_missing);
    EXPECT_TRUE(found.explanation.verdict.finding == Finding::unknown ||
                found.explanation.verdict.has_unexplained_rest);
}

TEST(Diagnose, ReportsAnEffectThatCannotBeSimulated)
{
    Effect broken = catalogue_of({"nominal_diameter"}).front();
    broken.apply = [](const EffectSetting&, const std::vector<double>&) -> Model {
        throw GeometryError("the device breaks");
    };
    const Diagnosis found = diagnosed({}, 2, {broken});
    EXPECT_EQ(found.explanation.fits.front().failure, "the device breaks");
    EXPECT_TRUE(found.explanation.named.empty());
    EXPECT_EQ(found.explanation.verdict.finding, Finding::nothing_missing);
}

TEST(Diagnose, RefusesTooFewPatches)
{
    const test::HiddenMeasurement measured =
        test::hidden_measurement(sidewall_phantom(), device(), landing, {}, 2);
    std::vector<Vec3> few;
    for (std::size_t i = 0; i < measured.points.size(); i += 40)
        few.push_back(measured.points[i]);
    try {
        diagnose(base_model(), sidewall(), few, {}, {});
        FAIL();
    } catch (const InputError& error) {
        EXPECT_THAT(error.what(), testing::HasSubstr("patches of the device, 0.8 mm by 30 degrees "
                                                     "with at least 4 points each; 20 are needed"));
    }
}

}  // namespace braidzone
