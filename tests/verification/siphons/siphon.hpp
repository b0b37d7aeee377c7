#pragma once

#include "core/error.hpp"
#include "core/phantom.hpp"
#include "core/phantom_axis.hpp"
#include "core/phantom_shape.hpp"
#include "support/devices_of_any_size.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <random>
#include <utility>
#include <vector>

namespace braidzone::test {

/// What a device lies over: the mouth of a sac or the ostium of a branch.
struct Mouth {
    bool is_branch = false;
    double position = 0.0;     ///< arc length of its middle, on the wall [m]
    double direction = 0.0;    ///< about the axis, from the frame's normal [rad]
    double half_length = 0.0;  ///< along the axis [m]
};

/// A vessel like a carotid siphon, and a device in it.
struct Siphon {
    Phantom phantom;
    std::vector<Mouth> mouths;
    FlowDiverter device;
    double landing_distal = 0.0;  ///< [m]
    bool force_free = false;
    std::optional<std::pair<double, double>> push;  ///< from, to [m]
    double tightest_bend = 0.0;                     ///< radius of the bend over that of the vessel
};

/// Draws of one generator, the same on every machine (the distributions of the standard library
/// are not).
class Draw {
public:
    explicit Draw(unsigned seed) : generator_(seed) {}
    double between(double low, double high)
    {
        return low + (high - low) * (static_cast<double>(generator_()) / 4294967295.0);
    }
    bool chance(double share) { return between(0.0, 1.0) < share; }

private:
    std::mt19937 generator_;
};

/// Two bends between straight ends, the second one turning back within the plane or out of it, of
/// radii 1.05 to 3 times the vessel's (a phantom's bend is wider than the vessel); an oval,
/// tapering section; a sac in two of three; one to four branches of 0.2 to 0.8 of the artery's
/// radius.
inline Siphon draw_siphon(Draw& draw)
{
    constexpr double pi = std::numbers::pi;
    Siphon siphon;
    Phantom& phantom = siphon.phantom;
    phantom.edge_length = 0.45e-3;
    phantom.proximal_radius = draw.between(1.6e-3, 2.3e-3);
    phantom.distal_radius = phantom.proximal_radius * draw.between(0.85, 1.0);
    phantom.ovality = draw.chance(0.5) ? draw.between(0.8, 1.0) : 1.0;
    phantom.oval_direction = draw.between(0.0, pi);
    const double widest = phantom.proximal_radius / std::sqrt(phantom.ovality);
    const auto bend = [&](double plane_angle) {
        const double ratio = draw.between(1.05, 3.0);
        const double angle = draw.between(pi / 3.0, 0.75 * pi);
        siphon.tightest_bend =
            siphon.tightest_bend > 0.0 ? std::min(siphon.tightest_bend, ratio) : ratio;
        return PhantomSegment{ratio * widest * angle, angle, plane_angle};
    };
    const double turn = draw.chance(0.5) ? pi : draw.between(0.4, 1.6) * pi;
    const PhantomSegment first = bend(0.0);
    const PhantomSegment second = bend(turn);
    phantom.segments = {{.length = draw.between(9e-3, 13e-3)},
                        first,
                        {.length = draw.between(1e-3, 5e-3)},
                        second,
                        {.length = draw.between(9e-3, 13e-3)}};
    const PhantomAxis axis = make_axis(phantom.segments);

    const auto free_place = [&](double position, double direction, double half_length) {
        return std::none_of(siphon.mouths.begin(), siphon.mouths.end(), [&](const Mouth& other) {
            const double between = std::abs(position - other.position);
            const bool aside = std::cos(direction - other.direction) < -0.3;
            return between < half_length + other.half_length + (aside ? 0.5e-3 : 2e-3);
        });
    };
    const auto local_radius = [&](double position) {
        const double share = position / axis.length;
        return (1.0 - share) * phantom.proximal_radius + share * phantom.distal_radius;
    };
    // Outwards of a bend: a sac or branch on its inner side would meet the other limb.
    const auto outwards = [&](double position) {
        std::size_t i = 0;
        while (i + 1 < axis.pieces.size() && position > axis.pieces[i + 1].arc_length)
            ++i;
        const AxisPiece& piece = axis.pieces[i];
        if (piece.curvature == 0.0) return draw.between(0.0, 2.0 * pi);
        const double towards = std::atan2(piece.towards.dot(piece.start.binormal),
                                          piece.towards.dot(piece.start.normal));
        return towards + pi + draw.between(-0.5, 0.5);
    };
    if (draw.chance(0.67)) {
        const double neck = draw.between(2.5e-3, 4.5e-3);
        const double diameter = neck * draw.between(1.25, 1.8);
        const double position = draw.between(0.35, 0.65) * axis.length;
        const double direction = outwards(position);
        phantom.sacs.push_back({.position = position,
                                .direction = std::remainder(direction, 2.0 * pi),
                                .diameter = diameter,
                                .height = diameter,
                                .neck = neck});
        siphon.mouths.push_back({false, position, direction, 0.5 * neck});
    }
    const int wanted = 1 + static_cast<int>(draw.between(0.0, 3.999));
    for (int tries = 0, made = 0; tries < 40 && made < wanted; ++tries) {
        const double position = draw.between(7e-3, axis.length - 7e-3);
        const double direction = outwards(position);
        const double radius = draw.between(0.2, 0.8) * local_radius(position);
        const double tilt = draw.between(pi / 3.0, pi / 2.0);
        const double along = local_radius(position) / std::tan(tilt);
        const double half_length = radius / std::sin(tilt);
        if (!free_place(position + along, direction, half_length)) continue;
        phantom.branches.push_back({.position = position,
                                    .direction = std::remainder(direction, 2.0 * pi),
                                    .tilt = tilt,
                                    .radius = radius,
                                    .length = draw.between(3.0, 4.0) * widest});
        siphon.mouths.push_back({true, position + along, direction, half_length});
        ++made;
    }
    const double diameter = 2.0 * widest * draw.between(0.95, 1.2);
    siphon.force_free = draw.chance(0.5);
    // Released at force-free spacing a braid wider than the vessel lies up to 1.8 times as long.
    const double room = (axis.length - 6e-3) / (siphon.force_free ? 1.8 : 1.0);
    const double length = std::min(draw.between(12e-3, 20e-3), room);
    siphon.device = pipeline(diameter, length);
    const double slack = axis.length - length;
    siphon.landing_distal =
        axis.length - (siphon.force_free ? 3e-3 : draw.between(0.15, 0.5) * slack);
    if (draw.chance(0.25)) {
        siphon.push = {siphon.landing_distal - 0.6 * length, siphon.landing_distal - 0.3 * length};
    }
    return siphon;
}

/// The first siphon of a seed whose parts keep clear of each other's openings.
inline Siphon random_siphon(unsigned seed)
{
    Draw draw(seed);
    for (;;) {
        Siphon siphon = draw_siphon(draw);
        try {
            make_shape(siphon.phantom);
            return siphon;
        } catch (const ConfigError&) {
            continue;
        }
    }
}

}  // namespace braidzone::test
