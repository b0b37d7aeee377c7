#include "export/binary_file.hpp"

#include "core/error.hpp"

#include <fmt/format.h>

#include <bit>

namespace braidzone {

static_assert(std::endian::native == std::endian::little);

BinaryFile::BinaryFile(const std::filesystem::path& path)
    : path_(path), file_(path, std::ios::binary)
{
}

void BinaryFile::write(std::string_view bytes)
{
    file_.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    // A full disk is noticed at once, not after the other gigabytes.
    if (!file_) throw IoError(fmt::format("{} cannot be written", path_.string()));
}

void BinaryFile::close()
{
    file_.close();
    if (!file_) throw IoError(fmt::format("{} cannot be written", path_.string()));
}

}  // namespace braidzone
