#pragma once

#include "deploy/crimped_braid.hpp"
#include "deploy/deploy_options.hpp"
#include "deploy/equation_of_motion.hpp"
#include "deploy/spring_forces.hpp"
#include "deploy/wall_contact.hpp"

#include <vector>

namespace braidzone {

/// A braid whose rings are locked in their planes, in motion: released rings move, the others wait
/// at the catheter's radius. A node moves along its ray.
///
///     m r'' = f_springs + f_bending + f_wall - k r'
///
/// Every force is the component along the node's ray. A rigid wall and jammed wires hold the node
/// at its stop; a compliant wall pushes back with f_wall = -K (r - wall) beyond it, and never
/// pulls.
///
/// A hub of freedom h > 0 is two more coordinates u in the plane of its ring. It feels the opposite
/// of its radial springs' forces and that of a spring which ties it to its place,
///
///     f_hub = - sum over the ring's nodes of q f(r) e_r  -  K u,   K = n c_radial (1 - h) / h
///
/// At h = 1 it is free; towards h = 0 it moves in proportion to h. K stands for what carries a ring
/// beside its own springs: the rings before and behind it, and the delivery wire. Mass and damping
/// of the hub are those of the ring's n nodes over h, so that it is no faster than a radial spring,
/// whatever h. Nodes stay on their rays from the original hub.
///
/// Quasi-static motion drops the inertia: a node moves by mobility times force, the mobility being
/// `time_step_ratio` times the largest that is stable, 2 / omega_max^2 at unit mass.
class OpeningBraid {
public:
    /// @param coefficients  in the units of the paper's code, see `spring_coefficients`
    OpeningBraid(const CrimpedBraid& braid, const SpringCoefficients& coefficients,
                 const WallSupport& support, const DeployOptions& options);

    void release_next_ring();
    bool all_released() const { return num_released_ == lattice_.num_rings; }
    int num_released() const { return num_released_; }

    /// One time step of all released nodes that are not at rest.
    void step();
    /// Brings the forces up to the shape after the last step.
    void update_all_forces();

    /// Largest force on a released node that is free to move, inward force on one that the wall no
    /// longer holds, or force on a free hub, in the units of the coefficients, counting the kinetic
    /// energy that is still in it: a node of speed v swings up to the force v sqrt(m c_radial).
    double largest_residual() const;

    /// Energy of springs, bent wires and compliant wall, in the units of the coefficients.
    double elastic_energy() const;
    /// Energy of the motion of the last step, m v^2 / 2; 0 if quasi-static.
    double kinetic_energy() const;

    /// Distance of each node to its hub, the original one, along its ray [m].
    const std::vector<double>& radii() const { return radii_; }
    const std::vector<Vec3>& nodes() const { return nodes_; }
    /// Cross-sections of the rings with the hubs where they are now.
    const std::vector<CrossSection>& rings() const { return rings_; }
    /// Radial force of each node's springs, outwards; without the bending of the wires, as of the
    /// start of the last step or the last update.
    const std::vector<double>& spring_forces() const { return spring_forces_; }
    /// How far each node has pushed a compliant wall outwards [m].
    std::vector<double> wall_displacements() const;

private:
    struct Place {
        int ring = 0;
        int column = 0;
    };

    static std::size_t index(int i) { return static_cast<std::size_t>(i); }
    std::size_t index(Place place) const { return index(lattice_.node(place.ring, place.column)); }

    void mark_ring_stale(int ring);
    void mark_neighbours_stale(Place place);
    void take_stale_nodes();
    double residual_of(std::size_t node) const;
    double wall_force(std::size_t node) const;
    void update_force(Place place);
    void update_hub_forces();
    void move(Place place);
    void move_hub(int ring);
    bool hubs_move() const { return hub_freedom_ > 0.0; }
    double hub_mass_ratio() const { return lattice_.nodes_per_ring / hub_freedom_; }
    Vec3 hub_way(int ring) const;
    double next(double last_displacement, double force, double relative_mass) const;

    const CrimpedBraid& braid_;
    const BraidLattice& lattice_;
    SpringCoefficients coefficients_;
    WallSupport support_;
    Motion motion_;
    double hub_freedom_;
    VerletScheme scheme_;         ///< of a node
    double mobility_ = 0.0;       ///< displacement over force of a quasi-static step [m/N]
    double hub_stiffness_ = 0.0;  ///< K [N/m]
    std::vector<CrossSection> rings_;
    std::vector<double> radii_;
    std::vector<Vec3> nodes_;            ///< [m]
    std::vector<double> displacements_;  ///< along the ray in the last step [m]
    std::vector<double> spring_forces_;
    std::vector<double> forces_;  ///< of springs, bending and wall
    std::vector<char> held_;      ///< 1 for a node at its stop
    std::vector<Vec3> hub_displacements_;
    std::vector<Vec3> hub_forces_;
    double stillness_ = 0.0;        ///< residual below which a node stays where it is [N]
    double force_per_swing_ = 0.0;  ///< sqrt(m c_radial) / time step; 0 if quasi-static [N/m]
    /// 1 for a released node whose force must be computed anew: it or one that its force depends on
    /// moved in the last step. About all others nothing has changed, so that the cost is that of
    /// the opening front and of the nodes that have not come to rest.
    std::vector<char> is_stale_;
    std::vector<char> has_stale_;  ///< 1 for a ring with such a node
    std::vector<Place> moving_;    ///< the nodes of the step under way, in the order of the lattice
    int num_released_ = 0;
};

}  // namespace braidzone
