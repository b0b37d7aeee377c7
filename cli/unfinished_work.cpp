#include "cli/unfinished_work.hpp"

#include "cli/summary.hpp"
#include "core/file_hash.hpp"

#include <fmt/format.h>

namespace braidzone {

ResidualMemory unfinished_simulations(const std::filesystem::path& results,
                                      const std::vector<std::string>& inputs)
{
    // The program's own file: another build may simulate otherwise.
    std::string key = std::string(program_name) + sha256_of_file("/proc/self/exe");
    for (const std::string& input : inputs)
        key += fmt::format("\n{} {}", input.size(), input);
    const std::filesystem::path file =
        results.parent_path() / fmt::format(".{}.simulations", results.filename().string());
    return {file, sha256_of_text(key)};
}

std::string doing_with(const std::string& doing, const ResidualMemory& memory)
{
    if (memory.num_found() == 0) return doing;
    return fmt::format("{}; {} simulations of an interrupted run are there", doing,
                       memory.num_found());
}

}  // namespace braidzone
