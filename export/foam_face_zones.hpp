#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace braidzone {

/// A named set of faces of an OpenFOAM mesh, each with a side.
struct FoamFaceZone {
    std::string name;
    std::vector<int> faces;
    std::vector<int> flipped;  ///< 1 where the zone's normal is opposite to the face's
};

/// Reads constant/polyMesh/faceZones (ASCII or binary, plain or gzipped); empty if there is none.
/// @throws IoError or InputError if it cannot be read
std::vector<FoamFaceZone> read_face_zones(const std::filesystem::path& foam_case);

/// Writes constant/polyMesh/faceZones in ASCII, in place of a plain or gzipped one.
/// @throws IoError if it cannot be written
void write_face_zones(const std::filesystem::path& foam_case,
                      const std::vector<FoamFaceZone>& zones);

}  // namespace braidzone
