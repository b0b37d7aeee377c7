#include "deploy/opening_braid.hpp"

#include "deploy/wire_bending.hpp"

#include <algorithm>
#include <cmath>

namespace braidzone {

namespace {

constexpr double mass = 1.0;

/// Square of a bound on the angular frequencies [1/s^2]. A compliant wall stiffens a node by its
/// own spring; the mode of a free hub against its ring is at most twice as stiff as a radial
/// spring.
double largest_squared_frequency(const SpringCoefficients& coefficients, const WallSupport& support,
                                 bool free_hubs)
{
    double wall = 0.0;
    for (double stiffness : support.stiffness)
        wall = std::max(wall, stiffness);
    const double lattice = largest_frequency(coefficients, mass);
    const double hub = free_hubs ? radial_stiffness(coefficients.radial) : 0.0;
    return lattice * lattice + (wall + hub) / mass;
}

}  // namespace

OpeningBraid::OpeningBraid(const CrimpedBraid& braid, const SpringCoefficients& coefficients,
                           const WallSupport& support, const DeployOptions& options)
    : braid_(braid),
      lattice_(braid_.lattice),
      coefficients_(coefficients),
      support_(support),
      motion_(options.motion),
      free_hubs_(options.ring_hub == RingHub::free),
      rings_(braid_.rings),
      radii_(braid_.rays.size(), braid_.radius),
      displacements_(radii_.size(), 0.0),
      spring_forces_(radii_.size(), 0.0),
      forces_(radii_.size(), 0.0),
      held_(radii_.size(), 0),
      hub_displacements_(rings_.size(), Vec3::Zero()),
      hub_forces_(rings_.size(), Vec3::Zero()),
      moved_(rings_.size() + 2 * reach, 0)
{
    const double squared = largest_squared_frequency(coefficients_, support_, free_hubs_);
    scheme_.mass = mass;
    scheme_.damping = options.damping;
    scheme_.time_step = options.time_step_ratio * 2.0 / std::sqrt(squared);
    mobility_ = options.time_step_ratio * 2.0 / (squared * mass);
    nodes_.reserve(radii_.size());
    for (int node = 0; node < lattice_.num_nodes(); ++node)
        nodes_.push_back(on_ray(braid_, node, braid_.radius));
}

void OpeningBraid::step()
{
    const std::vector<char> awake = awake_rings();
    for (int ring = 0; ring < num_released_; ++ring) {
        if (awake[index(ring)]) update_forces(ring);
    }
    std::fill(moved_.begin(), moved_.end(), char{0});
    for (int ring = 0; ring < num_released_; ++ring) {
        if (!awake[index(ring)]) continue;
        move(ring);
        if (free_hubs_) move_hub(ring);
    }
}

void OpeningBraid::update_all_forces()
{
    for (int ring = 0; ring < num_released_; ++ring)
        update_forces(ring);
}

double OpeningBraid::largest_residual() const
{
    const bool has_inertia = motion_ == Motion::inertial;
    const double radial = radial_stiffness(coefficients_.radial);
    const double per_displacement =
        has_inertia ? std::sqrt(scheme_.mass * radial) / scheme_.time_step : 0.0;
    double largest = 0.0;
    for (int node = 0; node < num_released_ * lattice_.nodes_per_ring; ++node) {
        const std::size_t i = index(node);
        if (held_[i] && forces_[i] >= 0.0) continue;
        largest = std::max(
            {largest, std::abs(forces_[i]), per_displacement * std::abs(displacements_[i])});
    }
    if (!free_hubs_) return largest;
    for (int ring = 0; ring < num_released_; ++ring) {
        largest = std::max(
            {largest, hub_forces_[index(ring)].norm(),
             lattice_.nodes_per_ring * per_displacement * hub_displacements_[index(ring)].norm()});
    }
    return largest;
}

double OpeningBraid::elastic_energy() const
{
    double energy = braidzone::elastic_energy(lattice_, coefficients_, nodes_, rings_) +
                    bending_energy(lattice_, coefficients_.bending, radii_);
    if (!is_compliant()) return energy;
    for (std::size_t node = 0; node < radii_.size(); ++node) {
        const double beyond = std::max(0.0, radii_[node] - support_.stops[node]);
        energy += 0.5 * support_.stiffness[node] * beyond * beyond;
    }
    return energy;
}

double OpeningBraid::kinetic_energy() const
{
    if (motion_ == Motion::quasi_static) return 0.0;
    double sum = 0.0;
    for (double displacement : displacements_)
        sum += displacement * displacement;
    for (const Vec3& displacement : hub_displacements_)
        sum += lattice_.nodes_per_ring * displacement.squaredNorm();
    return 0.5 * scheme_.mass * sum / (scheme_.time_step * scheme_.time_step);
}

std::vector<double> OpeningBraid::wall_displacements() const
{
    std::vector<double> displacements(radii_.size(), 0.0);
    if (!is_compliant()) return displacements;
    for (std::size_t node = 0; node < radii_.size(); ++node)
        displacements[node] = std::max(0.0, radii_[node] - support_.stops[node]);
    return displacements;
}

/// A ring needs a step if it or a neighbour moved in the last one; otherwise nothing about it has
/// changed. This makes the cost that of the opening front and of the free nodes.
std::vector<char> OpeningBraid::awake_rings() const
{
    std::vector<char> awake(index(num_released_));
    for (int ring = 0; ring < num_released_; ++ring) {
        const auto first = moved_.begin() + ring;
        awake[index(ring)] =
            std::any_of(first, first + 2 * reach + 1, [](char moved) { return moved != 0; });
    }
    return awake;
}

double OpeningBraid::wall_force(std::size_t node) const
{
    return -support_.stiffness[node] * std::max(0.0, radii_[node] - support_.stops[node]);
}

void OpeningBraid::update_forces(int ring)
{
    for (int column = 0; column < lattice_.nodes_per_ring; ++column) {
        const std::size_t i = index(lattice_.node(ring, column));
        spring_forces_[i] =
            braid_.rays[i].dot(spring_force(lattice_, coefficients_, nodes_, rings_, ring, column));
        forces_[i] = spring_forces_[i] +
                     bending_force(lattice_, coefficients_.bending, radii_, ring, column);
        if (is_compliant()) forces_[i] += wall_force(i);
    }
    if (free_hubs_)
        hub_forces_[index(ring)] = hub_force(lattice_, coefficients_, nodes_, rings_, ring);
}

double OpeningBraid::next(double last_displacement, double force, double relative_mass) const
{
    if (motion_ == Motion::quasi_static) return mobility_ / relative_mass * force;
    return next_displacement(scheme_, last_displacement, force / relative_mass);
}

void OpeningBraid::move(int ring)
{
    for (int column = 0; column < lattice_.nodes_per_ring; ++column) {
        const int node = lattice_.node(ring, column);
        const std::size_t i = index(node);
        if (held_[i] && forces_[i] >= 0.0) continue;
        displacements_[i] = next(displacements_[i], forces_[i], 1.0);
        radii_[i] += displacements_[i];
        held_[i] = !is_compliant() && radii_[i] >= support_.stops[i];
        if (held_[i]) {
            radii_[i] = support_.stops[i];
            displacements_[i] = 0.0;
        }
        nodes_[i] = on_ray(braid_, node, radii_[i]);
        mark_moved(ring);
    }
}

void OpeningBraid::move_hub(int ring)
{
    Vec3& displacement = hub_displacements_[index(ring)];
    const Vec3& force = hub_forces_[index(ring)];
    for (int axis = 0; axis < 3; ++axis)
        displacement[axis] = next(displacement[axis], force[axis], lattice_.nodes_per_ring);
    if (displacement.isZero(0.0)) return;
    rings_[index(ring)].origin += displacement;
    mark_moved(ring);
}

}  // namespace braidzone
