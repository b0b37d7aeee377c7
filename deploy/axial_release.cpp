#include "deploy/axial_release.hpp"

#include "core/error.hpp"
#include "deploy/network_relaxation.hpp"
#include "deploy/wall_obstacle.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace braidzone {

namespace {

std::size_t index(int i)
{
    return static_cast<std::size_t>(i);
}

/// Rings that are laid out in the catheter: their bending holds the direction of those that leave.
constexpr int rings_in_catheter = 6;

/// Rings that move at first after a release: those of the cone between catheter and wall.
constexpr int smallest_window = 20;

/// Stiffness of the catheter's wall and of the delivery wire over that of the radial springs.
constexpr double guide_ratio = 1e3;

/// The cross-section at an arc length; before the centerline's start it goes on straight.
CrossSection section_on(const Centerline& centerline, double arc_length)
{
    CrossSection section = section_at(centerline, std::clamp(arc_length, 0.0, centerline.length()));
    section.origin += std::min(arc_length, 0.0) * section.tangent;
    return section;
}

void require_room_upstream(const Centerline& centerline, const WallTree& wall,
                           const AxialLanding& landing)
{
    for (double s = 0.0; s <= landing.distal; s += centerline.spacing) {
        const Vec3 axis = section_at(centerline, s).origin;
        const double room = wall.contains(axis) ? wall.nearest(axis).distance : 0.0;
        // At an opening the axis may lie in the plane of the rim.
        if (room > landing.catheter_radius || s < landing.catheter_radius) continue;
        throw GeometryError(fmt::format(
            "at {:.6g} mm along the centerline the wall is {:.6g} mm away; the catheter of "
            "{:.6g} mm diameter does not pass",
            1e3 * s, 1e3 * room, 2e3 * landing.catheter_radius));
    }
}

class Catheter {
public:
    Catheter(const WireNetwork& network, const Centerline& centerline, const WallTree& wall,
             const AxialLanding& landing, const NetworkRelease& release)
        : lattice_(network.lattice),
          centerline_(centerline),
          radius_(landing.catheter_radius),
          arc_length_(index(lattice_.num_rings), landing.distal),
          relaxation_(network, {std::vector<Vec3>(index(lattice_.num_nodes()), Vec3::Zero()), 0},
                      {.offset = release.contact_offset,
                       .normal_stiffness = release.contact_stiffness,
                       .tangential_stiffness = release.contact_stiffness,
                       .friction = release.friction},
                      {wall_obstacle(wall)},
                      {.guide_radius = landing.catheter_radius,
                       .guide_stiffness = guide_ratio * radial_stiffness(network.radial),
                       .proximal_stiffness = proximal_ratio * radial_stiffness(network.radial),
                       .largest_step = largest_step_ratio * lattice_.nominal_radius})
    {
        lay_out_first_ring();
        while (num_rings() < std::min(rings_in_catheter, lattice_.num_rings))
            lay_out_next_ring();
        hold_distal_end(true);
    }

    void release_ring()
    {
        if (num_rings() < lattice_.num_rings) lay_out_next_ring();
        relaxation_.guides()[index(num_released_++)].crimped = false;
    }
    bool is_empty() const { return num_released_ == lattice_.num_rings; }
    int num_released() const { return num_released_; }
    int num_rings() const { return relaxation_.shape().num_rings; }

    void hold_distal_end(bool held) { relaxation_.guides()[0].held = held; }

    /// Brings the rings that are out, and those laid out behind them, to rest.
    double relax(int& window, double tolerance, int most_iterations)
    {
        return relaxation_.relax({0, num_rings()}, window, tolerance, most_iterations,
                                 [this](RingRange moved) { follow(moved); });
    }

    NetworkRelaxation& relaxation() { return relaxation_; }
    const std::vector<double>& arc_length() const { return arc_length_; }

private:
    Vec3& node(int ring, int column)
    {
        return relaxation_.shape().nodes[index(lattice_.node(ring, column))];
    }

    void set_section(int ring, const CrossSection& section)
    {
        relaxation_.guides()[index(ring)].section = section;
    }

    void lay_out_first_ring()
    {
        const CrossSection section = section_on(centerline_, arc_length_[0]);
        for (int column = 0; column < lattice_.nodes_per_ring; ++column) {
            const double angle = lattice_.angle(0, column);
            node(0, column) = section.origin + radius_ * (std::cos(angle) * section.normal +
                                                          std::sin(angle) * section.binormal);
        }
        relaxation_.shape().num_rings = 1;
        relaxation_.guides()[0].crimped = true;
        set_section(0, section);
    }

    /// Each node stands behind the two that its arms lead to, at the arms' length from both.
    void lay_out_next_ring()
    {
        const int ring = relaxation_.shape().num_rings++;
        const CrossSection& before = relaxation_.guides()[index(ring - 1)].section;
        double mean_spacing = 0.0;
        for (int column = 0; column < lattice_.nodes_per_ring; ++column) {
            const Vec3& first = node(ring - 1, column);
            const Vec3& second = node(ring - 1, column + 1);
            const Vec3 middle = 0.5 * (first + second);
            const double along = before.tangent.dot(middle - before.origin);
            const Vec3 axis = before.origin + along * before.tangent;
            const Vec3 foot = axis + radius_ * (middle - axis).normalized();
            const double square = lattice_.arm_length * lattice_.arm_length -
                                  0.25 * (second - first).squaredNorm() -
                                  (foot - middle).squaredNorm();
            const double spacing = std::sqrt(std::max(0.0, square));
            node(ring, column) = foot - spacing * before.tangent;
            mean_spacing += spacing / lattice_.nodes_per_ring;
        }
        arc_length_[index(ring)] = arc_length_[index(ring - 1)] - mean_spacing;
        relaxation_.guides()[index(ring)].crimped = true;
        set_section(ring, section_on(centerline_, arc_length_[index(ring)]));
    }

    /// The cross-sections follow their rings along the centerline.
    void follow(RingRange moved)
    {
        for (int ring = moved.first; ring < moved.end; ++ring) {
            Vec3 mean = Vec3::Zero();
            for (int column = 0; column < lattice_.nodes_per_ring; ++column)
                mean += node(ring, column) / lattice_.nodes_per_ring;
            double& s = arc_length_[index(ring)];
            const CrossSection here = section_on(centerline_, s);
            s = std::min(s + here.tangent.dot(mean - here.origin), centerline_.length());
            if (!relaxation_.guides()[index(ring)].held)
                set_section(ring, section_on(centerline_, s));
        }
    }

    const BraidLattice& lattice_;
    const Centerline& centerline_;
    double radius_;
    std::vector<double> arc_length_;
    NetworkRelaxation relaxation_;
    int num_released_ = 0;
};

}  // namespace

ReleasedNetwork release_along_axis(const WireNetwork& network, const Centerline& centerline,
                                   const WallTree& wall, const AxialLanding& landing,
                                   const NetworkRelease& release)
{
    require_room_upstream(centerline, wall, landing);
    Catheter catheter(network, centerline, wall, landing, release);
    NetworkRelaxation& relaxation = catheter.relaxation();
    const auto report = [&](double residual) {
        if (release.report)
            release.report(relaxation.num_iterations(), catheter.num_released(), relaxation.shape(),
                           residual);
    };

    int window = smallest_window;
    const double loose_tolerance = loose_tolerance_ratio * release.force_tolerance;
    while (!catheter.is_empty()) {
        catheter.release_ring();
        window = std::max(smallest_window, 3 * window / 4);
        report(catheter.relax(window, loose_tolerance, most_iterations_per_ring));
        relaxation.settle_contacts({0, catheter.num_rings()});
    }

    ReleasedNetwork result;
    if (release.friction > 0.0) catheter.hold_distal_end(false);
    relaxation.options().proximal_stiffness =
        final_proximal_ratio * radial_stiffness(network.radial);
    window = catheter.num_rings();
    result.residual = catheter.relax(window, release.force_tolerance, release.most_iterations);
    report(result.residual);

    const int num_rings = network.lattice.num_rings;
    if (!(catheter.arc_length().back() >= 0.0)) {
        throw GeometryError(fmt::format(
            "the device reaches {:.6g} mm beyond the proximal end of the centerline: in this "
            "vessel "
            "it lies {:.6g} mm long; move deployment.landing_distal, or take a shorter device",
            -1e3 * catheter.arc_length().back(),
            1e3 * (catheter.arc_length().front() - catheter.arc_length().back())));
    }
    result.nodes = relaxation.shape().nodes;
    result.ring_arc_length = catheter.arc_length();
    for (int ring = 0; ring < num_rings; ++ring)
        result.rings.push_back(section_on(centerline, result.ring_arc_length[index(ring)]));
    for (int node = 0; node < network.lattice.num_nodes(); ++node)
        result.contact_force.push_back(relaxation.normal_force(node));
    result.iterations = relaxation.num_iterations();
    result.arm_strain = largest_arm_strain(network, relaxation.shape());
    return result;
}

}  // namespace braidzone
