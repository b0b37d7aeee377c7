// The order of the modules, and what public headers may show.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <regex>
#include <string>
#include <string_view>
#include <vector>

namespace {

namespace fs = std::filesystem;

/// Each module may include itself and those before it.
constexpr std::array<std::string_view, 6> modules = {"core",   "deploy",      "porous",
                                                     "export", "discrepancy", "cli"};

/// Except this one, which stands beside the other: it writes no files of solvers.
constexpr std::string_view beside_export = "discrepancy";

/// Libraries that public headers must not show.
constexpr std::array<std::string_view, 5> hidden_libraries = {"CGAL/", "vtk", "openvdb/", "toml++/",
                                                              "CLI/"};

struct Include {
    std::string file;
    std::string included;
};

std::vector<Include> includes_in(const fs::path& file)
{
    static const std::regex pattern(R"re(^\s*#\s*include\s*[<"]([^>"]+)[>"])re");
    std::vector<Include> includes;
    std::ifstream text(file);
    for (std::string line; std::getline(text, line);) {
        std::smatch match;
        if (std::regex_search(line, match, pattern)) includes.push_back({file.string(), match[1]});
    }
    return includes;
}

std::vector<Include> includes_of(std::string_view module, std::string_view ending)
{
    std::vector<Include> all;
    for (const auto& entry :
         fs::recursive_directory_iterator(fs::path(BRAIDZONE_SOURCE_DIR) / module)) {
        if (!entry.path().string().ends_with(ending)) continue;
        const auto includes = includes_in(entry.path());
        all.insert(all.end(), includes.begin(), includes.end());
    }
    return all;
}

/// Includes of later modules, or of the one beside.
std::vector<std::string> against_the_order(std::size_t module, const std::vector<Include>& includes)
{
    std::vector<std::string> found;
    for (const Include& include : includes) {
        for (std::size_t other = 0; other < modules.size(); ++other) {
            const bool is_beside = modules[module] == beside_export && modules[other] == "export";
            if ((other > module || is_beside) &&
                include.included.starts_with(std::string(modules[other]) + "/")) {
                found.push_back(include.file + " includes " + include.included);
            }
        }
    }
    return found;
}

std::vector<std::string> hidden_in(const std::vector<Include>& includes)
{
    std::vector<std::string> found;
    for (const Include& include : includes) {
        for (const std::string_view library : hidden_libraries) {
            if (include.included.starts_with(library)) {
                found.push_back(include.file + " includes " + include.included);
            }
        }
    }
    return found;
}

TEST(Includes, FollowTheOrderOfTheModules)
{
    for (std::size_t module = 0; module < modules.size(); ++module) {
        const auto includes = includes_of(modules[module], "pp");
        EXPECT_GT(includes.size(), 10u) << modules[module] << " was not found";
        const auto found = against_the_order(module, includes);
        EXPECT_TRUE(found.empty()) << found.front();
    }
}

TEST(Includes, KeepTheLibrariesOutOfPublicHeaders)
{
    for (const std::string_view module : modules) {
        const auto found = hidden_in(includes_of(module, ".hpp"));
        EXPECT_TRUE(found.empty()) << found.front();
    }
}

TEST(Includes, AreSeenByTheseTests)
{
    const auto includes = includes_of("porous", ".cpp");
    EXPECT_TRUE(std::any_of(includes.begin(), includes.end(), [](const Include& include) {
        return include.included == "porous/rhombus.hpp";
    }));
    EXPECT_EQ(against_the_order(0, {{"core/x.hpp", "deploy/braid_lattice.hpp"}}).size(), 1u);
    EXPECT_TRUE(against_the_order(1, {{"deploy/x.hpp", "core/vessel.hpp"}}).empty());
    EXPECT_EQ(against_the_order(4, {{"discrepancy/x.hpp", "export/canvas.hpp"}}).size(), 1u);
    EXPECT_TRUE(against_the_order(4, {{"discrepancy/x.hpp", "deploy/neck.hpp"}}).empty());
    EXPECT_EQ(hidden_in({{"core/x.hpp", "vtkPolyData.h"}, {"core/x.hpp", "vector"}}).size(), 1u);
}

}  // namespace
