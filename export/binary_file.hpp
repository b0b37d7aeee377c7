#pragma once

#include <cstddef>
#include <filesystem>
#include <fstream>
#include <string_view>
#include <vector>

namespace braidzone {

/// A file written piece by piece, so that arrays larger than the memory can be.
class BinaryFile {
public:
    explicit BinaryFile(const std::filesystem::path& path);

    void write(std::string_view bytes);

    /// The values as they lie in memory: little endian.
    template <typename Value>
    void write(const std::vector<Value>& values)
    {
        write(std::string_view(reinterpret_cast<const char*>(values.data()),
                               values.size() * sizeof(Value)));
    }

    /// Ends the file.
    /// @throws IoError if anything could not be written
    void close();

private:
    std::filesystem::path path_;
    std::ofstream file_;
};

}  // namespace braidzone
