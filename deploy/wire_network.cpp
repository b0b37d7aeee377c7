#include "deploy/wire_network.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace braidzone {

namespace {

using Eigen::Matrix3d;

/// Steps of the column from one ring to the next: a left-handed and a right-handed wire.
constexpr int column_steps[] = {0, -1};

std::size_t index(int i)
{
    return static_cast<std::size_t>(i);
}

Vec3 hub_of(const BraidLattice& lattice, const NetworkShape& shape, int ring)
{
    Vec3 sum = Vec3::Zero();
    for (int column = 0; column < lattice.nodes_per_ring; ++column)
        sum += shape.nodes[index(lattice.node(ring, column))];
    return sum / lattice.nodes_per_ring;
}

RadialSpring spring_of_ring(const WireNetwork& network, int ring)
{
    if (network.lattice.rest_radii.empty()) return network.radial;
    return at_rest_radius(network.radial, network.lattice.rest_radius(ring));
}

/// 2 (1 - cos(pi / n)): a chord's second difference on a circle over its radius.
double natural_bend(const BraidLattice& lattice)
{
    return 2.0 * (1.0 - std::cos(std::numbers::pi / lattice.nodes_per_ring));
}

/// The three crossings of a bend around (ring, column) along a wire.
struct Bend {
    int before, middle, after;
};

Bend bend_at(const BraidLattice& lattice, int ring, int column, int column_step)
{
    return {lattice.node(ring - 1, column - column_step), lattice.node(ring, column),
            lattice.node(ring + 1, column + column_step)};
}

/// Rings whose arms to the next ring touch the stretch.
RingRange arm_rings(const NetworkShape& shape, RingRange active)
{
    return {std::max(0, active.first - 1), std::min(active.end, shape.num_rings - 1)};
}

/// Rings around which a bend touches the stretch.
RingRange bend_rings(const NetworkShape& shape, RingRange active)
{
    return {std::max(1, active.first - 1), std::min(active.end + 1, shape.num_rings - 1)};
}

template <typename Function>
void for_each_arm(const BraidLattice& lattice, RingRange rings, Function function)
{
    for (int ring = rings.first; ring < rings.end; ++ring) {
        for (int column = 0; column < lattice.nodes_per_ring; ++column) {
            for (int step : column_steps)
                function(lattice.node(ring, column), lattice.node(ring + 1, column + step));
        }
    }
}

/// Calls function(ring, bend, deviation from the bend of a helix) for each bend.
template <typename Function>
void for_each_bend(const BraidLattice& lattice, const NetworkShape& shape, RingRange rings,
                   Function function)
{
    const double natural = natural_bend(lattice);
    for (int ring = rings.first; ring < rings.end; ++ring) {
        const Vec3 hub = hub_of(lattice, shape, ring);
        for (int column = 0; column < lattice.nodes_per_ring; ++column) {
            for (int step : column_steps) {
                const Bend bend = bend_at(lattice, ring, column, step);
                const Vec3& middle = shape.nodes[index(bend.middle)];
                const Vec3 deviation = shape.nodes[index(bend.before)] - 2.0 * middle +
                                       shape.nodes[index(bend.after)] + natural * (middle - hub);
                function(ring, bend, deviation);
            }
        }
    }
}

}  // namespace

double network_energy(const WireNetwork& network, const NetworkShape& shape, RingRange active)
{
    const BraidLattice& lattice = network.lattice;
    double energy = 0.0;
    for_each_arm(lattice, arm_rings(shape, active), [&](int first, int second) {
        const double stretch =
            (shape.nodes[index(second)] - shape.nodes[index(first)]).norm() - lattice.arm_length;
        energy += 0.5 * network.axial_stiffness * stretch * stretch;
    });
    for_each_bend(lattice, shape, bend_rings(shape, active),
                  [&](int, const Bend&, const Vec3& deviation) {
                      energy += 0.5 * network.bending_stiffness * deviation.squaredNorm();
                  });
    for (int ring = active.first; ring < active.end; ++ring) {
        const Vec3 hub = hub_of(lattice, shape, ring);
        const RadialSpring spring = spring_of_ring(network, ring);
        const double share = lattice.area_share(ring);
        for (int column = 0; column < lattice.nodes_per_ring; ++column) {
            const Vec3 outward = shape.nodes[index(lattice.node(ring, column))] - hub;
            energy += share * radial_energy(spring, outward.norm());
        }
    }
    return energy;
}

std::vector<Vec3> network_gradient(const WireNetwork& network, const NetworkShape& shape,
                                   RingRange active)
{
    const BraidLattice& lattice = network.lattice;
    const int n = lattice.nodes_per_ring;
    const int begin = active.first * n, end = active.end * n;
    std::vector<Vec3> gradient(index(end - begin), Vec3::Zero());
    const auto add = [&](int node, const Vec3& part) {
        if (node >= begin && node < end) gradient[index(node - begin)] += part;
    };

    for_each_arm(lattice, arm_rings(shape, active), [&](int first, int second) {
        const Vec3 arm = shape.nodes[index(second)] - shape.nodes[index(first)];
        const Vec3 pull = network.axial_stiffness * (1.0 - lattice.arm_length / arm.norm()) * arm;
        add(first, -pull);
        add(second, pull);
    });

    const double natural = natural_bend(lattice);
    std::vector<Vec3> ring_sums(index(shape.num_rings), Vec3::Zero());  // of bends, for the hubs
    for_each_bend(lattice, shape, bend_rings(shape, active),
                  [&](int ring, const Bend& bend, const Vec3& deviation) {
                      const Vec3 force = network.bending_stiffness * deviation;
                      const Vec3 of_radius = natural * force;
                      add(bend.before, force);
                      add(bend.after, force);
                      add(bend.middle, of_radius - 2.0 * force);
                      ring_sums[index(ring)] -= of_radius;
                  });

    for (int ring = active.first; ring < active.end; ++ring) {
        const Vec3 hub = hub_of(lattice, shape, ring);
        const RadialSpring spring = spring_of_ring(network, ring);
        const double share = lattice.area_share(ring);
        for (int column = 0; column < n; ++column) {
            const Vec3 outward = shape.nodes[index(ring * n + column)] - hub;
            const double radius = outward.norm();
            if (!(radius > 0.0)) continue;
            const Vec3 part = -share * radial_force(spring, radius) / radius * outward;
            gradient[index(ring * n + column - begin)] += part;
            ring_sums[index(ring)] -= part;
        }
        for (int column = 0; column < n; ++column)
            gradient[index(ring * n + column - begin)] += ring_sums[index(ring)] / n;
    }
    return gradient;
}

void add_network_hessian(const WireNetwork& network, const NetworkShape& shape, RingRange active,
                         RingBandMatrix& hessian)
{
    const BraidLattice& lattice = network.lattice;
    const int n = lattice.nodes_per_ring;
    const int begin = active.first * n, end = active.end * n;
    const auto add = [&](int first, int second, const Matrix3d& block) {
        if (first >= begin && first < end && second >= begin && second < end)
            hessian.add(first - begin, second - begin, block);
    };

    for_each_arm(lattice, arm_rings(shape, active), [&](int first, int second) {
        const Vec3 arm = shape.nodes[index(second)] - shape.nodes[index(first)];
        const double length = arm.norm();
        const Vec3 along = arm / length;
        const double sideways = std::max(0.0, 1.0 - lattice.arm_length / length);
        const Matrix3d block =
            network.axial_stiffness *
            (sideways * Matrix3d::Identity() + (1.0 - sideways) * along * along.transpose());
        add(first, first, block);
        add(second, second, block);
        add(first, second, -block);
    });

    const double natural = natural_bend(lattice);
    const Matrix3d outer = network.bending_stiffness * Matrix3d::Identity();
    const Matrix3d coupling = (natural - 2.0) * outer;
    const Matrix3d middle = (natural - 2.0) * coupling;
    const RingRange bends = bend_rings(shape, active);
    for (int ring = bends.first; ring < bends.end; ++ring) {
        for (int column = 0; column < n; ++column) {
            for (int step : column_steps) {
                const Bend bend = bend_at(lattice, ring, column, step);
                add(bend.before, bend.before, outer);
                add(bend.after, bend.after, outer);
                add(bend.middle, bend.middle, middle);
                add(bend.before, bend.after, outer);
                add(bend.before, bend.middle, coupling);
                add(bend.after, bend.middle, coupling);
            }
        }
    }

    for (int ring = active.first; ring < active.end; ++ring) {
        const Vec3 hub = hub_of(lattice, shape, ring);
        const RadialSpring spring = spring_of_ring(network, ring);
        const double share = lattice.area_share(ring);
        for (int column = 0; column < n; ++column) {
            const int node = ring * n + column;
            const Vec3 outward = shape.nodes[index(node)] - hub;
            const double radius = outward.norm();
            const double stiffness = share * std::max(0.0, radial_stiffness_at(spring, radius));
            add(node, node, stiffness / (radius * radius) * outward * outward.transpose());
        }
    }
}

double largest_arm_strain(const WireNetwork& network, const NetworkShape& shape)
{
    double largest = 0.0;
    for_each_arm(network.lattice, {0, shape.num_rings - 1}, [&](int first, int second) {
        const double length = (shape.nodes[index(second)] - shape.nodes[index(first)]).norm();
        largest = std::max(largest, std::abs(length / network.lattice.arm_length - 1.0));
    });
    return largest;
}

}  // namespace braidzone
