#pragma once

#include <string>

namespace braidzone {

/// A value over a part of the mesh that OpenFOAM reports at every iteration or time step.
struct FoamValue {
    std::string name;       ///< of the function object
    std::string type;       ///< "volFieldValue" or "surfaceFieldValue"
    std::string region;     ///< "cellZone", "faceZone" or "patch"
    std::string part;       ///< name of that
    std::string operation;  ///< "volAverage", "areaAverage", "sum", "sumMag"
    std::string field;
};

/// The function object as an entry of `functions` in controlDict.
std::string value_function(const FoamValue& value);

}  // namespace braidzone
