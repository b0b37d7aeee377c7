#include "cli/folder_record.hpp"

#include "core/error.hpp"
#include "core/file_hash.hpp"
#include "export/text_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <map>
#include <set>

namespace braidzone {
namespace {

namespace fs = std::filesystem;

/// Hashes by file, relative to the folder.
using Record = std::map<std::string, std::string>;

constexpr std::size_t hash_digits = 64;
constexpr std::size_t name_begins = hash_digits + 2;  // two spaces, as sha256sum has them

Record read_record(const fs::path& folder)
{
    Record record;
    std::ifstream stream(folder / folder_record_name);
    for (std::string line; std::getline(stream, line);)
        if (line.size() > name_begins)
            record[line.substr(name_begins)] = line.substr(0, hash_digits);
    return record;
}

/// The folders that hold recorded files.
std::set<std::string> folders_of(const Record& record)
{
    std::set<std::string> folders;
    for (const auto& [file, hash] : record)
        for (fs::path above = fs::path(file).parent_path(); !above.empty();
             above = above.parent_path())
            folders.insert(above.string());
    return folders;
}

FoundFile found(const fs::path& folder, const fs::path& file)
{
    return {file, fs::file_size(folder / file), fs::last_write_time(folder / file)};
}

bool is_as_found(const fs::path& folder, const FoundFile& file)
{
    std::error_code error;
    const fs::path path = folder / file.file;
    return fs::symlink_status(path, error).type() == fs::file_type::regular &&
           fs::file_size(path, error) == file.size && !error &&
           fs::last_write_time(path, error) == file.changed && !error;
}

/// Folders in a folder, the innermost first; links are none.
std::vector<fs::path> folders_in(const fs::path& folder)
{
    std::vector<fs::path> folders{folder};
    for (const auto& entry : fs::recursive_directory_iterator(folder))
        if (entry.symlink_status().type() == fs::file_type::directory)
            folders.push_back(entry.path());
    std::reverse(folders.begin(), folders.end());
    return folders;
}

}  // namespace

void write_folder_record(const fs::path& folder)
{
    Record record;
    for (const auto& entry : fs::recursive_directory_iterator(folder)) {
        if (entry.symlink_status().type() != fs::file_type::regular) continue;
        record[entry.path().lexically_relative(folder).string()] = sha256_of_file(entry.path());
    }
    std::string text;
    for (const auto& [file, hash] : record)
        text += fmt::format("{}  {}\n", hash, file);
    write_text_file(folder / folder_record_name, text);
}

bool is_recorded(const fs::path& folder, const std::string& file)
{
    return read_record(folder).contains(file);
}

FolderContents compare_with_record(const fs::path& folder)
{
    const Record record = read_record(folder);
    const std::set<std::string> recorded_folders = folders_of(record);
    FolderContents contents;
    for (auto entry = fs::recursive_directory_iterator(folder);
         entry != fs::recursive_directory_iterator(); ++entry) {
        const fs::path file = entry->path().lexically_relative(folder);
        const fs::file_type type = entry->symlink_status().type();
        const auto recorded = record.find(file.string());
        if (type == fs::file_type::directory && recorded_folders.contains(file.string())) continue;
        if (file == folder_record_name && type == fs::file_type::regular) {
            contents.unchanged.push_back(found(folder, file));
        } else if (recorded == record.end()) {
            const bool is_own = entry.depth() == 0 && !record.empty();
            (is_own ? contents.own : contents.altered).push_back(file);
            if (type == fs::file_type::directory) entry.disable_recursion_pending();
        } else {
            // What it is before it is read: a change in between is noticed when it is removed.
            const bool is_file = type == fs::file_type::regular;
            const FoundFile as_it_is = is_file ? found(folder, file) : FoundFile{};
            if (is_file && sha256_of_file(entry->path()) == recorded->second)
                contents.unchanged.push_back(as_it_is);
            else
                contents.altered.push_back(file);
        }
    }
    std::sort(contents.altered.begin(), contents.altered.end());
    return contents;
}

bool remove_found(const fs::path& folder, const std::vector<FoundFile>& files)
{
    std::error_code ignored;
    for (const FoundFile& file : files)
        if (is_as_found(folder, file)) fs::remove(folder / file.file, ignored);
    for (const fs::path& inner : folders_in(folder))
        fs::remove(inner, ignored);  // if it is empty
    return !fs::exists(folder);
}

}  // namespace braidzone
