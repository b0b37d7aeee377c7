#include "deploy/opening_braid.hpp"

#include "deploy/wire_bending.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace braidzone {

namespace {

constexpr double mass = 1.0;

/// Residual below which a node stays where it is, over the tolerance of the braid at rest: what the
/// nodes around it, each a little off, add to its own stays well below the tolerance.
constexpr double stillness_ratio = 0.02;

/// Square of a bound on the angular frequencies [1/s^2]. A compliant wall stiffens a node by its
/// own spring; the mode of a free hub against its ring is at most twice as stiff as a radial
/// spring.
double largest_squared_frequency(const SpringCoefficients& coefficients, const WallSupport& support,
                                 bool hubs_move)
{
    double wall = 0.0;
    for (double stiffness : support.stiffness)
        wall = std::max(wall, stiffness);
    const double lattice = largest_frequency(coefficients, mass);
    const double hub = hubs_move ? radial_stiffness(coefficients.radial) : 0.0;
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
      hub_freedom_(options.hub_freedom),
      rings_(braid_.rings),
      radii_(braid_.rays.size(), braid_.radius),
      displacements_(radii_.size(), 0.0),
      spring_forces_(radii_.size(), 0.0),
      forces_(radii_.size(), 0.0),
      held_(radii_.size(), 0),
      hub_displacements_(rings_.size(), Vec3::Zero()),
      hub_forces_(rings_.size(), Vec3::Zero()),
      is_stale_(radii_.size(), 0),
      has_stale_(rings_.size(), 0)
{
    const double squared = largest_squared_frequency(coefficients_, support_, hubs_move());
    scheme_.mass = mass;
    scheme_.damping = options.damping;
    scheme_.time_step = options.time_step_ratio * 2.0 / std::sqrt(squared);
    mobility_ = options.time_step_ratio * 2.0 / (squared * mass);
    const double radial = radial_stiffness(coefficients_.radial);
    if (hubs_move())
        hub_stiffness_ = lattice_.nodes_per_ring * radial * (1.0 - hub_freedom_) / hub_freedom_;
    stillness_ = stillness_ratio * options.residual_tolerance * radial * lattice_.nominal_radius;
    if (motion_ == Motion::inertial)
        force_per_swing_ = std::sqrt(scheme_.mass * radial) / scheme_.time_step;
    nodes_.reserve(radii_.size());
    for (int node = 0; node < lattice_.num_nodes(); ++node)
        nodes_.push_back(on_ray(braid_, node, braid_.radius));
}

void OpeningBraid::release_next_ring()
{
    mark_ring_stale(num_released_++);
}

void OpeningBraid::step()
{
    take_stale_nodes();
    for (const Place& place : moving_)
        update_force(place);
    if (hubs_move()) update_hub_forces();
    for (const Place& place : moving_)
        move(place);
    if (!hubs_move()) return;
    for (int ring = 0; ring < num_released_; ++ring)
        move_hub(ring);
}

void OpeningBraid::update_all_forces()
{
    for (int ring = 0; ring < num_released_; ++ring) {
        for (int column = 0; column < lattice_.nodes_per_ring; ++column)
            update_force({ring, column});
    }
    if (hubs_move()) update_hub_forces();
}

double OpeningBraid::residual_of(std::size_t node) const
{
    if (held_[node] && forces_[node] >= 0.0) return 0.0;
    return std::max(std::abs(forces_[node]), force_per_swing_ * std::abs(displacements_[node]));
}

double OpeningBraid::largest_residual() const
{
    double largest = 0.0;
    for (int node = 0; node < num_released_ * lattice_.nodes_per_ring; ++node)
        largest = std::max(largest, residual_of(index(node)));
    if (!hubs_move()) return largest;
    for (int ring = 0; ring < num_released_; ++ring) {
        largest = std::max(
            {largest, hub_forces_[index(ring)].norm(),
             hub_mass_ratio() * force_per_swing_ * hub_displacements_[index(ring)].norm()});
    }
    return largest;
}

double OpeningBraid::elastic_energy() const
{
    double energy = braidzone::elastic_energy(lattice_, coefficients_, nodes_, rings_) +
                    bending_energy(lattice_, coefficients_.bending, radii_);
    for (int ring = 0; ring < lattice_.num_rings; ++ring)
        energy += 0.5 * hub_stiffness_ * hub_way(ring).squaredNorm();
    if (!support_.is_compliant()) return energy;
    for (std::size_t node = 0; node < radii_.size(); ++node) {
        const double beyond = support_.wall_displacement(node, radii_[node]);
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
        if (hubs_move()) sum += hub_mass_ratio() * displacement.squaredNorm();
    return 0.5 * scheme_.mass * sum / (scheme_.time_step * scheme_.time_step);
}

std::vector<double> OpeningBraid::wall_displacements() const
{
    std::vector<double> displacements;
    for (std::size_t node = 0; node < radii_.size(); ++node)
        displacements.push_back(support_.wall_displacement(node, radii_[node]));
    return displacements;
}

void OpeningBraid::mark_ring_stale(int ring)
{
    const auto first = is_stale_.begin() + lattice_.node(ring, 0);
    std::fill(first, first + lattice_.nodes_per_ring, char{1});
    has_stale_[index(ring)] = 1;
}

/// The nodes whose force depends on where a node is: itself, and two to either side along both its
/// wires, by the arms and by the bending.
void OpeningBraid::mark_neighbours_stale(Place place)
{
    const int last = std::min(place.ring + 2, num_released_ - 1);
    for (int ring = std::max(place.ring - 2, 0); ring <= last; ++ring) {
        has_stale_[index(ring)] = 1;
        for (int step : lattice_.arm_steps)
            is_stale_[index({ring, place.column + (ring - place.ring) * step})] = 1;
    }
}

void OpeningBraid::take_stale_nodes()
{
    moving_.clear();
    for (int ring = 0; ring < num_released_; ++ring) {
        if (!std::exchange(has_stale_[index(ring)], char{0})) continue;
        for (int column = 0; column < lattice_.nodes_per_ring; ++column) {
            if (std::exchange(is_stale_[index({ring, column})], char{0}))
                moving_.push_back({ring, column});
        }
    }
}

double OpeningBraid::wall_force(std::size_t node) const
{
    return -support_.stiffness[node] * support_.wall_displacement(node, radii_[node]);
}

void OpeningBraid::update_force(Place place)
{
    const std::size_t i = index(place);
    spring_forces_[i] = braid_.rays[i].dot(
        spring_force(lattice_, coefficients_, nodes_, rings_, place.ring, place.column));
    forces_[i] = spring_forces_[i] +
                 bending_force(lattice_, coefficients_.bending, radii_, place.ring, place.column);
    if (support_.is_compliant()) forces_[i] += wall_force(i);
}

/// From the hub's place to where it is.
Vec3 OpeningBraid::hub_way(int ring) const
{
    return rings_[index(ring)].origin - braid_.rings[index(ring)].origin;
}

void OpeningBraid::update_hub_forces()
{
    for (int ring = 0; ring < num_released_; ++ring) {
        hub_forces_[index(ring)] = hub_force(lattice_, coefficients_, nodes_, rings_, ring) -
                                   hub_stiffness_ * hub_way(ring);
    }
}

double OpeningBraid::next(double last_displacement, double force, double relative_mass) const
{
    if (motion_ == Motion::quasi_static) return mobility_ / relative_mass * force;
    return next_displacement(scheme_, last_displacement, force / relative_mass);
}

void OpeningBraid::move(Place place)
{
    const std::size_t i = index(place);
    if (residual_of(i) <= stillness_) {
        displacements_[i] = 0.0;
        return;
    }
    displacements_[i] = next(displacements_[i], forces_[i], 1.0);
    radii_[i] += displacements_[i];
    held_[i] = radii_[i] >= support_.stops[i];
    if (held_[i]) {
        radii_[i] = support_.stops[i];
        displacements_[i] = 0.0;
    }
    nodes_[i] = braid_.rings[index(place.ring)].origin + radii_[i] * braid_.rays[i];
    mark_neighbours_stale(place);
}

void OpeningBraid::move_hub(int ring)
{
    Vec3& displacement = hub_displacements_[index(ring)];
    const Vec3& force = hub_forces_[index(ring)];
    for (int axis = 0; axis < 3; ++axis)
        displacement[axis] = next(displacement[axis], force[axis], hub_mass_ratio());
    if (displacement.isZero(0.0)) return;
    rings_[index(ring)].origin += displacement;
    mark_ring_stale(ring);
}

}  // namespace braidzone
