#pragma once

#include "core/error.hpp"
#include "core/even_curve.hpp"
#include "deploy/press_test.hpp"
#include "discrepancy/curve_problem.hpp"
#include "discrepancy/press_response.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <random>
#include <string>
#include <vector>

namespace braidzone::test {

/// A Pipeline of 4 x 20 mm on the bench of cases/paper_2020, forces from its wires.
inline PressModel stated_press()
{
    PressModel model;
    model.device.name = "pipeline-flex";
    model.device.num_wires = 48;
    model.device.wire_diameter = 30e-6;
    model.device.nominal_diameter = 4e-3;
    model.device.nominal_length = 20e-3;
    model.device.braid_ratio = 0.40;
    model.device.forces = ForceSource::wire_theory;
    model.device.youngs_modulus = 200e9;
    model.options.stroke = 3.5e-3;
    return model;
}

/// Ways of the head between the forces of a press test that is measured [m].
constexpr double force_step = 0.125e-3;

/// A press test of which curves are made.
struct HiddenPressTest {
    double ratio = 1.0;  ///< of radial springs to arms, over the stated one
    double friction = 0.0;
    std::vector<double> forces = {};  ///< every `force_step`, as far as the device bears it [N]
};

/// A measured curve, and the parameter of what is hidden in it, where the catalogue's effect has
/// the same.
struct HiddenForce {
    MeasuredCurve measured;
    std::optional<double> value;
};

/// Force curves made by press tests of their own: a net of 16 crossings around and a bench whose
/// sizes are a little off. Nothing is taken from `PressResponse`. There are `num_tests` of them:
/// three as stated, twelve with other ratios of radial springs to arms, twelve with friction.
/// What else is hidden, and the measurement, differ from case to case.
class ForceMaker {
public:
    explicit ForceMaker(unsigned seed) : random_(seed) {}

    static constexpr int num_plain = 3, num_ratios = 12, num_frictions = 12;
    static constexpr int num_tests = num_plain + num_ratios + num_frictions;

    /// One of the press tests of a run.
    static HiddenPressTest pressed(int which, unsigned first_seed)
    {
        HiddenPressTest test;
        std::mt19937 own(first_seed + 1000003U * static_cast<unsigned>(which + 1));
        const double place = std::uniform_real_distribution<double>(0.0, 1.0)(own);
        if (which >= num_plain + num_ratios) {
            test.friction = 0.2 + 0.25 * place;
        } else if (which >= num_plain) {
            // One softer, by 0.6 to 0.78, the next stiffer, by 1.3 to 1.65.
            test.ratio = which % 2 == 0 ? 0.6 + 0.18 * place : 1.3 + 0.35 * place;
        }
        PressModel truth = stated_press();
        PressOptions& options = truth.options;
        options.radial_factor = test.ratio;
        options.friction = test.friction;
        options.nodes_per_ring = 16;
        options.load_step = options.step = force_step;
        options.stroke = 3.5e-3;
        options.max_iterations = 100;
        options.max_halvings = 2;
        std::normal_distribution<double> off(0.0, 0.03e-3);
        options.bench.notch_width += off(own);
        options.bench.head_radius += off(own);
        options.bench.edge_radius += 0.5 * off(own);
        try {
            press(press_network(truth.device, options).network, options,
                  [&](const PressState& state) { test.forces.push_back(state.force); });
        } catch (const ConvergenceError&) {
            return test;
        }
        return test;
    }

    /// A curve of 13 points up to 3.25 mm, or none where the device gives way before.
    /// @param tests  all press tests
    /// @param kind   a name of the catalogue, "none", "sine", "slip" or "hysteresis"
    HiddenForce make(const std::string& kind, const std::vector<HiddenPressTest>& tests)
    {
        HiddenForce hidden;
        const HiddenPressTest test = any_test(kind, tests);
        if (test.forces.empty()) return hidden;
        read(hidden, kind, test);
        add_outside(hidden.measured, kind);
        add_noise(hidden.measured);
        return hidden;
    }

private:
    double uniform(double from, double to)
    {
        return std::uniform_real_distribution<double>(from, to)(random_);
    }
    double normal(double sd) { return std::normal_distribution<double>(0.0, sd)(random_); }
    double sign() { return uniform(-1.0, 1.0) < 0.0 ? -1.0 : 1.0; }

    /// One of the press tests with what is hidden that reaches the stroke; none if all give way.
    HiddenPressTest any_test(const std::string& kind, const std::vector<HiddenPressTest>& tests)
    {
        int first = 0, count = num_plain;
        if (kind == "radial_coefficient" || kind == "surface_coefficient")
            first = num_plain, count = num_ratios;
        if (kind == "friction") first = num_plain + num_ratios, count = num_frictions;
        std::vector<HiddenPressTest> reach;
        for (int i = first; i < first + count; ++i) {
            const HiddenPressTest& test = tests[static_cast<std::size_t>(i)];
            if (static_cast<double>(test.forces.size()) * force_step >= 3.4e-3)
                reach.push_back(test);
        }
        if (reach.empty()) return {};
        return reach[static_cast<std::size_t>(whole(0, static_cast<int>(reach.size()) - 1))];
    }

    int whole(int from, int to) { return std::uniform_int_distribution<int>(from, to)(random_); }

    /// The bench's readings every 0.25 mm; a device that stiffens does so with the 1.3th power.
    void read(HiddenForce& hidden, const std::string& kind, const HiddenPressTest& test)
    {
        const double offset = kind == "zero_offset" ? sign() * uniform(0.06e-3, 0.25e-3) : 0.0;
        const double k =
            kind == "stiffening" ? (sign() > 0.0 ? uniform(0.2, 0.8) : -uniform(0.2, 0.5)) : 0.0;
        // Bending of a rod and torsion, both with the fourth power.
        const double thicker = kind == "wire_diameter" ? 1.0 + sign() * uniform(0.02, 0.08) : 1.0;
        // Softer arms with the springs as they are: the same ratio, and less force of all.
        const double common = kind == "surface_coefficient" ? 1.0 / test.ratio : 1.0;
        if (kind == "zero_offset") hidden.value = offset;
        if (kind == "wire_diameter") hidden.value = thicker - 1.0;
        if (kind == "surface_coefficient") hidden.value = common - 1.0;
        if (kind == "radial_coefficient") hidden.value = test.ratio - 1.0;
        if (kind == "friction") hidden.value = test.friction;
        for (int i = 1; i <= 13; ++i) {
            const double shown = 0.25e-3 * i, x = shown - offset;
            const double force = x > 0.0 ? common * std::pow(thicker, 4) *
                                               value_on_even_curve(test.forces, force_step, x)
                                         : 0.0;
            hidden.measured.abscissae.push_back(shown);
            hidden.measured.ordinates.push_back(force *
                                                (1.0 + k * std::pow(std::max(x, 0.0) / 4e-3, 1.3)));
        }
    }

    /// What no effect of the catalogue does: a ripple, a slip of the device after which it bears
    /// less, the mean of a stroke and its return.
    void add_outside(MeasuredCurve& curve, const std::string& kind)
    {
        const double height = uniform(0.1, 0.25), phase = uniform(0.0, 6.28);
        const double periods = uniform(1.2, 3.0), place = uniform(0.3, 0.7);
        const std::size_t count = curve.ordinates.size();
        for (std::size_t i = 0; i < count; ++i) {
            const double x = static_cast<double>(i) / static_cast<double>(count - 1);
            double& y = curve.ordinates[i];
            if (kind == "sine")
                y *= 1.0 + height * std::sin(2.0 * std::numbers::pi * periods * x + phase);
            if (kind == "slip" && x > place) y *= 1.0 - height;
            if (kind == "hysteresis") y *= 1.0 - 1.5 * height * std::exp(-8.0 * (1.0 - x));
        }
    }

    /// Three repeats, a calibration that is 1 % off, and imperfections of the device.
    void add_noise(MeasuredCurve& curve)
    {
        const double sd = uniform(0.1e-3, 0.3e-3), scale = 1.0 + normal(0.01);
        curve.standard_error = sd / std::sqrt(3.0);
        double background = normal(0.015);
        const double kept = std::exp(-0.25 / 0.5);
        for (double& y : curve.ordinates) {
            background = kept * background + std::sqrt(1.0 - kept * kept) * normal(0.015);
            y = y * scale * (1.0 + background) + normal(curve.standard_error);
        }
    }

    std::mt19937 random_;
};

}  // namespace braidzone::test
