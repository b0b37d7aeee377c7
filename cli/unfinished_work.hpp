#pragma once

#include "discrepancy/residual_memory.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace braidzone {

/// The simulations that an interrupted diagnosis made, in a hidden file beside its results,
/// ".<name of the results>.simulations": read if case, measurement, options and program are the
/// same, else begun anew. `ResidualMemory::forget` it when the results are in their place.
/// @param results  the folder or file that will hold them
/// @param inputs   all that the simulations depend on but for the program, such as hashes of files
ResidualMemory unfinished_simulations(const std::filesystem::path& results,
                                      const std::vector<std::string>& inputs);

/// "trying effects", or, where simulations are there, how many.
std::string doing_with(const std::string& doing, const ResidualMemory& memory);

}  // namespace braidzone
