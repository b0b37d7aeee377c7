#pragma once

#include "core/vector.hpp"

#include <variant>

namespace braidzone {

/// What is to become of an end of the vessel.
enum class OpeningAction {
    keep,  ///< an open rim stays open, hole or not
    cap,   ///< an open rim is closed by a flat cap: no blood enters or leaves there
    cut,   ///< the vessel is cut across at a point, what lies beyond is taken off
};

/// An order about one end of a vessel.
struct OpeningOrder {
    /// The number of an opening or of a rounded end, as they are without any order: openings by
    /// area from 0, then rounded ends; or a point there [m].
    std::variant<int, Vec3> at = 0;
    OpeningAction action = OpeningAction::keep;
};

}  // namespace braidzone
