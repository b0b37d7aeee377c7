#pragma once

#include "core/length_unit.hpp"
#include "core/vector.hpp"

#include <filesystem>

namespace braidzone {

/// From where a run is looked at.
struct StandardView {
    Vec3 centre = Vec3::Zero();  ///< of the device [m]
    Vec3 along = Vec3::UnitX();  ///< unit, along the device there
    Vec3 towards =
        Vec3::UnitY();        ///< shown upwards: to the neck, if there is one; not along the device
    double size = 0.0;        ///< what is to be seen, from left to right [m]
    bool has_field = false;   ///< field.vti is there
    bool has_second = false;  ///< second_device.vtp is there
};

/// Writes `view.py`, a script for ParaView 5.10 or later that shows the files beside it: the vessel
/// translucent, the device coloured by metal coverage and, beside that, a slice of the field along
/// the device with its Darcy coefficient.
/// @throws IoError if the file cannot be written
void write_paraview_view(const std::filesystem::path& path, const StandardView& view,
                         const LengthUnit& unit);

}  // namespace braidzone
