#pragma once

#include "core/centerline.hpp"
#include "deploy/node_contact.hpp"
#include "deploy/wire_network.hpp"

#include <functional>
#include <vector>

namespace braidzone {

/// What holds a ring apart from its wires and the wall.
struct RingGuide {
    CrossSection section;   ///< of the vessel at the ring; its tangent is the ring's axis
    bool crimped = false;   ///< in the catheter: held at the catheter's radius about the origin
    bool in_plane = false;  ///< nodes do not move along the tangent
    bool held = false;      ///< the ring's mean does not leave the plane of the section
};

struct RelaxationOptions {
    double guide_radius = 0.0;     ///< of crimped rings [m]
    double guide_stiffness = 0.0;  ///< of the catheter, and of the hold on a ring [N/m]
    /// Stiffness that holds every node to where it was before the iteration [N/m]: it makes the
    /// matrix positive definite where nothing else does, and does not change the state of rest.
    double proximal_stiffness = 0.0;
    double largest_step = 0.0;  ///< that a node takes in an iteration [m]
    bool couple_hubs = false;   ///< rings travel as a whole, see `hub_coupling.hpp`
    int contact_attempts = 5;   ///< solutions in one iteration with another set of contacts
};

/// Brings a wire network to rest in contact with obstacles: Newton's method on the sum of the
/// energies of the wires (`wire_network.hpp`), the contacts (`node_contact.hpp`) and the guides,
/// with positive definite second derivatives and a halving of steps that do not lower the energy.
/// Quasi-static: there is neither mass nor time.
class NetworkRelaxation {
public:
    NetworkRelaxation(const WireNetwork& network, NetworkShape shape, ContactLaw contact_law,
                      std::vector<Obstacle> obstacles, const RelaxationOptions& options);

    const NetworkShape& shape() const { return shape_; }
    NetworkShape& shape() { return shape_; }
    std::vector<RingGuide>& guides() { return guides_; }
    ContactLaw& contact_law() { return law_; }
    RelaxationOptions& options() { return options_; }

    /// One iteration over the nodes of a stretch; all others stay.
    /// @return the largest force on a node of the stretch before the step [N]
    double iterate(RingRange active);

    /// Iterates until no force on a node is larger than a tolerance.
    ///
    /// Rings at the stretch's end move, as many as `window` says; if forces reach further, the
    /// window is doubled. Its final size is left there, to begin with the next time.
    /// @param after_iteration  called with the rings that moved, to let their guides follow
    /// @return the largest force on a node of the stretch [N]
    double relax(RingRange stretch, int& window, double tolerance, int most_iterations,
                 const std::function<void(RingRange)>& after_iteration);

    /// Iterations so far.
    int num_iterations() const { return num_iterations_; }

    /// Anchors the nodes that touch, and lets those that slide take their anchors along: to be
    /// called at rest, between one change of the guides and the next.
    void settle_contacts(RingRange active);

    /// Largest force on a node of each ring, as of the last iteration that included it [N].
    const std::vector<double>& ring_residuals() const { return ring_residuals_; }

    /// With which each node presses on the obstacles [N].
    double normal_force(int node) const
    {
        return contacts_[static_cast<std::size_t>(node)].normal_force.norm();
    }

private:
    double record_residuals(RingRange active, const std::vector<Vec3>& gradient);
    std::vector<Vec3> newton_step(RingRange active, const std::vector<Vec3>& gradient,
                                  const RingBandMatrix& hessian);
    bool find_contacts_of_step(RingRange active, const std::vector<Vec3>& step);
    void stop_at_obstacles(RingRange active, const std::vector<Vec3>& start);
    double energy(RingRange active) const;
    double guide_energy(RingRange active) const;
    void add_guides(RingRange active, std::vector<Vec3>& gradient, RingBandMatrix& hessian) const;
    void update_contacts(RingRange active);
    void limit_to_plane(RingRange active, std::vector<Vec3>& vectors) const;

    RingBandMatrix& hessian_of(RingRange active);
    double residual_before(RingRange stretch, int first) const;

    const WireNetwork& network_;
    NetworkShape shape_;
    ContactLaw law_;
    std::vector<Obstacle> obstacles_;
    RelaxationOptions options_;
    std::vector<RingGuide> guides_;
    std::vector<NodeContact> contacts_;  ///< one a node
    std::vector<double> clearances_;     ///< of each node when it was measured last [m]
    std::vector<Vec3> cleared_;          ///< and where that was [m]
    std::vector<double> ring_residuals_;
    int num_iterations_ = 0;
    RingBandMatrix hessian_;
    RingBandMatrix factor_;
};

}  // namespace braidzone
