#pragma once

#include <string>

namespace braidzone {

/// The shell script that meshes, applies the device and solves.
/// @param program    command or path of Braidzone; the environment variable BRAIDZONE wins over it
/// @param case_file  path of the case file, relative to the OpenFOAM case or absolute
std::string allrun_script(const std::string& program, const std::string& case_file);

/// The shell script that removes what Allrun made.
std::string allclean_script();

/// The folder's README.
std::string foam_readme();

}  // namespace braidzone
