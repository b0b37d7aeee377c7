#include "cli/output_files.hpp"

#include "core/error.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <fstream>

namespace braidzone {

namespace fs = std::filesystem;

fs::path OutputFiles::add(const fs::path& wanted)
{
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
    files_.emplace_back(std::make_unique<UnfinishedOutput>(
                            folder / fmt::format(".{}.{}.unfinished{}", wanted.stem().string(),
                                                 ::getpid(), wanted.extension().string())),
                        wanted);
    return files_.back().first->path();
}

void OutputFiles::commit()
{
    for (auto& [unfinished, wanted] : files_) {
        unfinished->finish([&] {
            std::error_code error;
            fs::rename(unfinished->path(), wanted, error);
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
