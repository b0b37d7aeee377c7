#pragma once

#include <optional>
#include <string>

namespace braidzone {

/// A braided flow diverter of one size, ready to be deployed.
///
/// Angles of the braid are measured from the circumference; `braid_ratio` is the tangent of that
/// angle in the force-free device at nominal diameter (dL/dR in Zavodszky et al. 2020, Table 1).
struct FlowDiverter {
    std::string name;                    ///< of the device, e.g. "pipeline-flex"
    int num_wires = 48;                  ///< both families together; even
    double wire_diameter = 30e-6;        ///< [m]
    double nominal_diameter = 0.0;       ///< force-free diameter of the wires' mid-surface [m]
    double nominal_length = 0.0;         ///< force-free length at nominal diameter [m]
    double braid_ratio = 0.0;            ///< t, tangent of the braid angle [-]
    double catheter_diameter = 0.69e-3;  ///< inner diameter of the microcatheter [m]

    /// Coefficients of the springs on the reference lattice (Zavodszky et al. 2020, Table 2):
    /// `surface_coefficient` for each arm, `radial_coefficient` for each node's radial spring when
    /// the node stands for `reference_node_area`.
    double surface_coefficient = 0.0;  ///< c_surface [N/m]
    double radial_coefficient = 0.0;   ///< c_radial [N/m]
    double reference_node_area = 0.0;  ///< [m^2]
    /// Factor from the coefficients' forces to the forces of the real device [-].
    double force_scale = 1.0;

    double nominal_radius() const { return 0.5 * nominal_diameter; }
};

/// A value that does not describe a braid: its key in the case file's [device] and what is wrong.
struct InvalidValue {
    std::string key;      ///< "wire_diameter"
    std::string finding;  ///< "= 1200 um exceeds device.diameter / 10 = 400 um"
};

/// The first value that does not describe a braid, if any: an odd number of wires or fewer than 8,
/// values that are not positive and finite, wires thicker than a tenth of the diameter or than
/// their spacing, a catheter that is not narrower than the device.
std::optional<InvalidValue> find_invalid(const FlowDiverter& device);

/// Checks that the values describe a braid.
/// @throws ConfigError with what `find_invalid` finds
void validate(const FlowDiverter& device);

}  // namespace braidzone
