#include "deploy/resting_shape.hpp"

#include "deploy/wire_bending.hpp"

#include <Eigen/SparseCholesky>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

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
        : braid_(braid), coefficients_(coefficients), support_(support)
    {
        for (const double stop : support.stops)
            radii_.push_back(std::max(braid.radius, std::min(stop, braid.lattice.nominal_radius)));
        place_nodes();
    }

    const std::vector<double>& radii() const { return radii_; }
    const std::vector<double>& spring_forces() const { return spring_forces_; }
    const std::vector<double>& forces() const { return forces_; }
    bool is_rigid() const { return support_.stiffness.empty(); }
    bool is_held(int node) const
    {
        return is_rigid() && radii_[index(node)] >= support_.stops[index(node)] &&
               forces_[index(node)] >= 0.0;
    }

    void set_radii(const std::vector<double>& radii)
    {
        radii_ = radii;
        if (is_rigid()) {
            for (std::size_t i = 0; i < radii_.size(); ++i)
                radii_[i] = std::min(radii_[i], support_.stops[i]);
        }
        place_nodes();
    }

    void update_forces()
    {
        const BraidLattice& lattice = braid_.lattice;
        spring_forces_.resize(radii_.size());
        forces_.resize(radii_.size());
        for (int ring = 0; ring < lattice.num_rings; ++ring) {
            for (int column = 0; column < lattice.nodes_per_ring; ++column) {
                const std::size_t i = index(lattice.node(ring, column));
                spring_forces_[i] = braid_.rays[i].dot(
                    spring_force(lattice, coefficients_, nodes_, braid_.rings, ring, column));
                forces_[i] = spring_forces_[i] +
                             bending_force(lattice, coefficients_.bending, radii_, ring, column);
                if (!is_rigid()) forces_[i] -= support_.stiffness[i] * beyond_stop(i);
            }
        }
    }

    double energy() const
    {
        double energy = elastic_energy(braid_.lattice, coefficients_, nodes_, braid_.rings) +
                        bending_energy(braid_.lattice, coefficients_.bending, radii_);
        if (is_rigid()) return energy;
        for (std::size_t i = 0; i < radii_.size(); ++i)
            energy += 0.5 * support_.stiffness[i] * beyond_stop(i) * beyond_stop(i);
        return energy;
    }

    /// Second derivatives of the energy by the radii of some nodes.
    /// @param place  |N| row of each node, -1 for those that are held
    /// @param softening  false: without what arms in compression and springs that give way take off
    ///                   the stiffness, so that it is positive definite
    std::vector<Eigen::Triplet<double>> hessian(const std::vector<int>& place, bool softening) const
    {
        std::vector<Eigen::Triplet<double>> entries;
        const auto add = [&](int a, int b, double value) {
            const int row = place[index(a)], column = place[index(b)];
            if (row >= 0 && column >= 0) entries.emplace_back(row, column, value);
        };
        const BraidLattice& lattice = braid_.lattice;
        for (int ring = 0; ring < lattice.num_rings; ++ring) {
            for (int column = 0; column < lattice.nodes_per_ring; ++column) {
                const int node = lattice.node(ring, column);
                const double own = own_stiffness(node, ring);
                add(node, node, softening ? own : std::max(own, 0.0));
                for (const int step : lattice.arm_steps) {
                    if (ring + 1 < lattice.num_rings)
                        add_arm(node, lattice.node(ring + 1, column + step), softening, add);
                    if (ring > 0 && ring + 1 < lattice.num_rings) {
                        add_bend(lattice.node(ring - 1, column - step), node,
                                 lattice.node(ring + 1, column + step), add);
                    }
                }
            }
        }
        return entries;
    }

private:
    double beyond_stop(std::size_t node) const
    {
        return std::max(0.0, radii_[node] - support_.stops[node]);
    }

    void place_nodes()
    {
        nodes_.resize(radii_.size());
        for (int node = 0; node < braid_.lattice.num_nodes(); ++node)
            nodes_[index(node)] = on_ray(braid_, node, radii_[index(node)]);
    }

    /// Of the radial spring and of a compliant wall.
    double own_stiffness(int node, int ring) const
    {
        const BraidLattice& lattice = braid_.lattice;
        const RadialSpring spring =
            lattice.rest_radii.empty()
                ? coefficients_.radial
                : at_rest_radius(coefficients_.radial, lattice.rest_radius(ring));
        double stiffness =
            lattice.area_share(ring) * radial_stiffness_at(spring, radii_[index(node)]);
        if (!is_rigid() && beyond_stop(index(node)) > 0.0)
            stiffness += support_.stiffness[index(node)];
        return stiffness;
    }

    /// c ((1 - l0 / l) e_a . e_b + l0 / l (d . e_a)(d . e_b)) with d along the arm.
    template <typename Add>
    void add_arm(int a, int b, bool softening, const Add& add) const
    {
        const Vec3 arm = nodes_[index(b)] - nodes_[index(a)];
        const double length = arm.norm();
        const double ratio = braid_.lattice.arm_length / length;
        const double across = softening ? 1.0 - ratio : std::max(0.0, 1.0 - ratio);
        const Vec3 along = arm / length;
        const auto between = [&](int i, int j) {
            const Vec3 &ray = braid_.rays[index(i)], &other = braid_.rays[index(j)];
            return coefficients_.surface *
                   (across * ray.dot(other) + ratio * along.dot(ray) * along.dot(other));
        };
        add(a, a, between(a, a));
        add(b, b, between(b, b));
        add(a, b, -between(a, b));
        add(b, a, -between(a, b));
    }

    template <typename Add>
    void add_bend(int before, int node, int after, const Add& add) const
    {
        const std::array<std::pair<int, double>, 3> terms{
            {{before, 1.0}, {node, -2.0}, {after, 1.0}}};
        for (const auto& [a, weight] : terms) {
            for (const auto& [b, other] : terms)
                add(a, b, coefficients_.bending * weight * other);
        }
    }

    const CrimpedBraid& braid_;
    const SpringCoefficients& coefficients_;
    const WallSupport& support_;
    std::vector<double> radii_;
    std::vector<Vec3> nodes_;
    std::vector<double> spring_forces_, forces_;
};

/// Newton's step of the free nodes, 0 of the held ones, and whether the Hessian was positive
/// definite.
struct Step {
    std::vector<double> radii;  ///< |N| change [m]
    bool is_convex = true;
};

Step newton_step(const Shape& shape, double largest)
{
    std::vector<int> place(shape.radii().size(), -1);
    std::vector<double> free_forces;
    for (std::size_t node = 0; node < place.size(); ++node) {
        if (shape.is_held(static_cast<int>(node))) continue;
        place[node] = static_cast<int>(free_forces.size());
        free_forces.push_back(shape.forces()[node]);
    }
    const auto n = static_cast<Eigen::Index>(free_forces.size());
    Step step{.radii = std::vector<double>(place.size(), 0.0)};
    if (n == 0) return step;
    // Ring by ring the matrix is a band as wide as three rings.
    Eigen::SimplicialLLT<Eigen::SparseMatrix<double>, Eigen::Lower, Eigen::NaturalOrdering<int>>
        factor;
    for (const bool softening : {true, false}) {
        const std::vector<Eigen::Triplet<double>> entries = shape.hessian(place, softening);
        Eigen::SparseMatrix<double> hessian(n, n);
        hessian.setFromTriplets(entries.begin(), entries.end());
        step.is_convex = softening;
        factor.compute(hessian);
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
    shape.update_forces();
    while (rest.iterations < max_iterations) {
        rest.residual = residual_of(shape);
        const Step step = newton_step(shape, longest_step * braid.lattice.nominal_radius);
        rest.is_at_rest = rest.residual <= tolerance && step.is_convex;
        if (rest.is_at_rest) break;
        move_along(shape, step.radii, braid.radius);
        shape.update_forces();
        ++rest.iterations;
    }
    rest.residual = residual_of(shape);
    rest.radii = shape.radii();
    rest.spring_forces = shape.spring_forces();
    return rest;
}

}  // namespace braidzone
