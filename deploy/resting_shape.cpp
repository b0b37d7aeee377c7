#include "deploy/resting_shape.hpp"

#include "deploy/wire_bending.hpp"
#include "deploy/wire_stencil_matrix.hpp"

#include <Eigen/SparseCholesky>

#include <algorithm>
#include <cmath>

namespace braidzone {
namespace {

/// Longest step of a node, over the nominal radius.
constexpr double longest_step = 0.1;
constexpr int most_halvings = 12;
/// Armijo's: the share of the predicted fall of the energy that a step must bring.
constexpr double least_fall = 1e-4;
/// Change of the energy that is rounding, over the energy.
constexpr double rounding = 1e-12;

std::size_t index(int i)
{
    return static_cast<std::size_t>(i);
}

/// The braid with its nodes at some radii.
class Shape {
public:
    Shape(const CrimpedBraid& braid, const SpringCoefficients& coefficients,
          const WallSupport& support)
        : braid_(braid), coefficients_(coefficients), support_(support), hessian_(braid.lattice)
    {
        std::vector<double> radii;
        const std::vector<double>& near = support.is_compliant() ? support.wall : support.stops;
        for (const double stop : near)
            radii.push_back(std::max(braid.radius, std::min(stop, braid.lattice.nominal_radius)));
        set_radii(radii);
    }

    const std::vector<double>& radii() const { return radii_; }
    const std::vector<double>& spring_forces() const { return spring_forces_; }
    const std::vector<double>& forces() const { return forces_; }
    double energy() const { return energy_; }
    bool is_held(int node) const
    {
        return radii_[index(node)] >= support_.stops[index(node)] && forces_[index(node)] >= 0.0;
    }

    void set_radii(const std::vector<double>& radii)
    {
        radii_ = radii;
        for (std::size_t i = 0; i < radii_.size(); ++i)
            radii_[i] = std::min(radii_[i], support_.stops[i]);
        nodes_.resize(radii_.size());
        for (int node = 0; node < braid_.lattice.num_nodes(); ++node)
            nodes_[index(node)] = on_ray(braid_, node, radii_[index(node)]);
        update_energy_and_forces();
    }

    /// Second derivatives of the energy by the radii.
    /// @param softening  false: without what arms in compression and springs that give way take off
    ///                   the stiffness, so that it is positive definite
    const WireStencilMatrix& hessian(bool softening)
    {
        hessian_.set_zero();
        const BraidLattice& lattice = braid_.lattice;
        for (int ring = 0; ring < lattice.num_rings; ++ring) {
            const RadialSpring spring = spring_of_ring(lattice, coefficients_, ring);
            for (int column = 0; column < lattice.nodes_per_ring; ++column) {
                const int node = lattice.node(ring, column);
                const double own = own_stiffness(node, spring, lattice.area_share(ring));
                hessian_.add_own(node, softening ? own : std::max(own, 0.0));
                if (ring + 1 == lattice.num_rings) continue;
                for (const std::size_t family : {0u, 1u}) {
                    const int next = lattice.node(ring + 1, column + lattice.arm_steps[family]);
                    add_arm(node, next, family, lattice.rest_length(ring, family), softening);
                    if (ring == 0) continue;
                    add_bend(lattice.node(ring - 1, column - lattice.arm_steps[family]), node, next,
                             family);
                }
            }
        }
        return hessian_;
    }

private:
    double beyond_wall(std::size_t node) const
    {
        return support_.wall_displacement(node, radii_[node]);
    }

    void update_energy_and_forces()
    {
        const BraidLattice& lattice = braid_.lattice;
        vectors_.assign(radii_.size(), Vec3::Zero());
        forces_.assign(radii_.size(), 0.0);
        energy_ = add_spring_forces(lattice, coefficients_, nodes_, braid_.rings, vectors_) +
                  add_bending_forces(lattice, coefficients_.bending, radii_, forces_);
        spring_forces_.resize(radii_.size());
        for (std::size_t i = 0; i < radii_.size(); ++i) {
            spring_forces_[i] = braid_.rays[i].dot(vectors_[i]);
            forces_[i] += spring_forces_[i];
            if (!support_.is_compliant()) continue;
            const double beyond = beyond_wall(i);
            forces_[i] -= support_.stiffness[i] * beyond;
            energy_ += 0.5 * support_.stiffness[i] * beyond * beyond;
        }
    }

    /// Of the radial spring and of a compliant wall.
    double own_stiffness(int node, const RadialSpring& spring, double area_share) const
    {
        double stiffness = area_share * radial_stiffness_at(spring, radii_[index(node)]);
        if (beyond_wall(index(node)) > 0.0) stiffness += support_.stiffness[index(node)];
        return stiffness;
    }

    /// c ((1 - l0 / l) e_a . e_b + l0 / l (d . e_a)(d . e_b)) with d along the arm.
    void add_arm(int node, int next, std::size_t family, double rest_length, bool softening)
    {
        const Vec3 arm = nodes_[index(next)] - nodes_[index(node)];
        const double length = arm.norm();
        const double ratio = rest_length / length;
        const double across = softening ? 1.0 - ratio : std::max(0.0, 1.0 - ratio);
        const Vec3 &ray = braid_.rays[index(node)], &next_ray = braid_.rays[index(next)];
        const double along = arm.dot(ray) / length, next_along = arm.dot(next_ray) / length;
        const double c = coefficients_.surface;
        hessian_.add_own(node, c * (across + ratio * along * along));
        hessian_.add_own(next, c * (across + ratio * next_along * next_along));
        hessian_.add_next(node, family,
                          -c * (across * ray.dot(next_ray) + ratio * along * next_along));
    }

    /// Of (r- - 2 r + r+)^2 / 2.
    void add_bend(int before, int node, int after, std::size_t family)
    {
        const double c = coefficients_.bending;
        hessian_.add_own(before, c);
        hessian_.add_own(node, 4.0 * c);
        hessian_.add_own(after, c);
        hessian_.add_next(before, family, -2.0 * c);
        hessian_.add_next(node, family, -2.0 * c);
        hessian_.add_second(before, family, c);
    }

    const CrimpedBraid& braid_;
    const SpringCoefficients& coefficients_;
    const WallSupport& support_;
    std::vector<double> radii_;
    std::vector<Vec3> nodes_, vectors_;  ///< places; forces of the springs
    std::vector<double> spring_forces_, forces_;
    double energy_ = 0.0;
    WireStencilMatrix hessian_;
};

/// Newton's step of the free nodes, 0 of the held ones, and whether the Hessian was positive
/// definite.
struct Step {
    std::vector<double> radii;  ///< |N| change [m]
    bool is_convex = true;
};

Step newton_step(Shape& shape, double largest)
{
    std::vector<int> place(shape.radii().size(), -1);
    std::vector<double> free_forces;
    for (std::size_t node = 0; node < place.size(); ++node) {
        if (shape.is_held(static_cast<int>(node))) continue;
        place[node] = static_cast<int>(free_forces.size());
        free_forces.push_back(shape.forces()[node]);
    }
    const int n = static_cast<int>(free_forces.size());
    Step step{.radii = std::vector<double>(place.size(), 0.0)};
    if (n == 0) return step;
    // Ring by ring the matrix is a band as wide as three rings.
    Eigen::SimplicialLLT<Eigen::SparseMatrix<double>, Eigen::Lower, Eigen::NaturalOrdering<int>>
        factor;
    for (const bool softening : {true, false}) {
        step.is_convex = softening;
        factor.compute(shape.hessian(softening).lower_triangle(place, n));
        if (factor.info() == Eigen::Success) break;
    }
    const Eigen::VectorXd change =
        factor.solve(Eigen::Map<const Eigen::VectorXd>(free_forces.data(), n));
    for (std::size_t node = 0; node < place.size(); ++node) {
        if (place[node] >= 0) step.radii[node] = std::clamp(change[place[node]], -largest, largest);
    }
    return step;
}

/// Largest force on a node that is free to move.
double residual_of(const Shape& shape)
{
    double largest = 0.0;
    for (std::size_t node = 0; node < shape.radii().size(); ++node) {
        if (!shape.is_held(static_cast<int>(node)))
            largest = std::max(largest, std::abs(shape.forces()[node]));
    }
    return largest;
}

/// Goes along the step as far as the energy falls.
void move_along(Shape& shape, const std::vector<double>& step, double smallest_radius)
{
    const std::vector<double> from = shape.radii(), forces = shape.forces();
    const double energy = shape.energy();
    double length = 1.0;
    for (int halving = 0; halving <= most_halvings; ++halving) {
        std::vector<double> radii = from;
        for (std::size_t node = 0; node < radii.size(); ++node)
            radii[node] = std::max(smallest_radius, radii[node] + length * step[node]);
        shape.set_radii(radii);
        double predicted = 0.0;
        for (std::size_t node = 0; node < radii.size(); ++node)
            predicted += forces[node] * (shape.radii()[node] - from[node]);
        if (shape.energy() <= energy - least_fall * predicted + rounding * energy) return;
        length *= 0.5;
    }
}

}  // namespace

RestingShape find_resting_shape(const CrimpedBraid& braid, const SpringCoefficients& coefficients,
                                const WallSupport& support, double tolerance, int max_iterations)
{
    Shape shape(braid, coefficients, support);
    RestingShape rest;
    while (rest.iterations < max_iterations) {
        rest.residual = residual_of(shape);
        const Step step = newton_step(shape, longest_step * braid.lattice.nominal_radius);
        rest.is_at_rest = rest.residual <= tolerance && step.is_convex;
        if (rest.residual <= tolerance) break;  // no force leads away from a saddle
        move_along(shape, step.radii, braid.radius);
        ++rest.iterations;
    }
    rest.residual = residual_of(shape);
    rest.radii = shape.radii();
    rest.spring_forces = shape.spring_forces();
    return rest;
}

}  // namespace braidzone
