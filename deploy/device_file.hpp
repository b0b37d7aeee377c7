#pragma once

#include "core/quantity.hpp"
#include "deploy/device_library.hpp"

#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace braidzone {

/// What a value of a device is for.
enum class ParameterUse {
    geometry,  ///< needed by every deployment
    porosity,  ///< may stand for the braid ratio
    springs,   ///< needed where the forces come from springs
    wires,     ///< needed where they come from wire theory
    optional   ///< has a default
};

/// A value that describes a device, under its key in device files and in a case's [device].
struct DeviceParameter {
    std::string_view key;
    std::optional<Dimension> dimension;  ///< none: a plain number
    ParameterUse use = ParameterUse::geometry;
    void (*set)(FlowDiverter& device, double si);  ///< puts the value into a device
    std::string_view lowest = {};                  ///< of its range, see `KeyRange`
    std::string_view highest = {};
};

/// The values of a device besides its size, in the order of display; a `set` may count on those
/// before it.
const std::vector<DeviceParameter>& device_parameters();

/// What a deployment lacks if only the parameters for which `is_known` is true are known. The braid
/// ratio may be replaced by the porosity.
std::vector<std::string> missing_for(ForceSource forces,
                                     const std::function<bool(std::string_view)>& is_known);

/// How a value goes on between the nominal diameters for which it is known.
enum class BetweenSizes {
    step,  ///< from each diameter on, up to the next: numbers of wires
    line,  ///< straight line through the two nearest sizes
    fit,   ///< constant + per_diameter / D
};

/// A value of the library as a function of the nominal diameter.
struct SizedValue {
    std::vector<double> diameters;  ///< increasing [m]; empty if one value serves every size
    std::vector<double> values;     ///< SI, one a diameter
    BetweenSizes between = BetweenSizes::line;
    double fit_constant = 0.0;      ///< SI
    double fit_per_diameter = 0.0;  ///< SI times metre
    std::string source;
    Confidence confidence = Confidence::low;
};

/// True if the library states the value at this diameter, false if it follows from other sizes.
bool is_stated_at(const SizedValue& value, double diameter);

/// The value at a nominal diameter [m].
double value_at(const SizedValue& value, double diameter);

/// A device file: what is shown of it and what is computed with.
struct DeviceFile {
    DeviceModel model;
    std::map<std::string, SizedValue, std::less<>> parameters;  ///< by key; known ones only
};

/// Reads a device file: `name`, `title`, and for each value a table with `value`, `source` and
/// `confidence` ("high", "medium", "low"); a value that depends on the size has arrays `value` and
/// `at_diameter`, and optionally `between` ("step" or "line", the default) or
/// `fit = {constant, per_diameter}`.
/// @throws ConfigError if it is no device
DeviceFile read_device_file(const std::filesystem::path& path);

}  // namespace braidzone
