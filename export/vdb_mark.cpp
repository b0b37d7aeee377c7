#include "export/vdb_mark.hpp"

#include "core/error.hpp"

#include <fmt/format.h>

#include <cstdint>
#include <fstream>
#include <iterator>
#include <string>

namespace braidzone {

namespace {

/// 64-bit FNV-1a hash.
std::uint64_t hash(const std::string& bytes, std::uint64_t basis)
{
    for (const char byte : bytes) {
        basis = (basis ^ static_cast<unsigned char>(byte)) * 0x100000001b3U;
    }
    return basis;
}

}  // namespace

void replace_vdb_mark(const std::filesystem::path& path)
{
    constexpr std::streamoff mark_offset = 21;
    constexpr std::size_t mark_size = 36;
    std::fstream file(path, std::ios::binary | std::ios::in | std::ios::out);
    std::string content{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
    content.erase(mark_offset, mark_size);
    const std::uint64_t high = hash(content, 0xcbf29ce484222325U);
    const std::uint64_t low = hash(content, high);
    // Version 8 (given by the application), variant 2, as RFC 9562 has it.
    const std::string mark =
        fmt::format("{:08x}-{:04x}-8{:03x}-a{:03x}-{:012x}", high >> 32U, high >> 16U & 0xffffU,
                    high & 0xfffU, low >> 52U, low & 0xffffffffffffU);
    file.clear();
    file.seekp(mark_offset);
    file.write(mark.data(), static_cast<std::streamsize>(mark.size()));
    file.close();
    if (!file) throw IoError(fmt::format("{}: cannot be written", path.string()));
}

}  // namespace braidzone
