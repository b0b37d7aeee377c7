#pragma once

#include "core/toml_reader.hpp"
#include "core/vector.hpp"
#include "deploy/deploy_options.hpp"
#include "deploy/neck.hpp"
#include "deploy/release_schedule.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <variant>

namespace braidzone {

/// A place along the vessel: an arc length of the centerline [m], or a point [m], which stands for
/// the nearest arc length.
using PlaceOnCenterline = std::variant<double, Vec3>;

/// What a case file's [deployment] says.
struct DeploymentKeys {
    PlaceOnCenterline landing_distal = 0.0;
    ReleaseSchedule schedule;
    DeployOptions options;
    std::optional<ArcRange> neck;  ///< found if absent
};

/// Reads a place along the vessel: a length or a point.
PlaceOnCenterline read_place(const TomlTable& table, const std::string& key);

/// Reads how the rings of a device are spaced at release: `push_pull` and what else a section
/// says about it.
ReleaseSchedule read_schedule(const TomlTable& table);

/// Reads [deployment].
/// @throws ConfigError, with file, line and key, for a value of the wrong type or unit or out of
///         range, and for friction where nothing can slide
DeploymentKeys read_deployment_keys(const TomlTable& table);

// Names in the case file.
std::string_view name_of(LatticeKind lattice);  ///< "crossings", "paper-2020"
std::string_view name_of(AxialMotion axial);    ///< "locked", "free"
std::string_view name_of(ReleaseOrder order);   ///< "ring_by_ring", "at_once"
std::string_view name_of(Motion motion);        ///< "inertial", "quasi_static"
std::string_view name_of(DeviceEnd end);        ///< "distal", "proximal"

/// The two ends of a switch that has values in between: by name for 0 and 1, by number else.
struct SwitchKeys {
    std::string_view name_key, off, on;  ///< "release": "nominal", "force_free"
    std::string_view share_key;          ///< "sliding", 0 to 1
};
constexpr SwitchKeys sliding_keys{"release", "nominal", "force_free", "sliding"};
constexpr SwitchKeys hub_freedom_keys{"ring_hub", "fixed", "free", "hub_freedom"};

}  // namespace braidzone
