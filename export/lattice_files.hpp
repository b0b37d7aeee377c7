#pragma once

#include <array>
#include <string>
#include <vector>

namespace braidzone {

/// A file of a lattice's folder, as lattice.json lists it.
struct LatticeFile {
    std::string name;
    std::string type;        ///< of its numbers, little endian, or what it is
    std::vector<int> shape;  ///< in the order of its indices; empty if it is no array
    std::string order;       ///< which index runs fastest; empty if it is no array
};

inline std::vector<int> shape_of(const std::array<int, 3>& dims)
{
    return {dims.begin(), dims.end()};
}

}  // namespace braidzone
