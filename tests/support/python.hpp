#pragma once

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

namespace braidzone::test {

/// What a script prints in Debian's Python, run in a folder.
inline std::string printed_by_python(const std::filesystem::path& folder, const std::string& script)
{
    std::ofstream(folder / "script.py") << script;
    const std::string command =
        "cd '" + folder.string() + "' && /usr/bin/python3 script.py > printed";
    EXPECT_EQ(std::system(command.c_str()), 0) << script;
    std::ostringstream text;
    text << std::ifstream(folder / "printed", std::ios::binary).rdbuf();
    return std::move(text).str();
}

}  // namespace braidzone::test
