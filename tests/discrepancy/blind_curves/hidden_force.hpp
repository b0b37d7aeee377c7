#pragma once

#include "core/error.hpp"
#include "core/even_curve.hpp"
#include "deploy/press_test.hpp"
#include "discrepancy/curve_problem.hpp"
#include "discrepancy/press_response.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
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

/// Force curves made by press tests of their own: a net of 16 crossings around and a bench whose
/// sizes are a little off. Nothing is taken from `PressResponse`. There are `num_tests` of them:
/// three as stated, four with other ratios of radial springs to arms, one with a friction of 0.4.
/// What else is hidden, and the measurement, differ from case to case.
class ForceMaker {
public:
    explicit ForceMaker(unsigned seed) : random_(seed) {}

    static constexpr int num_plain = 3, num_ratios = 4, num_frictions = 1;
    static constexpr int num_tests = num_plain + num_ratios + num_frictions;

    /// Forces of one of the press tests, as far as the device does not give way [N].
    static std::vector<double> pressed(int which)
    {
        PressModel truth = stated_press();
        PressOptions& options = truth.options;
        options.nodes_per_ring = 16;
        options.load_step = options.step = force_step;
        options.stroke = 3.5e-3;
        options.max_iterations = 100;
        options.max_halvings = 2;
        std::mt19937 own(static_cast<unsigned>(which));
        std::normal_distribution<double> off(0.0, 0.03e-3);
        options.bench.notch_width += off(own);
        options.bench.head_radius += off(own);
        options.bench.edge_radius += 0.5 * off(own);
        if (which >= num_plain && which < num_plain + num_ratios)
            options.radial_factor = ratio_of(which);
        if (which >= num_plain + num_ratios) options.friction = 0.4;
        std::vector<double> forces;
        try {
            press(press_network(truth.device, options).network, options,
                  [&](const PressState& state) { forces.push_back(state.force); });
        } catch (const ConvergenceError&) {
            return forces;
        }
        return forces;
    }

    /// A curve of 13 points up to 3.25 mm, or none where the device gives way before.
    /// @param tests  forces of all press tests
    /// @param kind   a name of the catalogue, "none", "sine", "slip" or "hysteresis"
    MeasuredCurve make(const std::string& kind, const std::vector<std::vector<double>>& tests)
    {
        int which = whole(0, num_plain - 1);
        if (kind == "radial_coefficient" || kind == "surface_coefficient")
            which = num_plain + whole(0, num_ratios - 1);
        if (kind == "friction") which = num_plain + num_ratios + whole(0, num_frictions - 1);
        const std::vector<double>& forces = tests[static_cast<std::size_t>(which)];
        MeasuredCurve curve;
        if (static_cast<double>(forces.size()) * force_step < 3.4e-3) return curve;
        // Softer arms with the springs as they are: the same ratio, and less force of all.
        const double common = kind == "surface_coefficient" ? 1.0 / ratio_of(which) : 1.0;
        read(curve, kind, forces, common);
        add_outside(curve, kind);
        add_noise(curve);
        return curve;
    }

private:
    double uniform(double from, double to)
    {
        return std::uniform_real_distribution<double>(from, to)(random_);
    }
    double normal(double sd) { return std::normal_distribution<double>(0.0, sd)(random_); }
    double sign() { return uniform(-1.0, 1.0) < 0.0 ? -1.0 : 1.0; }

    int whole(int from, int to) { return std::uniform_int_distribution<int>(from, to)(random_); }

    static double ratio_of(int which)
    {
        constexpr std::array<double, num_ratios> ratios = {0.62, 0.75, 1.35, 1.6};
        return ratios[static_cast<std::size_t>(which - num_plain)];
    }

    /// The bench's readings every 0.25 mm; a device that stiffens does so with the 1.3th power.
    void read(MeasuredCurve& curve, const std::string& kind, const std::vector<double>& forces,
              double common)
    {
        const double offset = kind == "zero_offset" ? sign() * uniform(0.06e-3, 0.25e-3) : 0.0;
        const double k =
            kind == "stiffening" ? (sign() > 0.0 ? uniform(0.2, 0.8) : -uniform(0.2, 0.5)) : 0.0;
        // Bending of a rod and torsion, both with the fourth power.
        const double thicker = kind == "wire_diameter" ? 1.0 + sign() * uniform(0.02, 0.08) : 1.0;
        for (int i = 1; i <= 13; ++i) {
            const double shown = 0.25e-3 * i, x = shown - offset;
            const double force =
                x > 0.0 ? common * std::pow(thicker, 4) * value_on_even_curve(forces, force_step, x)
                        : 0.0;
            curve.abscissae.push_back(shown);
            curve.ordinates.push_back(force * (1.0 + k * std::pow(std::max(x, 0.0) / 4e-3, 1.3)));
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
