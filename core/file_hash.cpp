#include "core/file_hash.hpp"

#include "core/error.hpp"

#include <fmt/format.h>
#include <openssl/evp.h>

#include <array>
#include <fstream>
#include <memory>
#include <stdexcept>

namespace braidzone {

namespace {

/// A SHA-256 that is fed block by block.
class Sha256 {
public:
    Sha256() : context_(EVP_MD_CTX_new(), EVP_MD_CTX_free)
    {
        is_good_ = context_ && EVP_DigestInit_ex(context_.get(), EVP_sha256(), nullptr) == 1;
    }

    void add(const char* bytes, std::size_t size)
    {
        is_good_ = is_good_ && EVP_DigestUpdate(context_.get(), bytes, size) == 1;
    }

    /// 64 hexadecimal digits; none if the library failed.
    std::string digits()
    {
        std::array<unsigned char, EVP_MAX_MD_SIZE> digest;
        unsigned size = 0;
        is_good_ = is_good_ && EVP_DigestFinal_ex(context_.get(), digest.data(), &size) == 1;
        std::string text;
        for (unsigned i = 0; is_good_ && i < size; ++i)
            text += fmt::format("{:02x}", digest[i]);
        return text;
    }

private:
    std::unique_ptr<EVP_MD_CTX, void (*)(EVP_MD_CTX*)> context_;
    bool is_good_ = false;
};

}  // namespace

std::string sha256_of_file(const std::filesystem::path& path)
{
    std::ifstream file(path, std::ios::binary);
    if (!file) throw IoError(fmt::format("{} cannot be opened", path.string()));
    Sha256 hash;
    std::array<char, 1 << 16> block;
    while (file.read(block.data(), block.size()), file.gcount() > 0)
        hash.add(block.data(), static_cast<std::size_t>(file.gcount()));
    const std::string digits = hash.digits();
    if (digits.empty() || file.bad())
        throw IoError(fmt::format("{} cannot be hashed", path.string()));
    return digits;
}

std::string sha256_of_text(std::string_view text)
{
    Sha256 hash;
    hash.add(text.data(), text.size());
    const std::string digits = hash.digits();
    if (digits.empty()) throw std::runtime_error("SHA-256 is not available");
    return digits;
}

}  // namespace braidzone
