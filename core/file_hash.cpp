#include "core/file_hash.hpp"

#include "core/error.hpp"

#include <fmt/format.h>
#include <openssl/evp.h>

#include <array>
#include <fstream>
#include <memory>

namespace braidzone {

std::string sha256_of_file(const std::filesystem::path& path)
{
    std::ifstream file(path, std::ios::binary);
    if (!file) throw IoError(fmt::format("{} cannot be opened", path.string()));
    const std::unique_ptr<EVP_MD_CTX, void (*)(EVP_MD_CTX*)> context(EVP_MD_CTX_new(),
                                                                     EVP_MD_CTX_free);
    bool done = context && EVP_DigestInit_ex(context.get(), EVP_sha256(), nullptr) == 1;
    std::array<char, 1 << 16> block;
    while (done && (file.read(block.data(), block.size()), file.gcount() > 0)) {
        done = EVP_DigestUpdate(context.get(), block.data(),
                                static_cast<std::size_t>(file.gcount())) == 1;
    }
    std::array<unsigned char, EVP_MAX_MD_SIZE> digest;
    unsigned size = 0;
    done = done && EVP_DigestFinal_ex(context.get(), digest.data(), &size) == 1;
    if (!done || file.bad()) throw IoError(fmt::format("{} cannot be hashed", path.string()));

    std::string text;
    for (unsigned i = 0; i < size; ++i)
        text += fmt::format("{:02x}", digest[i]);
    return text;
}

}  // namespace braidzone
