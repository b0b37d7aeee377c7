#include "deploy/plane_release.hpp"

#include "deploy/network_relaxation.hpp"
#include "deploy/wall_obstacle.hpp"

#include <algorithm>

namespace braidzone {

namespace {

/// Rings that move at first after a release.
constexpr int smallest_window = 20;

NetworkRelaxation crimped_network(const WireNetwork& network, const CrimpedBraid& crimped,
                                  const WallTree& wall, const NetworkRelease& release)
{
    NetworkShape shape;
    for (int node = 0; node < crimped.lattice.num_nodes(); ++node)
        shape.nodes.push_back(on_ray(crimped, node, crimped.radius));
    shape.num_rings = crimped.lattice.num_rings;

    NetworkRelaxation relaxation(
        network, std::move(shape),
        {.offset = release.contact_offset,
         .normal_stiffness = release.contact_stiffness,
         .tangential_stiffness = release.contact_stiffness,
         .friction = release.friction},
        {wall_obstacle(wall)},
        {.proximal_stiffness = proximal_ratio * radial_stiffness(network.radial),
         .largest_step = largest_step_ratio * crimped.lattice.nominal_radius});
    for (std::size_t ring = 0; ring < crimped.rings.size(); ++ring) {
        relaxation.guides()[ring].section = crimped.rings[ring];
        relaxation.guides()[ring].in_plane = true;
    }
    return relaxation;
}

}  // namespace

ReleasedNetwork release_in_planes(const WireNetwork& network, const CrimpedBraid& crimped,
                                  const std::vector<double>& arc_lengths, ReleaseOrder order,
                                  const WallTree& wall, const NetworkRelease& release)
{
    NetworkRelaxation relaxation = crimped_network(network, crimped, wall, release);
    const int num_rings = crimped.lattice.num_rings;
    const auto planes_stay = [](RingRange) {};
    const double loose_tolerance = loose_tolerance_ratio * release.force_tolerance;
    int window = smallest_window;
    for (int num_released = order == ReleaseOrder::at_once ? num_rings : 1;
         num_released <= num_rings; ++num_released) {
        const RingRange released{0, num_released};
        window = std::max(smallest_window, 3 * window / 4);
        const double residual = relaxation.relax(released, window, loose_tolerance,
                                                 most_iterations_per_ring, planes_stay);
        relaxation.settle_contacts(released);
        if (release.report)
            release.report(relaxation.num_iterations(), num_released, relaxation.shape(), residual);
    }

    ReleasedNetwork result;
    relaxation.options().proximal_stiffness =
        final_proximal_ratio * radial_stiffness(network.radial);
    window = num_rings;
    result.residual = relaxation.relax({0, num_rings}, window, release.force_tolerance,
                                       release.most_iterations, planes_stay);
    if (release.report)
        release.report(relaxation.num_iterations(), num_rings, relaxation.shape(), result.residual);
    result.nodes = relaxation.shape().nodes;
    result.rings = crimped.rings;
    result.ring_arc_length = arc_lengths;
    for (int node = 0; node < crimped.lattice.num_nodes(); ++node)
        result.contact_force.push_back(relaxation.normal_force(node));
    result.iterations = relaxation.num_iterations();
    result.arm_strain = largest_arm_strain(network, relaxation.shape());
    return result;
}

}  // namespace braidzone
