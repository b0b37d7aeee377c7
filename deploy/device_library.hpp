#pragma once

#include "core/toml_reader.hpp"
#include "deploy/flow_diverter.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace braidzone {

/// How far a value of the library can be relied on.
enum class Confidence { high, medium, low };

/// A value with its origin, for display.
struct SourcedValue {
    std::string name;    ///< key in the device file
    std::string value;   ///< as text, with unit
    std::string source;  ///< where it comes from
    Confidence confidence = Confidence::low;
};

/// One device of the library: a product in all its sizes.
struct DeviceModel {
    std::string name;                        ///< "pipeline-flex"
    std::string title;                       ///< "Pipeline Flex Embolization Device (Medtronic)"
    std::vector<double> nominal_diameters;   ///< [m]
    std::vector<double> nominal_lengths;     ///< [m]
    bool complete = false;                   ///< every value that a deployment needs is known
    std::vector<ForceSource> force_sources;  ///< for which the forces' values are known too
    std::vector<std::string> missing;        ///< keys that are not known for any source of forces
    std::vector<SourcedValue> values;
    std::filesystem::path file;
};

/// The devices of the library, by name: the project's `deploy/devices` and, if set, the folders in
/// the environment variable BRAIDZONE_DEVICES (separated by ':'), which win over the project's.
/// @throws ConfigError for a file that is not a device; IoError if a folder cannot be read
std::vector<DeviceModel> device_library();

/// The flow diverter that a case file's [device] section describes: `name` (optional), `diameter`,
/// `length`, and any of `num_wires`, `wire_diameter`, `braid_ratio` or in its place
/// `nominal_porosity` (`braid_ratio_at_porosity`), `catheter_diameter`, `surface_coefficient`,
/// `radial_coefficient`, `reference_node_area`, `force_scale`, `youngs_modulus`, `poisson_ratio`,
/// `distal_flare`, `proximal_flare`, `flare_length`, each of which overrides the library.
///
/// `forces = "springs"` or `"wire-theory"` says where the forces come from. Without it they come
/// from springs if the section or the library knows any of the springs' values, else from wire
/// theory.
///
/// Between the diameters that a device file states, a value goes on as the file says: Pipeline's
/// braid ratio by the fit t(D) = 0.160 + 0.957 mm / D, its coefficients on the straight line
/// through the two nearest sizes, numbers of wires by steps.
///
/// A name that the library does not hold is a mere label if the section gives every value.
///
/// @param notes  receives a sentence for each value that is extrapolated or of low confidence
/// @throws ConfigError for an unknown device (with the nearest name), a size that is not made (with
///         the sizes that are, unless `any_size = true`), and what `validate` refuses
FlowDiverter read_device(const TomlTable& section, std::vector<std::string>& notes);

}  // namespace braidzone
