#include "deploy/network_relaxation.hpp"

#include "deploy/hub_coupling.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace braidzone {

namespace {

std::size_t index(int i)
{
    return static_cast<std::size_t>(i);
}

/// Halvings of a step that does not lower the energy, before the step is given up.
constexpr int most_halvings = 6;

}  // namespace

NetworkRelaxation::NetworkRelaxation(const WireNetwork& network, NetworkShape shape,
                                     ContactLaw contact_law, std::vector<Obstacle> obstacles,
                                     const RelaxationOptions& options)
    : network_(network),
      shape_(std::move(shape)),
      law_(contact_law),
      obstacles_(std::move(obstacles)),
      options_(options),
      guides_(index(network.lattice.num_rings)),
      contacts_(index(network.lattice.num_nodes())),
      clearances_(contacts_.size(), 0.0),
      cleared_(contacts_.size(), Vec3::Zero()),
      ring_residuals_(index(network.lattice.num_rings), 0.0),
      hessian_(1, network.lattice.nodes_per_ring),
      factor_(hessian_)
{
}

void NetworkRelaxation::update_contacts(RingRange active)
{
    const int n = network_.lattice.nodes_per_ring;
    std::vector<ContactPlane> planes;
    for (int node = active.first * n; node < active.end * n; ++node) {
        const std::size_t i = index(node);
        const Vec3& place = shape_.nodes[i];
        planes.clear();
        // The distance changes by no more than the way: far from a surface it need not be measured.
        if (clearances_[i] - (place - cleared_[i]).norm() <= law_.offset) {
            clearances_[i] = std::numeric_limits<double>::infinity();
            cleared_[i] = place;
            for (const Obstacle& obstacle : obstacles_) {
                clearances_[i] = std::min(clearances_[i], obstacle.clearance(place));
                if (clearances_[i] <= law_.offset) obstacle.pieces(place, law_.offset, planes);
            }
        }
        update(contacts_[i], law_, planes, place);
    }
}

double NetworkRelaxation::guide_energy(RingRange active) const
{
    const int n = network_.lattice.nodes_per_ring;
    double energy = 0.0;
    for (int ring = active.first; ring < active.end; ++ring) {
        const RingGuide& guide = guides_[index(ring)];
        if (!guide.crimped && !guide.held) continue;
        double mean = 0.0;
        for (int node = ring * n; node < (ring + 1) * n; ++node) {
            const Vec3 from_axis = shape_.nodes[index(node)] - guide.section.origin;
            const double along = guide.section.tangent.dot(from_axis);
            mean += along / n;
            if (!guide.crimped) continue;
            const double radius = (from_axis - along * guide.section.tangent).norm();
            energy += 0.5 * options_.guide_stiffness * std::pow(radius - options_.guide_radius, 2);
        }
        if (guide.held) energy += 0.5 * options_.guide_stiffness * mean * mean;
    }
    return energy;
}

void NetworkRelaxation::add_guides(RingRange active, std::vector<Vec3>& gradient,
                                   RingBandMatrix& hessian) const
{
    const int n = network_.lattice.nodes_per_ring;
    const int begin = active.first * n;
    for (int ring = active.first; ring < active.end; ++ring) {
        const RingGuide& guide = guides_[index(ring)];
        const Vec3& tangent = guide.section.tangent;
        double mean = 0.0;
        for (int node = ring * n; node < (ring + 1) * n; ++node) {
            const Vec3 from_axis = shape_.nodes[index(node)] - guide.section.origin;
            mean += tangent.dot(from_axis) / n;
            if (!guide.crimped) continue;
            const Vec3 across = from_axis - tangent.dot(from_axis) * tangent;
            const double radius = across.norm();
            const Vec3 outward = across / radius;
            gradient[index(node - begin)] +=
                options_.guide_stiffness * (radius - options_.guide_radius) * outward;
            hessian.add(node - begin, node - begin,
                        options_.guide_stiffness * outward * outward.transpose());
        }
        for (int node = ring * n; node < (ring + 1) * n; ++node) {
            if (guide.held) {
                gradient[index(node - begin)] += options_.guide_stiffness * mean / n * tangent;
                // The mean couples all nodes of the ring; its diagonal part bounds it.
                hessian.add(node - begin, node - begin,
                            options_.guide_stiffness / n * tangent * tangent.transpose());
            }
            if (guide.in_plane) {
                // Stiff enough that nothing moves a node out of the plane by a rounding error.
                const double locked = 1e6 * (network_.axial_stiffness + law_.normal_stiffness);
                hessian.add(node - begin, node - begin, locked * tangent * tangent.transpose());
            }
        }
    }
}

void NetworkRelaxation::limit_to_plane(RingRange active, std::vector<Vec3>& vectors) const
{
    const int n = network_.lattice.nodes_per_ring;
    for (int ring = active.first; ring < active.end; ++ring) {
        if (!guides_[index(ring)].in_plane) continue;
        const Vec3& tangent = guides_[index(ring)].section.tangent;
        for (int i = (ring - active.first) * n; i < (ring + 1 - active.first) * n; ++i)
            vectors[index(i)] -= tangent.dot(vectors[index(i)]) * tangent;
    }
}

double NetworkRelaxation::energy(RingRange active) const
{
    const int n = network_.lattice.nodes_per_ring;
    double energy = network_energy(network_, shape_, active) + guide_energy(active);
    for (int node = active.first * n; node < active.end * n; ++node)
        energy += contact_energy(contacts_[index(node)], law_, shape_.nodes[index(node)]);
    return energy;
}

double NetworkRelaxation::record_residuals(RingRange active, const std::vector<Vec3>& gradient)
{
    const int n = network_.lattice.nodes_per_ring;
    double residual = 0.0;
    for (int ring = active.first; ring < active.end; ++ring) {
        double& largest = ring_residuals_[index(ring)];
        largest = 0.0;
        for (int i = (ring - active.first) * n; i < (ring + 1 - active.first) * n; ++i)
            largest = std::max(largest, gradient[index(i)].norm());
        residual = std::max(residual, largest);
    }
    return residual;
}

std::vector<Vec3> NetworkRelaxation::newton_step(RingRange active,
                                                 const std::vector<Vec3>& gradient,
                                                 const RingBandMatrix& hessian)
{
    const int n = network_.lattice.nodes_per_ring;
    const int begin = active.first * n, end = active.end * n;
    std::vector<Vec3> step;
    for (int attempt = 0; attempt < options_.contact_attempts; ++attempt) {
        RingBandMatrix& matrix = factor_ = hessian;
        step = gradient;
        for (int node = begin; node < end; ++node) {
            const NodeContact& contact = contacts_[index(node)];
            Vec3& force = step[index(node - begin)];
            if (!contact.planes.empty()) {
                force += contact_gradient(contact, law_);
                matrix.add(node - begin, node - begin, contact_hessian(contact, law_));
            }
            force = -force;
        }
        limit_to_plane(active, step);
        if (!matrix.solve(step)) return {};
        limit_to_plane(active, step);
        double longest = 0.0;
        for (const Vec3& way : step)
            longest = std::max(longest, way.norm());
        const double fraction = std::min(1.0, options_.largest_step / longest);
        for (Vec3& way : step)
            way *= fraction;
        if (!find_contacts_of_step(active, step)) break;
    }
    return step;
}

/// Corrects which planes act in a step; adds those of surfaces that the step passes.
/// @return true if there was something to correct
bool NetworkRelaxation::find_contacts_of_step(RingRange active, const std::vector<Vec3>& step)
{
    const int n = network_.lattice.nodes_per_ring;
    bool corrected = false;
    for (int node = active.first * n; node < active.end * n; ++node) {
        NodeContact& contact = contacts_[index(node)];
        const Vec3& way = step[index(node - active.first * n)];
        for (ContactPlane& plane : contact.planes) {
            const bool acts = gap_after(plane, way) < 0.0;
            corrected = corrected || acts != plane.acts;
            plane.acts = acts;
        }
        const Vec3& place = contact.position;
        if (clearances_[index(node)] - (place + way - cleared_[index(node)]).norm() > law_.offset)
            continue;
        for (const Obstacle& obstacle : obstacles_) {
            std::optional<ContactPlane> passed = obstacle.passage(place, place + way);
            if (!passed) continue;
            passed->gap -= law_.offset;
            passed->acts = true;
            contact.planes.push_back(*passed);
            corrected = true;
        }
    }
    return corrected;
}

void NetworkRelaxation::stop_at_obstacles(RingRange active, const std::vector<Vec3>& start)
{
    const int n = network_.lattice.nodes_per_ring;
    for (int node = active.first * n; node < active.end * n; ++node) {
        const Vec3& from = start[index(node - active.first * n)];
        Vec3& to = shape_.nodes[index(node)];
        if (clearances_[index(node)] - (to - cleared_[index(node)]).norm() > law_.offset) continue;
        for (const Obstacle& obstacle : obstacles_) {
            const std::optional<ContactPlane> passed = obstacle.passage(from, to);
            if (!passed) continue;
            // Half the gap remains, or half the offset if the node was well away.
            const double remaining = 0.5 * std::min(passed->gap, law_.offset);
            const double approach = passed->outward.dot(to - from);
            to = from + (passed->gap - remaining) / approach * (to - from);
        }
    }
}

void NetworkRelaxation::settle_contacts(RingRange active)
{
    update_contacts(active);
    const int n = network_.lattice.nodes_per_ring;
    for (int node = active.first * n; node < active.end * n; ++node)
        settle(contacts_[index(node)], law_);
}

RingBandMatrix& NetworkRelaxation::hessian_of(RingRange active)
{
    // Kept from one iteration to the next: it takes longer to get the memory than to fill it.
    if (hessian_.num_rings() != active.size())
        hessian_ = RingBandMatrix(active.size(), network_.lattice.nodes_per_ring);
    hessian_.set_zero();
    return hessian_;
}

double NetworkRelaxation::iterate(RingRange active)
{
    ++num_iterations_;
    const int n = network_.lattice.nodes_per_ring;
    const int begin = active.first * n, end = active.end * n;
    update_contacts(active);

    std::vector<Vec3> gradient = network_gradient(network_, shape_, active);
    RingBandMatrix& hessian = hessian_of(active);
    add_network_hessian(network_, shape_, active, hessian);
    if (options_.couple_hubs) add_hub_coupling(network_, shape_, active, hessian);
    add_guides(active, gradient, hessian);
    const Eigen::Matrix3d proximal = options_.proximal_stiffness * Eigen::Matrix3d::Identity();
    for (int node = begin; node < end; ++node)
        hessian.add(node - begin, node - begin, proximal);
    std::vector<Vec3> total = gradient;
    for (int node = begin; node < end; ++node)
        total[index(node - begin)] += contact_gradient(contacts_[index(node)], law_);
    limit_to_plane(active, total);
    const double residual = record_residuals(active, total);
    const std::vector<Vec3> step = newton_step(active, gradient, hessian);
    if (step.empty()) return residual;

    const std::vector<Vec3> start(shape_.nodes.begin() + begin, shape_.nodes.begin() + end);
    const double before = energy(active);
    double fraction = 1.0;
    for (int halving = 0; halving <= most_halvings; ++halving, fraction *= 0.5) {
        for (std::size_t i = 0; i < step.size(); ++i)
            shape_.nodes[index(begin) + i] = start[i] + fraction * step[i];
        if (energy(active) <= before) break;
    }
    stop_at_obstacles(active, start);
    return residual;
}

/// Largest force on a node of the two rings before a window, which feel what moves in it.
double NetworkRelaxation::residual_before(RingRange stretch, int first) const
{
    const RingRange margin{std::max(stretch.first, first - 2), first};
    if (margin.size() <= 0) return 0.0;
    const int n = network_.lattice.nodes_per_ring;
    std::vector<Vec3> gradient = network_gradient(network_, shape_, margin);
    for (std::size_t i = 0; i < gradient.size(); ++i)
        gradient[i] += contact_gradient(contacts_[index(margin.first * n) + i], law_);
    limit_to_plane(margin, gradient);
    double largest = 0.0;
    for (const Vec3& force : gradient)
        largest = std::max(largest, force.norm());
    return largest;
}

double NetworkRelaxation::relax(RingRange stretch, int& window, double tolerance,
                                int most_iterations,
                                const std::function<void(RingRange)>& after_iteration)
{
    double residual = std::numeric_limits<double>::infinity();
    for (int i = 0; i < most_iterations; ++i) {
        const RingRange active{std::max(stretch.first, stretch.end - window), stretch.end};
        residual = iterate(active);
        after_iteration(active);
        const bool reaches_further = residual_before(stretch, active.first) > tolerance;
        if (reaches_further) {
            window = std::min(2 * window, stretch.size());
            residual = std::numeric_limits<double>::infinity();
        } else if (residual <= tolerance) {
            break;
        }
    }
    return residual;
}

}  // namespace braidzone
