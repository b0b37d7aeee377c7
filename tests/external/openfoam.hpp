#pragma once

#include "core/csv_fields.hpp"
#include "export/foam_format.hpp"
#include "export/text_file.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <sstream>
#include <string>
#include <vector>

namespace braidzone::test {

/// True if OpenFOAM's programs can be called. In continuous integration, where `./braidzone test`
/// has just installed them, they are taken to be there: a test without them fails, and is not
/// skipped.
inline bool has_openfoam()
{
    if (std::getenv("CI") != nullptr) return true;
    return std::system("command -v simpleFoam > /dev/null 2>&1") == 0;
}

inline std::string file_text(const std::filesystem::path& file)
{
    std::ifstream stream(file, std::ios::binary);
    EXPECT_TRUE(stream.good()) << file;
    return {std::istreambuf_iterator<char>(stream), {}};
}

/// The table of a function object over a patch in a run without continuations, whatever the time
/// that it started from.
inline std::filesystem::path table_of(const std::filesystem::path& foam_case,
                                      const std::string& function)
{
    const std::filesystem::directory_iterator starts(foam_case / "postProcessing" / function);
    return starts->path() / "surfaceFieldValue.dat";
}

/// Replaces a piece of a file that must be there.
inline void replace_in(const std::filesystem::path& file, const std::string& old_text,
                       const std::string& new_text)
{
    std::string text = file_text(file);
    const auto at = text.find(old_text);
    ASSERT_NE(at, std::string::npos) << old_text << " in " << file;
    text.replace(at, old_text.size(), new_text);
    write_text_file(file, text);
}

/// Runs a shell command in a folder, its output to `log` there; shows the output's end if it fails.
inline bool run_in(const std::filesystem::path& folder, const std::string& command,
                   const std::string& log)
{
    const std::string line = "cd '" + folder.string() +
                             "' && WM_PROJECT_DIR=${WM_PROJECT_DIR:-/usr/share/openfoam} && export "
                             "WM_PROJECT_DIR && ( " +
                             command + " ) > " + log + " 2>&1";
    if (std::system(line.c_str()) == 0) return true;
    const std::string output = file_text(folder / log);
    ADD_FAILURE() << command << " failed in " << folder << ":\n"
                  << output.substr(output.size() > 2000 ? output.size() - 2000 : 0);
    return false;
}

/// The numbers of the last line of a function object's table; parentheses count as white space.
inline std::vector<double> last_row(const std::filesystem::path& file)
{
    std::istringstream lines(file_text(file));
    std::string line, last;
    while (std::getline(lines, line))
        if (!line.empty() && line[0] != '#') last = line;
    for (char& c : last)
        if (c == '(' || c == ')') c = ' ';
    std::istringstream words(last);
    return {std::istream_iterator<double>(words), {}};
}

/// The values of a field that OpenFOAM wrote, by the given list reader: at cells, or at internal
/// faces.
template <class Read>
auto internal_field(const std::filesystem::path& file, Read read)
{
    FoamReader reader(file);
    while (reader.word() != "internalField")
        reader.entry();
    reader.word();  // nonuniform
    reader.word();  // List<...>
    return read(reader);
}

inline std::vector<double> scalar_field(const std::filesystem::path& file)
{
    return internal_field(file, [](FoamReader& reader) { return reader.scalars(); });
}

inline std::vector<Vec3> vector_field(const std::filesystem::path& file)
{
    return internal_field(file, [](FoamReader& reader) { return reader.vectors(); });
}

/// The folder of the latest time of a case.
inline std::filesystem::path latest_time(const std::filesystem::path& foam_case)
{
    std::filesystem::path latest = foam_case / "0";
    double time = 0.0;
    for (const auto& entry : std::filesystem::directory_iterator(foam_case)) {
        const auto value = csv_number(entry.path().filename().string());
        if (!value || *value < time) continue;
        time = *value;
        latest = entry.path();
    }
    return latest;
}

/// Figures by "quantity [unit]": without the device, with it, reduction; NaN where empty.
inline std::map<std::string, std::array<double, 3>> figures(const std::filesystem::path& folder)
{
    std::map<std::string, std::array<double, 3>> all;
    std::istringstream lines(file_text(folder / "flow_figures.csv"));
    std::string line;
    std::getline(lines, line);
    EXPECT_EQ(line, "quantity,unit,without_device,with_device,reduction_percent");
    while (std::getline(lines, line)) {
        const auto fields = csv_fields(line);
        EXPECT_EQ(fields.size(), 5U) << line;
        auto& values = all[std::string(fields[0]) + " [" + std::string(fields[1]) + "]"];
        for (std::size_t i = 0; i < 3; ++i)
            values[i] = csv_number(fields[i + 2]).value_or(std::nan(""));
    }
    EXPECT_GE(all.size(), 4U);
    return all;
}

/// Iterations after which simpleFoam found its criterion met; -1 if it did not.
inline int iterations_to_convergence(const std::filesystem::path& log)
{
    const std::string text = file_text(log);
    const std::string words = "SIMPLE solution converged in ";
    const auto found = text.find(words);
    return found == std::string::npos ? -1 : std::stoi(text.substr(found + words.size()));
}

}  // namespace braidzone::test
