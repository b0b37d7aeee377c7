#pragma once

#include "discrepancy/curve_problem.hpp"
#include "porous/pressure_bench.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <random>
#include <string>
#include <vector>

namespace braidzone::test {

/// A bench as its file states it, and a pressure drop that was measured on what it really is.
struct HiddenPressure {
    PressureBench stated;
    MeasuredCurve measured;
    /// The parameter of what is hidden, where the catalogue's effect has the same.
    std::optional<double> value = {};
};

/// Pressure drops made from the formulas of a tube's braid and of a row of cylinders, written out
/// here: none of the code of porous/.
class PressureMaker {
public:
    explicit PressureMaker(unsigned seed) : random_(seed) {}

    /// @param effect  a name of the catalogue, "none", "sine", "step" or "clipped"
    HiddenPressure make(const std::string& effect) { return make(effect, any_bench()); }

    /// The same on a bench with figures of its own.
    HiddenPressure make(const std::string& effect, const PressureBench& stated)
    {
        HiddenPressure hidden;
        hidden.stated = stated;
        Truth truth{hidden.stated.fluid.viscosity, 1.0, 0.0, uniform(0.92, 1.08), 1.0};
        if (effect == "viscosity") truth.viscosity *= 1.0 + sign() * uniform(0.08, 0.2);
        if (effect == "density") truth.density = std::exp(sign() * uniform(0.15, 0.45));
        if (effect == "leakage") truth.gap = uniform(0.15e-3, 0.45e-3);
        if (effect == "second_layer") truth.layers = uniform(2.0, 2.2);
        if (effect == "missing_inertia") hidden.stated.law = BraidStokesLaw{false};
        if (effect == "viscosity")
            hidden.value = truth.viscosity / hidden.stated.fluid.viscosity - 1.0;
        if (effect == "density") hidden.value = truth.density - 1.0;
        if (effect == "leakage") hidden.value = truth.gap;
        if (effect == "second_layer") hidden.value = truth.layers - 1.0;
        const double highest = uniform(0.3, 0.5);
        const int count = std::uniform_int_distribution<int>(12, 20)(random_);
        for (int i = 1; i <= count; ++i)
            hidden.measured.abscissae.push_back(highest * i / count);
        for (const double v : hidden.measured.abscissae)
            hidden.measured.ordinates.push_back(drop(hidden.stated, truth, v));
        add_outside(hidden.measured, effect);
        add_noise(hidden.measured);
        return hidden;
    }

private:
    struct Truth {
        double viscosity = 0.0, density = 1.0, gap = 0.0, inertia = 1.0, layers = 1.0;
    };

    double uniform(double from, double to)
    {
        return std::uniform_real_distribution<double>(from, to)(random_);
    }
    double normal(double sd) { return std::normal_distribution<double>(0.0, sd)(random_); }
    double sign() { return uniform(-1.0, 1.0) < 0.0 ? -1.0 : 1.0; }

    PressureBench any_bench()
    {
        PressureBench bench;
        bench.device.name = "braid";
        bench.device.num_wires = 48;
        bench.device.wire_diameter = uniform(28e-6, 34e-6);
        bench.device.nominal_diameter = uniform(3.5e-3, 5e-3);
        bench.device.nominal_length = 20e-3;
        bench.device.braid_ratio = uniform(0.36, 0.44);
        bench.diameter = bench.device.nominal_diameter * uniform(0.9, 1.0);
        bench.channel_diameter = uniform(3e-3, 6e-3);
        bench.fluid = {uniform(1030.0, 1120.0), uniform(2.5e-3, 4.5e-3)};
        return bench;
    }

    /// Two rows of cylinders that cross at an angle, by the formulas of a tube's braid: spacing
    /// p = 4 pi R / N cos(angle from the axis), wires that keep their length, and the series of
    /// Tamada and Fujikawa.
    static double drop(const PressureBench& bench, const Truth& truth, double v)
    {
        const FlowDiverter& device = bench.device;
        const double t = device.braid_ratio;
        const double ratio = bench.diameter / device.nominal_diameter;
        const double wire = std::sqrt(1.0 + t * t);  // half a crossing apart, over that around
        const double across = ratio;
        const double along = std::sqrt(wire * wire - across * across) / truth.density;
        const double angle = std::atan2(across, along);  // from the axis
        const double p =
            2.0 * std::numbers::pi * bench.diameter / device.num_wires * std::cos(angle);
        const double s = device.wire_diameter / p;
        const double tau2 = std::pow(0.5 * std::numbers::pi * s, 2);
        const double series = 1.0 - std::log(4.0 * tau2) + tau2 * (2.0 / 3.0 - tau2 / 9.0);
        const double chi = std::max(1.0, 1.02 + 1.07 * s - 1.28 * s * s);
        const double a =
            truth.layers * truth.viscosity * chi * 2.0 * 8.0 * std::numbers::pi / series / p;
        const double b =
            truth.layers * truth.inertia * 0.5 * bench.fluid.density * (0.285 + 1.78 * s);
        if (truth.gap == 0.0) return (a + b * v) * v;
        return leaking(bench, truth, a, b, v);
    }

    /// Newton's method on the drop, with a slit whose slow flow is that between plates that are as
    /// long as the braid is thick and 8 / (3 pi) h longer, and whose jet loses its speed.
    static double leaking(const PressureBench& bench, const Truth& truth, double a, double b,
                          double v)
    {
        const double share = 4.0 * truth.gap / bench.channel_diameter;
        const double length =
            2.0 * bench.device.wire_diameter + 8.0 / (3.0 * std::numbers::pi) * truth.gap;
        const double slit_a = 12.0 * truth.viscosity * length / (truth.gap * truth.gap);
        const double slit_b = 1.3 * bench.fluid.density;
        const auto speed = [](double linear, double quadratic, double dp) {
            return (std::sqrt(linear * linear + 4.0 * quadratic * dp) - linear) / (2.0 * quadratic);
        };
        double dp = 0.5 * (a + b * v) * v;
        for (int i = 0; i < 100; ++i) {
            const double vs = speed(a, b, dp), vg = speed(slit_a, slit_b, dp);
            const double slope =
                (1.0 - share) / (a + 2.0 * b * vs) + share / (slit_a + 2.0 * slit_b * vg);
            dp -= ((1.0 - share) * vs + share * vg - v) / slope;
        }
        return dp;
    }

    /// What no effect of the catalogue does: a ripple, a jump from some velocity on (a seal that
    /// gives way), a gauge that reaches its end.
    void add_outside(MeasuredCurve& curve, const std::string& effect)
    {
        const double range = curve.abscissae.back() - curve.abscissae.front();
        const double height = sign() * uniform(0.08, 0.25), phase = uniform(0.0, 6.28);
        const double periods = uniform(1.2, 3.0), place = uniform(0.3, 0.7);
        const double end = uniform(0.55, 0.8) * curve.ordinates.back();
        for (std::size_t i = 0; i < curve.ordinates.size(); ++i) {
            const double x = (curve.abscissae[i] - curve.abscissae.front()) / range;
            double& y = curve.ordinates[i];
            if (effect == "sine")
                y *= 1.0 + height * std::sin(2.0 * std::numbers::pi * periods * x + phase);
            if (effect == "step" && x > place) y *= 1.0 + height;
            if (effect == "clipped") y = std::min(y, end);
        }
    }

    void add_noise(MeasuredCurve& curve)
    {
        const double scale = 1.0 + normal(0.02), zero = normal(0.1);
        const double bow = normal(0.005);  // linearity of the gauge
        for (double& y : curve.ordinates) {
            const double x = y / curve.ordinates.back();
            y = y * scale * (1.0 + bow * 4.0 * x * (1.0 - x)) * (1.0 + normal(0.004)) + zero +
                normal(0.08);
        }
    }

    std::mt19937 random_;
};

}  // namespace braidzone::test
