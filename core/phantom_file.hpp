#pragma once

#include "core/phantom.hpp"
#include "core/toml_reader.hpp"

namespace braidzone {

/// The parameters of an idealised vessel from a TOML file.
///
///     [vessel]
///     proximal_radius = "1.95 mm"
///     distal_radius = "1.85 mm"    # default: as proximal
///     ovality = 0.8                # smaller over larger half axis; default 1: round
///     oval_direction = "30 deg"    # of the larger half axis, from the normal; default 0
///     edge_length = "0.4 mm"       # default 0.4 mm
///     blend_radius = "0.3 mm"      # default 0.3 mm
///     [[segment]]                  # one or more, proximal end first
///     length = "10 mm"
///     angle = "60 deg"             # default 0: straight
///     plane_angle = "0 deg"        # default 0
///     [[sac]]
///     position = "14 mm"           # absent: at the apex of the bifurcation
///     direction = "180 deg"        # default 0
///     diameter = "7 mm"
///     height = "7 mm"              # default: as diameter
///     neck = "4.5 mm"
///     edge_length = "0.8 mm"       # default: the vessel's
///     [[branch]]
///     position = "6 mm"
///     direction = "90 deg"         # default 0
///     tilt = "60 deg"              # default 60 degrees
///     radius = "0.8 mm"
///     length = "8 mm"
///     [bifurcation]
///     radius = "1.4 mm"
///     length = "10 mm"
///     half_angle = "45 deg"        # default 45 degrees
///
/// @throws ConfigError if a key is missing or unknown, or a value has no or another unit
Phantom read_phantom(const TomlTable& file);

}  // namespace braidzone
