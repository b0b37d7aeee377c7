#include "cli/output_files.hpp"

#include "cli/output_place.hpp"
#include "core/error.hpp"

#include <fmt/format.h>

#include <fstream>

namespace braidzone {

namespace fs = std::filesystem;

fs::path OutputFiles::add(const fs::path& wanted)
{
    require_no_input(wanted, inputs_);
    if (fs::is_directory(wanted))
        throw IoError(
            fmt::format("output {} is a folder; a file is to be written", wanted.string()));
    if (!force_ && fs::exists(fs::symlink_status(wanted))) {
        throw IoError(
            fmt::format("{} exists; choose another with --output, or replace it with "
                        "--force",
                        wanted.string()));
    }
    const fs::path folder = fs::absolute(wanted).parent_path();
    std::error_code error;
    fs::create_directories(folder, error);
    if (error) {
        throw IoError(
            fmt::format("folder {} cannot be created: {}", folder.string(), error.message()));
    }
    const std::string name = wanted.filename().string();
    files_.emplace_back(std::make_unique<WorkingFolder>(folder, name), wanted);
    return files_.back().first->path() / name;
}

void OutputFiles::commit()
{
    for (auto& [working, wanted] : files_) {
        working->finish([&] {
            std::error_code error;
            fs::rename(working->path() / wanted.filename(), wanted, error);
            if (error) {
                throw IoError(
                    fmt::format("{} cannot be written: {}", wanted.string(), error.message()));
            }
        });
    }
}

void TextOutput::write(const std::string& text)
{
    std::ofstream file(unfinished_);
    file << text;
    file.close();
    if (!file) throw IoError(fmt::format("{} cannot be written", wanted_.string()));
    files_.commit();
}

}  // namespace braidzone
