#pragma once

#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <string>

namespace braidzone::test {

/// All files of a folder, by their names relative to it, and its folders ("folder").
inline std::map<std::string, std::string> folder_contents(const std::filesystem::path& folder)
{
    std::map<std::string, std::string> all;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
        std::ifstream stream(entry.path(), std::ios::binary);
        all[entry.path().lexically_relative(folder).string()] =
            entry.is_directory() ? "folder"
                                 : std::string(std::istreambuf_iterator<char>(stream), {});
    }
    return all;
}

}  // namespace braidzone::test
