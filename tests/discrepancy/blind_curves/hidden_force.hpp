#pragma once

#include "core/error.hpp"
#include "core/even_curve.hpp"
#include "deploy/press_test.hpp"
#include "discrepancy/curve_problem.hpp"
#include "discrepancy/press_response.hpp"

#include <algorithm>
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

/// Force curves made by press tests of their own: a net of 14 crossings around, other load steps
/// and tolerance, a bench whose sizes are a little off. Each case in which the mechanics differ has
/// its own, the others share those of eight benches. Nothing is taken from `PressResponse`.
class ForceMaker {
public:
    explicit ForceMaker(unsigned seed) : random_(seed) {}

    struct Plan {
        std::string kind;
        PressModel truth;
        MeasuredCurve measured = {};
        unsigned seed = 0;
        int bench = -1;  ///< which of the shared ones
        bool failed = false;
    };

    /// @param kind  a name of the catalogue, "none", "sine", "step" or "hysteresis"
    Plan plan(const std::string& kind)
    {
        Plan plan{kind, stated_press()};
        if (kind != "surface_coefficient" && kind != "radial_coefficient" && kind != "friction")
            plan.bench = std::uniform_int_distribution<int>(0, num_benches - 1)(random_);
        std::mt19937 own = plan.bench >= 0 ? std::mt19937(static_cast<unsigned>(plan.bench))
                                           : std::mt19937(random_());
        PressOptions& options = plan.truth.options;
        options.nodes_per_ring = 14;
        options.load_step = 0.1e-3;
        options.step = 0.1e-3;
        options.stroke = 3.5e-3;
        options.residual_tolerance = 5e-4;
        std::normal_distribution<double> off(0.0, 0.03e-3);
        options.bench.notch_width += off(own);
        options.bench.head_radius += off(own);
        options.bench.edge_radius += 0.5 * off(own);
        if (kind == "surface_coefficient")
            options.surface_factor = std::exp(sign() * uniform(0.15, 0.5));
        if (kind == "radial_coefficient")
            options.radial_factor = std::exp(sign() * uniform(0.15, 0.5));
        if (kind == "friction") options.friction = uniform(0.15, 0.5);
        plan.seed = random_();
        return plan;
    }

    static constexpr int num_benches = 8;

    /// Forces every 0.1 mm, as far as the device does not give way [N].
    static std::vector<double> pressed(const PressModel& truth)
    {
        std::vector<double> forces;
        try {
            press(press_network(truth.device, truth.options).network, truth.options,
                  [&](const PressState& state) { forces.push_back(state.force); });
        } catch (const ConvergenceError&) {
            return forces;
        }
        return forces;
    }

    /// Measures the forces of its press test.
    static void measure(Plan& plan, const std::vector<double>& forces)
    {
        constexpr double last = 3.45e-3;
        plan.failed = static_cast<double>(forces.size() - 1) * plan.truth.options.step < last;
        if (plan.failed) return;
        ForceMaker maker(plan.seed);
        maker.read(plan, forces);
        maker.add_outside(plan);
        maker.add_noise(plan.measured);
    }

private:
    double uniform(double from, double to)
    {
        return std::uniform_real_distribution<double>(from, to)(random_);
    }
    double normal(double sd) { return std::normal_distribution<double>(0.0, sd)(random_); }
    double sign() { return uniform(-1.0, 1.0) < 0.0 ? -1.0 : 1.0; }

    /// The bench's readings every 0.25 mm; a device that stiffens does so with the 1.3th power.
    void read(Plan& plan, const std::vector<double>& forces)
    {
        const double offset = plan.kind == "zero_offset" ? sign() * uniform(0.06e-3, 0.25e-3) : 0.0;
        const double k = plan.kind == "stiffening"
                             ? (sign() > 0.0 ? uniform(0.2, 0.8) : -uniform(0.2, 0.5))
                             : 0.0;
        // Bending of a rod and torsion, both with the fourth power.
        const double thicker =
            plan.kind == "wire_diameter" ? 1.0 + sign() * uniform(0.02, 0.08) : 1.0;
        for (int i = 1; i <= 13; ++i) {
            const double shown = 0.25e-3 * i, x = shown - offset;
            const double force =
                x > 0.0 ? std::pow(thicker, 4) * value_on_even_curve(forces, 0.1e-3, x) : 0.0;
            plan.measured.abscissae.push_back(shown);
            plan.measured.ordinates.push_back(force *
                                              (1.0 + k * std::pow(std::max(x, 0.0) / 4e-3, 1.3)));
        }
    }

    /// What no effect of the catalogue does: a ripple, a slip of the device after which it bears
    /// less, the mean of a stroke and its return.
    void add_outside(Plan& plan)
    {
        const double height = uniform(0.1, 0.25), phase = uniform(0.0, 6.28);
        const double periods = uniform(1.2, 3.0), place = uniform(0.3, 0.7);
        const std::size_t count = plan.measured.ordinates.size();
        for (std::size_t i = 0; i < count; ++i) {
            const double x = static_cast<double>(i) / static_cast<double>(count - 1);
            double& y = plan.measured.ordinates[i];
            if (plan.kind == "sine")
                y *= 1.0 + height * std::sin(2.0 * std::numbers::pi * periods * x + phase);
            if (plan.kind == "slip" && x > place) y *= 1.0 - height;
            if (plan.kind == "hysteresis") y *= 1.0 - 1.5 * height * std::exp(-8.0 * (1.0 - x));
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
