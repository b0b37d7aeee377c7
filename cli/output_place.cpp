#include "cli/output_place.hpp"

#include "core/error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>

namespace braidzone {
namespace {

namespace fs = std::filesystem;

bool is_same(const fs::path& a, const fs::path& b)
{
    std::error_code error;
    return fs::equivalent(a, b, error) && !error;
}

/// True if a path, as it is written, leads into or through the folder.
bool leads_through(const fs::path& path, const fs::path& folder)
{
    for (fs::path place = path;; place = place.parent_path()) {
        if (is_same(place, folder)) return true;
        if (place == place.parent_path()) return false;
    }
}

/// A link in the folder is lost with it, and so is what a link elsewhere leads to in it.
bool is_within(const fs::path& path, const fs::path& folder)
{
    std::error_code error;
    const fs::path absolute = fs::absolute(path, error);
    const fs::path followed = fs::weakly_canonical(path, error);
    return leads_through(absolute.lexically_normal(), folder) ||
           (!followed.empty() && leads_through(followed, folder));
}

std::vector<InputFile> with_folders_in_use(std::vector<InputFile> inputs)
{
    std::error_code error;
    const fs::path current = fs::current_path(error);
    if (!current.empty()) inputs.push_back({"current folder", current});
    const char* home = std::getenv("HOME");
    if (home != nullptr && *home != '\0') inputs.push_back({"home folder", home});
    return inputs;
}

/// "loss_table" as "loss table".
std::string in_words(std::string role)
{
    std::replace(role.begin(), role.end(), '_', ' ');
    return role;
}

}  // namespace

void require_holds_no_input(const fs::path& folder, const std::vector<InputFile>& inputs)
{
    if (!fs::exists(folder)) return;
    for (const InputFile& input : with_folders_in_use(inputs)) {
        if (!is_within(input.path, folder)) continue;
        throw ConfigError(fmt::format(
            "output folder {} is or holds the {} {}, which would be deleted with it; choose "
            "another with --output (--force does not change this)",
            folder.string(), in_words(input.role), input.path.string()));
    }
}

void require_no_input(const fs::path& file, const std::vector<InputFile>& inputs)
{
    for (const InputFile& input : inputs) {
        if (!is_same(file, input.path)) continue;
        throw ConfigError(
            fmt::format("output {} is the {} {}; choose another with --output (--force does not "
                        "change this)",
                        file.string(), in_words(input.role), input.path.string()));
    }
}

}  // namespace braidzone
