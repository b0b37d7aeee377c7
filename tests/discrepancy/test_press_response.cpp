#include "core/error.hpp"
#include "discrepancy/curve_diagnosis.hpp"
#include "discrepancy/force_effects.hpp"
#include "discrepancy/press_response.hpp"
#include "support/answers.hpp"
#include "support/devices.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace braidzone {
namespace {

constexpr double stroke = 2e-3;

PressModel light_model()
{
    PressModel model{test::wire_pipeline(4e-3, 0.40), {}};
    model.options.nodes_per_ring = 8;
    return model;
}

/// One table for all tests: ten press tests.
const PressResponse& response()
{
    static const PressResponse table = make_press_response(light_model(), stroke);
    return table;
}

const std::vector<double> displacements = {0.5e-3, 1e-3, 1.5e-3, 2e-3};

/// Forces of a press test of its own.
std::vector<double> pressed(const PressModel& model)
{
    PressOptions options = model.options;
    options.stroke = stroke;
    options.step = 0.5e-3;
    std::vector<double> forces;
    for (const PressState& state : press(press_network(model.device, options).network, options))
        forces.push_back(state.force);
    forces.erase(forces.begin());
    return forces;
}

std::vector<double> ratios(const std::vector<double>& above, const std::vector<double>& below)
{
    std::vector<double> result;
    for (std::size_t i = 0; i < above.size(); ++i)
        result.push_back(above[i] / below[i]);
    return result;
}

}  // namespace

// The press test finds states of rest to a thousandth of the force.
TEST(PressResponse, IsThePressTestOfTheCaseAsItIs)
{
    for (const double ratio :
         ratios(press_forces(response(), light_model(), displacements), pressed(light_model())))
        EXPECT_NEAR(ratio, 1.0, 0.005);
}

// Not one of the tabulated ratios: between 1 and 1.49.
TEST(PressResponse, FollowsPressTestsWithOtherRadialSprings)
{
    PressModel model = light_model();
    model.options.radial_factor = 1.25;
    const std::vector<double> forces = press_forces(response(), model, displacements);
    for (const double ratio : ratios(forces, pressed(model)))
        EXPECT_NEAR(ratio, 1.0, 0.01);
    EXPECT_GT(forces.back() / press_forces(response(), light_model(), displacements).back(), 1.01);
}

// Forces are proportional to all stiffnesses together.
TEST(PressResponse, IsProportionalToACommonFactor)
{
    PressModel model = light_model();
    model.options.surface_factor = model.options.radial_factor = 2.0;
    for (const double ratio : ratios(press_forces(response(), model, displacements),
                                     press_forces(response(), light_model(), displacements)))
        EXPECT_NEAR(ratio, 2.0, 1e-12);
    PressModel thick = light_model();
    thick.device.wire_diameter *= 1.1;
    for (const double ratio : ratios(press_forces(response(), thick, displacements),
                                     press_forces(response(), light_model(), displacements)))
        EXPECT_NEAR(ratio, std::pow(1.1, 4), 1e-12);
}

TEST(PressResponse, OfTheCaseAloneIsTheSame)
{
    PressResponseOptions options;
    options.with_changes = false;
    const PressResponse alone = make_press_response(light_model(), stroke, options);
    EXPECT_EQ(press_forces(alone, light_model(), displacements),
              press_forces(response(), light_model(), displacements));
    EXPECT_EQ(alone.slip, 0.0);
    EXPECT_GT(response().slip, 0.05);
}

TEST(PressResponse, ReadsAsTheBenchDoes)
{
    PressModel model = light_model();
    model.options.reading = {0.1e-3, 0.6};
    // At 1.1 mm the head is 1 mm in: F (1 + 0.6 / 4).
    EXPECT_NEAR(press_forces(response(), model, {1.1e-3})[0],
                1.15 * press_forces(response(), light_model(), {1e-3})[0], 1e-9);
    EXPECT_NEAR(press_forces(response(), model, {0.05e-3})[0], 0.0, 1e-6);
}

TEST(PressResponse, RefusesWhatWasNotTabulated)
{
    PressModel model = light_model();
    model.options.radial_factor = 4.0;
    EXPECT_THROW(press_forces(response(), model, displacements), InputError);
    model = light_model();
    model.options.friction = -0.1;
    EXPECT_THROW(press_forces(response(), model, displacements), InputError);
}

namespace {

/// A curve of a model, measured with noise of half a per cent that alternates.
MeasuredCurve measured(const PressModel& model)
{
    PressOptions options = model.options;
    options.stroke = stroke;
    options.step = 0.2e-3;
    MeasuredCurve curve;
    double sign = 1.0;
    for (const PressState& state : press(press_network(model.device, options).network, options)) {
        if (state.displacement == 0.0) continue;
        curve.abscissae.push_back(state.displacement);
        curve.ordinates.push_back(state.force * (1.0 + 0.005 * sign));
        sign = -sign;
    }
    return curve;
}

CurveDiagnosis diagnosed(const MeasuredCurve& curve)
{
    return diagnose_curve(curve, force_noise(), force_curve_bench(response(), curve.abscissae));
}

std::vector<std::string> answers(const CurveDiagnosis& diagnosis)
{
    return test::answers(diagnosis.explanation);
}

}  // namespace

TEST(ForceDiagnosis, FindsNothingWhereNothingIsMissing)
{
    EXPECT_EQ(answers(diagnosed(measured(light_model()))),
              std::vector<std::string>{"nothing_missing"});
}

// Thicker wires: all forces by the fourth power, 1.07^4 = 1.31, from a press test of such wires.
TEST(ForceDiagnosis, FindsThickerWires)
{
    PressModel model = light_model();
    model.device.wire_diameter *= 1.07;
    const CurveDiagnosis diagnosis = diagnosed(measured(model));
    ASSERT_THAT(answers(diagnosis), testing::Contains("wire_diameter"));
    for (const EffectFit& fit : diagnosis.explanation.fits) {
        if (name_of(fit) != "wire_diameter") continue;
        EXPECT_NEAR(fit.effects.front().values.front(), 0.07, 0.01);
    }
}

// The device rubs: what friction of 0.4 does on average, and crossings that stick and slip, drawn
// from a normal distribution.
TEST(ForceDiagnosis, FindsFriction)
{
    PressModel model = light_model();
    model.options.friction = 0.4;
    MeasuredCurve curve;
    for (int i = 1; i <= 20; ++i)
        curve.abscissae.push_back(0.1e-3 * i);
    std::mt19937 random(2);
    std::normal_distribution<double> slips(0.0, 0.4 * response().slip);
    for (const double force : press_forces(response(), model, curve.abscissae))
        curve.ordinates.push_back(force * std::exp(slips(random)));
    const CurveDiagnosis diagnosis = diagnosed(curve);
    ASSERT_THAT(answers(diagnosis), testing::Contains("friction"));
    const FittedEffect& friction = diagnosis.explanation.fits[1].effects.front();
    EXPECT_NEAR(friction.values.front(), 0.4, 2.0 * friction.sd.front());
    // Twenty points tell the size of a scatter to 1 / sqrt(2 20) at best: of 0.4 with the factor of
    // its interval 0.16, in other noise less well, but better than the prior does.
    EXPECT_GT(friction.sd.front(), 0.4 * 2.5 / std::sqrt(40.0));
    EXPECT_LT(friction.sd.front(), 0.25);
    // What is left is as rough as friction makes it.
    EXPECT_LT(diagnosis.excess, 3.0);
}

// The head was set to zero 0.2 mm above the device.
TEST(ForceDiagnosis, FindsAnOffsetOfTheHeadsZero)
{
    MeasuredCurve curve = measured(light_model());
    for (double& displacement : curve.abscissae)
        displacement += 0.2e-3;
    const CurveDiagnosis diagnosis = diagnosed(curve);
    EXPECT_EQ(answers(diagnosis), std::vector<std::string>{"zero_offset"});
}

// A slip of the device, after which it bears a quarter less: no effect of the catalogue, and none
// is named without the unknown one beside it.
TEST(ForceDiagnosis, DoesNotNameASlip)
{
    MeasuredCurve curve = measured(light_model());
    for (std::size_t i = 5; i < curve.ordinates.size(); ++i)
        curve.ordinates[i] *= 0.75;
    const Verdict verdict = diagnosed(curve).explanation.verdict;
    EXPECT_TRUE(verdict.finding == Finding::unknown || verdict.unknown_lead ||
                verdict.has_unexplained_rest);
    EXPECT_NE(verdict.finding, Finding::nothing_missing);
}

}  // namespace braidzone
