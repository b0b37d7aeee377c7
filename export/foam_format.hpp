#pragma once

#include "core/vector.hpp"

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace braidzone {

/// The part of an OpenFOAM file's header that decides how its body is read.
struct FoamHeader {
    std::string class_name;  ///< e.g. "faceCompactList"
    bool is_binary = false;  ///< lists of numbers are raw, little-endian
    int label_bytes = 4;     ///< of an integer in binary, from `arch`
    int scalar_bytes = 8;    ///< of a real number in binary, from `arch`
};

/// Reads an OpenFOAM file from front to back: words, numbers and lists, ASCII or binary, plain or
/// gzipped. White space and comments between them are skipped.
///
/// Lists are `N ( a b ... )`, `N { a }` for N equal entries, or `( a b ... )` in ASCII; binary
/// lists are `N ( raw )`. Every error is an InputError that names the file and the line.
class FoamReader {
public:
    /// Opens `file`, or `file` with ".gz" appended, and reads its header.
    /// @throws IoError if there is neither, or it cannot be decompressed; InputError without header
    explicit FoamReader(const std::filesystem::path& file);

    const FoamHeader& header() const { return header_; }

    char peek();          ///< next significant character; '\0' at the end
    void expect(char c);  ///< skips this character, which must come next
    std::string word();   ///< up to white space or one of ( ) { } ;
    int label();          ///< an integer
    double scalar();      ///< a real number
    std::string entry();  ///< the raw text up to the next ';', which is skipped

    std::vector<int> labels();
    std::vector<int> bools();  ///< 0 or 1
    std::vector<Vec3> vectors();
    std::vector<double> scalars();
    /// Lists of labels: faceList (ASCII) or faceCompactList (two label lists: starts, then labels).
    std::vector<std::vector<int>> label_lists();

    [[noreturn]] void fail(const std::string& what) const;

private:
    void read_header();
    void skip_blank();
    std::string_view raw(std::size_t num_bytes);
    template <class Item, class Parse, class Decode>
    std::vector<Item> list(std::size_t item_bytes, Parse parse, Decode decode);

    std::filesystem::path file_;
    std::string text_;
    std::size_t position_ = 0;
    FoamHeader header_;
};

/// True if `file` or `file`.gz exists.
bool foam_file_exists(const std::filesystem::path& file);

/// Header of an ASCII file, as text.
/// @param location  folder within the case, e.g. "constant/polyMesh"
std::string foam_header(std::string_view class_name, std::string_view location,
                        std::string_view object);

/// "(x y z)" with the digits that give the same value when read again.
std::string foam_vector(const Vec3& v);

}  // namespace braidzone
