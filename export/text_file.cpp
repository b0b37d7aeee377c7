#include "export/text_file.hpp"

#include "core/error.hpp"

#include <fmt/format.h>

#include <fstream>

namespace braidzone {

void write_text_file(const std::filesystem::path& file, std::string_view text)
{
    std::error_code ignored;  // the stream reports what matters
    if (file.has_parent_path()) std::filesystem::create_directories(file.parent_path(), ignored);
    std::ofstream stream(file, std::ios::binary);
    stream << text;
    stream.close();
    if (!stream) throw IoError(fmt::format("{}: cannot be written", file.string()));
}

}  // namespace braidzone
