#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace braidzone {

/// Where the forces of a device come from: coefficients of springs fitted to a bench test, or the
/// bending and torsion of its wires (`wire_theory.hpp`).
enum class ForceSource { springs, wire_theory };

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

    ForceSource forces = ForceSource::springs;

    /// Coefficients of the springs on the reference lattice (Zavodszky et al. 2020, Table 2):
    /// `surface_coefficient` for each arm, `radial_coefficient` for each node's radial spring when
    /// the node stands for `reference_node_area`. All 0: a device that is known by its wires only.
    double surface_coefficient = 0.0;  ///< c_surface [N/m]
    double radial_coefficient = 0.0;   ///< c_radial [N/m]
    double reference_node_area = 0.0;  ///< [m^2]
    /// Factor from the coefficients' forces to the forces of the real device [-]. Wire theory has
    /// its own, see `spring_coefficients`.
    double force_scale = 1.0;

    /// Moduli of the wires' material, for wire theory. Wires of several materials count with the
    /// mean of their moduli, a wire with a core with that of its bending stiffness.
    double youngs_modulus = 0.0;  ///< E [Pa]
    double poisson_ratio = 0.3;   ///< nu [-]; 0.3 holds for metals

    /// Change of the force-free radius at each end [m]: positive for a flare, negative for a cone.
    double distal_flare = 0.0;
    double proximal_flare = 0.0;
    double flare_length = 1e-3;  ///< over which it grows, in nominal length [m]

    double nominal_radius() const { return 0.5 * nominal_diameter; }
};

/// A value that does not describe a braid: its key in the case file's [device] and what is wrong.
struct InvalidValue {
    std::string key;      ///< "wire_diameter"
    std::string finding;  ///< "= 1200 um exceeds device.diameter / 10 = 400 um"
};

/// The first value that does not describe a braid, if any: an odd number of wires or fewer than 8,
/// values that are not positive and finite, wires thicker than a tenth of the diameter or than
/// their spacing, a catheter that is not narrower than the device, a flare beyond what the braid
/// allows. The springs' values need to hold only where the forces come from springs, those of the
/// wires' material where they come from wire theory.
std::optional<InvalidValue> find_invalid(const FlowDiverter& device);

/// Checks that the values describe a braid.
/// @throws ConfigError with what `find_invalid` finds
void validate(const FlowDiverter& device);

/// Braid ratio at which the force-free device covers what a surface porosity leaves [-]. With f the
/// share of the surface under the wires of one family, which cover it independently of the other:
///
///     surface_porosity = (1 - f)^2,   f = n d / (2 pi D sin b),   t = tan b
///
/// @param device            its wires and nominal diameter count
/// @param surface_porosity  [-]; 0 to 1
/// @throws ConfigError if it is not between 0 and 1, or so large that not even wires along the axis
///         (b = 90 degrees) would leave it
double braid_ratio_at_porosity(const FlowDiverter& device, double surface_porosity);

/// Name of a force source in case files: "springs" or "wire-theory".
std::string_view force_source_name(ForceSource source);

/// One sentence on where the device's forces come from and with which figures, for reports.
std::string force_origin(const FlowDiverter& device);

}  // namespace braidzone
