#pragma once

#include "core/key_range.hpp"

namespace braidzone {

// The range of every numeric key of the files that the program takes, declared once
// (`TomlTable::require_ranges`). They are those of any vessel, device, fluid and bench that could
// be meant; what a method allows is narrower in places and refused there.

/// Of a case file.
KeyRanges case_key_ranges();
/// Of a press test's file.
KeyRanges press_key_ranges();
/// Of the file of a bench for the pressure drop.
KeyRanges pressure_key_ranges();

}  // namespace braidzone
