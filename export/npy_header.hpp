#pragma once

#include <string>

namespace braidzone {

/// Which index of an array runs fastest in the file.
enum class NpyOrder { first_fastest, last_fastest };

/// Header of a NumPy array (numpy.lib.format, version 1.0), padded to a multiple of 64 bytes.
/// @param type   little endian, e.g. "<f4"
/// @param shape  lengths with commas between, e.g. "3, 4, 5"; for one dimension "3,"
std::string npy_header(const std::string& type, const std::string& shape, NpyOrder order);

}  // namespace braidzone
