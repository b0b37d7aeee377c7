#pragma once

#include "deploy/deployment.hpp"
#include "deploy/neck.hpp"

#include <optional>
#include <vector>

namespace braidzone {

/// How a part of a device along the vessel lies on the wall.
struct ZoneMeasures {
    double contact_area_fraction = 0.0;    ///< area in contact over the zone's area [-]
    double radial_force_per_length = 0.0;  ///< contact force over the zone's length [N/m]
};

/// Distances from the wall over the malapposed area.
struct GapMeasures {
    double mean = 0.0;           ///< weighted by area [m]
    double percentile_95 = 0.0;  ///< 95 % of the malapposed area are nearer [m]
    double max = 0.0;            ///< [m]
};

/// Figures of a deployment (Zavodszky et al. 2020, Table 3, and more).
///
/// "Neck" is the first of the openings if it is a sac's (`neck_of`): its nodes, or as a zone all
/// rings that have some of them, also on the side where the wall is. The landing zones are the
/// rings distal and proximal of it. Figures of the neck and of the zones are absent without a neck,
/// that of a landing zone also if the neck reaches to that end of the device.
struct DeploymentMeasures {
    double implanted_length = 0.0;       ///< between the end rings, along the centerline [m]
    double resting_length = 0.0;         ///< force-free at nominal diameter [m]
    double foreshortening = 0.0;         ///< 1 - implanted / length in the catheter [-]
    double foreshortening_label = 0.0;   ///< 1 - implanted / length on the label [-]
    double mean_radial_expansion = 0.0;  ///< distance to the ring's centre of mass [m]
    std::optional<double> mean_radial_expansion_neck;  ///< [m]
    double mean_contact_pressure = 0.0;  ///< F / A: all contact force over the area in contact [Pa]
    /// F / A0: the same over the area that the nodes in contact stand for in the force-free device
    /// [Pa]. Push-pull changes it little, as the averages of the paper's Table 3, whereas F / A
    /// grows with the density.
    double mean_contact_pressure_reference = 0.0;
    double max_contact_pressure = 0.0;     ///< F / A [Pa]
    double radial_force_per_length = 0.0;  ///< all contact force over the implanted length [N/m]
    double contact_area_fraction = 0.0;    ///< area in contact over the device's area [-]
    std::optional<ZoneMeasures> distal_landing, neck, proximal_landing;
    /// Area free of the wall by more than `wall_gap` where no sac or branch opens [m^2].
    double malapposed_area = 0.0;
    std::optional<GapMeasures> malapposition_gap;  ///< absent if nothing is malapposed
    std::optional<double> neck_area;               ///< of the device over the neck [m^2]
    std::optional<ArcRange> neck_range;            ///< from its first to its last ring
    double device_area = 0.0;                      ///< [m^2]
    int inverted_rhombi = 0;
    int nodes_outside_vessel = 0;  ///< beyond the wall, as far as a compliant one is displaced
};

/// Area of the deployed surface that each node stands for: a quarter of each rhombus around it
/// [m^2] (of each quadrilateral, on a lattice without stagger). They sum to the device's area.
std::vector<double> node_areas(const BraidLattice& lattice, const std::vector<Vec3>& nodes);

/// Distance of each node to the centre of mass of its ring [m].
std::vector<double> radial_expansion(const Deployment& deployment);

/// Rhombi whose normal is turned against that of the ring's outward direction there.
std::vector<int> inverted_rhombi(const Deployment& deployment);

/// All figures of a deployment.
/// @param wall_gap  distance from the wall above which the device is free of it [m]
/// @param openings  of the vessel behind the device, the neck first
DeploymentMeasures measure(const Deployment& deployment, const FlowDiverter& device,
                           const WallTree& wall, double wall_gap,
                           const std::vector<WallOpening>& openings = {});

}  // namespace braidzone
