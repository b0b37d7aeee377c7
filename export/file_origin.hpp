#pragma once

#include <string>

namespace braidzone {

/// What a file says about where it comes from.
struct FileOrigin {
    std::string generator = "Braidzone";  ///< program and version
    std::string case_hash;                ///< SHA-256 of the case and its inputs; may be empty
};

}  // namespace braidzone
