#pragma once

#include "export/lattice_targets.hpp"

#include <string>

namespace braidzone {

/// The README of a target's folder: what the files hold, how the program is called with them, and
/// what it leaves out.
std::string lattice_readme(LatticeTarget target);

}  // namespace braidzone
