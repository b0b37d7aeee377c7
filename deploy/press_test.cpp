#include "deploy/press_test.hpp"

#include "core/error.hpp"
#include "deploy/network_relaxation.hpp"
#include "deploy/spring_forces.hpp"
#include "deploy/wire_theory.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

namespace braidzone {

namespace {

std::size_t index(int i)
{
    return static_cast<std::size_t>(i);
}

/// Stiffness of an arm beyond which it is as good as inextensible [N/m]: a bench's loads stretch it
/// by less than 1e-4 of its length.
constexpr double stiffest_arm = 2e4;

/// Stiffness of the bench at a node over that of the node's radial spring: wires sink in by less
/// than 1e-3 of what they give way themselves.
constexpr double bench_stiffness_ratio = 2e4;

/// Gap at which the bench begins to press, over the device's nominal radius: 1 um at 4 mm.
constexpr double contact_offset_ratio = 5e-4;

/// Stiffness that holds nodes to where they were, over that of a radial spring: a device that lies
/// free could else be moved at no cost.
constexpr double proximal_ratio = 1e-3;

/// How often, and by how much, that is raised where the device does not come to rest otherwise.
constexpr int stiffer_holds = 2;
constexpr double stiffer_hold_factor = 30.0;

/// Distance over the nominal radius at which nodes learn of the bench: more than the longest step.
constexpr double reach_ratio = 0.06;

/// Rows of nodes come to touch, and to part, together: finding which takes many attempts.
constexpr int contact_attempts = 25;

/// Longest step of a node over the nominal radius.
constexpr double largest_step_ratio = 0.05;

void require_positive(const char* name, double value)
{
    if (value > 0.0 && std::isfinite(value)) return;
    throw InputError(
        fmt::format("press test: {} = {:.6g} mm is not positive and finite", name, 1e3 * value));
}

void check(const WireNetwork& network, const PressOptions& options)
{
    const PressBench& bench = options.bench;
    require_positive("stroke", options.stroke);
    require_positive("step", options.step);
    require_positive("load_step", options.load_step);
    require_positive("notch_width", bench.notch_width);
    if (bench.head == PressHead::cylinder) require_positive("head_radius", bench.head_radius);
    if (!(bench.notch_angle > 0.0 && bench.notch_angle < std::numbers::pi)) {
        throw InputError(fmt::format(
            "press test: notch_angle = {:.6g} deg is out of range; allowed is more than 0, less "
            "than 180 deg",
            bench.notch_angle * 180.0 / std::numbers::pi));
    }
    // The rounding of both edges together must leave some of the faces.
    const double largest_radius = notch_depth(bench) / std::cos(0.5 * bench.notch_angle);
    if (!(bench.edge_radius >= 0.0 && bench.edge_radius < largest_radius)) {
        throw InputError(fmt::format(
            "press test: edge_radius = {:.6g} mm is out of range; a notch of that width and angle "
            "allows 0 to {:.6g} mm",
            1e3 * bench.edge_radius, 1e3 * largest_radius));
    }
    const double length = (network.lattice.num_rings - 1) * network.lattice.ring_spacing;
    if (!(length > bench.notch_width + 2.0 * bench.edge_radius)) {
        throw InputError(fmt::format(
            "press test: the device of {:.6g} mm does not reach across the notch of {:.6g} mm with "
            "its rounded edges",
            1e3 * length, 1e3 * bench.notch_width));
    }
}

/// The force-free device along x across the notch, its lowest line at a height [m].
NetworkShape resting_shape(const BraidLattice& lattice, double height)
{
    NetworkShape shape;
    shape.num_rings = lattice.num_rings;
    // A node of the middle ring looks straight up, where the head comes down.
    const int middle = lattice.num_rings / 2;
    const double turn = -lattice.angle(middle, 0);
    const double axis = height + lattice.nominal_radius;
    for (int ring = 0; ring < lattice.num_rings; ++ring) {
        for (int column = 0; column < lattice.nodes_per_ring; ++column) {
            const double angle = lattice.angle(ring, column) + turn;
            shape.nodes.emplace_back((ring - 0.5 * (lattice.num_rings - 1)) * lattice.ring_spacing,
                                     lattice.nominal_radius * std::sin(angle),
                                     axis + lattice.nominal_radius * std::cos(angle));
        }
    }
    return shape;
}

class Press {
public:
    Press(const WireNetwork& network, const PressOptions& options)
        : network_(network),
          options_(options),
          radial_stiffness_(radial_stiffness(network.radial)),
          law_{contact_offset_ratio * network.lattice.nominal_radius,
               bench_stiffness_ratio * radial_stiffness_, bench_stiffness_ratio * radial_stiffness_,
               options.friction},
          relaxation_(network, resting_shape(network.lattice, law_.offset), law_, obstacles(),
                      {0.0, radial_stiffness_, proximal_ratio * radial_stiffness_,
                       largest_step_ratio * network.lattice.nominal_radius, true, contact_attempts})
    {
        middle_ = network.lattice.num_rings / 2;
        RingGuide& guide = relaxation_.guides()[index(middle_)];
        guide.held = true;
        guide.section.origin = hub(middle_);
        guide.section.tangent = Vec3::UnitX();
        first_hub_height_ = guide.section.origin.z();
    }

    /// Moves the head and brings the device to rest, in load steps as small as it takes.
    void advance_to(double displacement)
    {
        double load_step = options_.load_step;
        const double smallest = options_.load_step * std::pow(0.5, options_.max_halvings);
        while (displacement_ < displacement) {
            const double remaining = displacement - displacement_;
            // Even steps, without a last one of a rounding error.
            const double way = remaining / std::ceil(remaining / load_step - 1e-9);
            const std::vector<Vec3> nodes = relaxation_.shape().nodes;
            const double before = displacement_;
            displacement_ = way == remaining ? displacement : displacement_ + way;
            if (come_to_rest_somehow()) continue;
            if (0.5 * load_step < smallest) throw_not_at_rest();
            displacement_ = before;
            relaxation_.shape().nodes = nodes;
            load_step *= 0.5;
        }
        check_sides_apart();
    }

    PressState state()
    {
        PressState state;
        const NetworkShape& shape = relaxation_.shape();
        state.displacement = displacement_;
        state.nodes = shape.nodes;
        state.force = head_force();
        state.notch_force = notch_force();
        state.deflection = first_hub_height_ - hub(middle_).z();
        state.height = height_of(middle_);
        state.energy = network_energy(network_, shape, {0, shape.num_rings});
        state.residual = residual_;
        state.iterations = std::exchange(iterations_, 0);
        return state;
    }

private:
    std::vector<Obstacle> obstacles()
    {
        const double reach = reach_ratio * network_.lattice.nominal_radius;
        Obstacle head = solid_obstacle(
            [this](const Vec3& point) {
                return distance_to_head(options_.bench, head_height(displacement_), point);
            },
            reach);
        // The distance to where the head will be in the end: less than to any place on its way.
        head.clearance = [this, reach](const Vec3& point) {
            return distance_to_head(options_.bench, head_height(options_.stroke), point).distance -
                   reach;
        };
        std::vector<Obstacle> result{head};
        for (int side : {-1, 1}) {
            result.push_back(solid_obstacle(
                [this, side](const Vec3& point) {
                    return distance_to_block(options_.bench, side, point);
                },
                reach));
        }
        return result;
    }

    double head_height(double displacement) const
    {
        return 2.0 * network_.lattice.nominal_radius + 2.0 * law_.offset - displacement;
    }

    Vec3 hub(int ring) const
    {
        const BraidLattice& lattice = network_.lattice;
        Vec3 sum = Vec3::Zero();
        for (int column = 0; column < lattice.nodes_per_ring; ++column)
            sum += relaxation_.shape().nodes[index(lattice.node(ring, column))];
        return sum / lattice.nodes_per_ring;
    }

    double height_of(int ring) const
    {
        const BraidLattice& lattice = network_.lattice;
        double lowest = std::numeric_limits<double>::infinity(), highest = -lowest;
        for (int column = 0; column < lattice.nodes_per_ring; ++column) {
            const double z = relaxation_.shape().nodes[index(lattice.node(ring, column))].z();
            lowest = std::min(lowest, z);
            highest = std::max(highest, z);
        }
        return highest - lowest;
    }

    /// The axis of a ring leads from the hub of the ring before to that of the ring after it.
    Vec3 axis(int ring) const
    {
        const int last = network_.lattice.num_rings - 1;
        return (hub(std::min(ring + 1, last)) - hub(std::max(ring - 1, 0))).normalized();
    }

    /// Where nodes come and go on the bench by turns, a stiffer hold to where they were calms them.
    bool come_to_rest_somehow()
    {
        double& hold = relaxation_.options().proximal_stiffness;
        const double softest = hold;
        bool at_rest = come_to_rest();
        for (int i = 0; i < stiffer_holds && !at_rest; ++i) {
            hold *= stiffer_hold_factor;
            at_rest = come_to_rest();
        }
        hold = softest;
        return at_rest;
    }

    /// @return false if the device does not come to rest
    bool come_to_rest()
    {
        const RingRange all{0, network_.lattice.num_rings};
        const double softest = 1e-3 * radial_stiffness_ * network_.lattice.nominal_radius;
        for (int i = 0; i < options_.max_iterations; ++i) {
            const std::vector<Vec3> nodes = relaxation_.shape().nodes;
            const double force = head_force();
            residual_ = relaxation_.iterate(all);
            ++iterations_;
            if (residual_ < options_.residual_tolerance * std::max(softest, force)) {
                // At rest was the shape before the step; after it a node may be deep in the head.
                relaxation_.shape().nodes = nodes;
                relaxation_.settle_contacts(all);
                return true;
            }
        }
        return false;
    }

    double pressing(const SolidDistance& solid) const
    {
        return law_.normal_stiffness * std::max(0.0, law_.offset - solid.distance);
    }
    double head_force() const
    {
        double force = 0.0;
        for (const Vec3& node : relaxation_.shape().nodes) {
            const SolidDistance solid =
                distance_to_head(options_.bench, head_height(displacement_), node);
            force -= pressing(solid) * solid.normal.z();
        }
        return force;
    }
    double notch_force() const
    {
        double force = 0.0;
        for (const Vec3& node : relaxation_.shape().nodes) {
            for (int side : {-1, 1}) {
                const SolidDistance solid = distance_to_block(options_.bench, side, node);
                force += pressing(solid) * solid.normal.z();
            }
        }
        return force;
    }

    [[noreturn]] void throw_not_at_rest() const
    {
        throw ConvergenceError(fmt::format(
            "press test: no state of rest at a displacement of {:.6g} mm, after {} iterations with "
            "a force of {:.6g} N and {:.6g} N left on a node; the device gives way there, or the "
            "load step of {:.6g} mm is too long",
            1e3 * displacement_, options_.max_iterations, head_force(), residual_,
            1e3 * options_.load_step));
    }

    /// Nodes that were above those on the opposite side of their ring are above them still.
    void check_sides_apart() const
    {
        const BraidLattice& lattice = network_.lattice;
        const int half = lattice.nodes_per_ring / 2;
        const NetworkShape rest = resting_shape(lattice, 0.0);
        for (int ring = 0; ring < lattice.num_rings; ++ring) {
            const Vec3 up = axis(ring).cross(Vec3::UnitY());
            for (int column = 0; column < half; ++column) {
                const std::size_t one = index(lattice.node(ring, column));
                const std::size_t other = index(lattice.node(ring, column + half));
                const double was = (rest.nodes[one] - rest.nodes[other]).z();
                // Nodes on the flanks may pass each other: they are a diameter apart along y.
                if (std::abs(was) < lattice.nominal_radius) continue;
                const Vec3 now = relaxation_.shape().nodes[one] - relaxation_.shape().nodes[other];
                if (up.dot(now) * was > 0.0) continue;
                throw ConvergenceError(fmt::format(
                    "press test: at a displacement of {:.6g} mm the upper and the lower side of "
                    "the device meet at ring {}; contact between them is not computed: allowed "
                    "are shorter strokes",
                    1e3 * displacement_, ring));
            }
        }
    }

    const WireNetwork& network_;
    PressOptions options_;
    double radial_stiffness_;
    ContactLaw law_;
    NetworkRelaxation relaxation_;
    int middle_ = 0;
    double first_hub_height_ = 0.0;
    double displacement_ = 0.0;
    double residual_ = 0.0;
    int iterations_ = 0;
};

/// Applies the factors on the stiffness of arms and radial springs.
void stiffen(WireNetwork& network, const PressOptions& options)
{
    network.axial_stiffness *= options.surface_factor;
    network.bending_stiffness *= options.surface_factor;
    network.radial = scaled(network.radial, options.radial_factor);
}

}  // namespace

PressNetwork press_network(const FlowDiverter& device, const PressOptions& options)
{
    validate(device);
    FlowDiverter net = device;
    if (options.nodes_per_ring > 0) net.num_wires = 2 * options.nodes_per_ring;
    const double coarsening = static_cast<double>(device.num_wires) / net.num_wires;

    PressNetwork result;
    WireNetwork& network = result.network;
    network.lattice = make_lattice(net);
    if (device.forces == ForceSource::wire_theory) {
        network.axial_stiffness = std::min(stiffest_arm, wire_axial_stiffness(device));
        network.bending_stiffness = crossing_bending_stiffness(device) / (coarsening * coarsening);
        network.radial = scaled(crossing_radial_spring(device), coarsening * coarsening);
        stiffen(network, options);
        return result;
    }
    const SpringCoefficients coefficients =
        spring_coefficients(device, network.lattice, options.bending_ratio);
    network.axial_stiffness = coefficients.surface;
    network.bending_stiffness = coefficients.bending;
    network.radial = coefficients.radial;
    result.force_scale = coefficients.force_scale;
    stiffen(network, options);
    return result;
}

std::vector<PressState> press(const WireNetwork& network, const PressOptions& options,
                              const std::function<void(const PressState&)>& on_state)
{
    check(network, options);
    Press bench(network, options);
    std::vector<PressState> states;
    const auto add = [&] {
        states.push_back(bench.state());
        if (on_state) on_state(states.back());
    };
    add();
    const int num_steps = static_cast<int>(std::floor(options.stroke / options.step + 1e-9));
    for (int step = 1; step <= num_steps; ++step) {
        bench.advance_to(step * options.step);
        add();
    }
    return states;
}

}  // namespace braidzone
