#pragma once

#include "deploy/deployment.hpp"

#include <optional>

namespace braidzone {

/// Figures of a deployment (Zavodszky et al. 2020, Table 3, and more). "Neck" are the rings with at
/// least one node that is free of the wall by more than `neck_gap` and their free nodes; those
/// figures are absent if there are none.
struct DeploymentMeasures {
    double implanted_length = 0.0;       ///< between the end rings, along the centerline [m]
    double resting_length = 0.0;         ///< force-free at nominal diameter [m]
    double foreshortening = 0.0;         ///< 1 - implanted / length in the catheter [-]
    double mean_radial_expansion = 0.0;  ///< distance to the ring's centre of mass [m]
    std::optional<double> mean_radial_expansion_neck;  ///< [m]
    double mean_contact_pressure = 0.0;    ///< all contact force over the area in contact [Pa]
    double max_contact_pressure = 0.0;     ///< [Pa]
    double radial_force_per_length = 0.0;  ///< all contact force over the implanted length [N/m]
    double contact_area_fraction = 0.0;    ///< area in contact over the device's area [-]
    double malapposed_area = 0.0;          ///< area free of the wall by more than neck_gap [m^2]
    double device_area = 0.0;              ///< [m^2]
    int inverted_rhombi = 0;
    int nodes_outside_vessel = 0;
};

/// Area of the deployed surface that each node stands for: a quarter of each rhombus around it
/// [m^2]. They sum to the device's area.
std::vector<double> node_areas(const BraidLattice& lattice, const std::vector<Vec3>& nodes);

/// Distance of each node to the centre of mass of its ring [m].
std::vector<double> radial_expansion(const Deployment& deployment);

/// Rhombi whose normal is turned against that of the ring's outward direction there.
std::vector<int> inverted_rhombi(const Deployment& deployment);

/// For each node, 1 if it is one of the neck's: free of the wall by more than `neck_gap`.
std::vector<char> is_free_of_wall(const Deployment& deployment, double neck_gap);

/// All figures of a deployment.
/// @param neck_gap  distance from the wall above which the device is free of it [m]
DeploymentMeasures measure(const Deployment& deployment, const FlowDiverter& device,
                           const WallTree& wall, double neck_gap);

}  // namespace braidzone
