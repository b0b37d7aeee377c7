#pragma once

#include <map>
#include <string>

namespace braidzone {

/// Versions of the program, the compiler and the libraries that results depend on.
std::map<std::string, std::string> library_versions();

}  // namespace braidzone
