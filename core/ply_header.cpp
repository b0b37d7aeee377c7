#include "core/ply_header.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <set>
#include <sstream>
#include <string_view>

namespace braidzone {

namespace {

template <std::size_t N>
bool is_one_of(std::string_view word, const std::array<std::string_view, N>& words)
{
    return std::find(words.begin(), words.end(), word) != words.end();
}

constexpr std::array<std::string_view, 12> small_types{"char",  "int8",  "uchar",  "uint8",
                                                       "short", "int16", "ushort", "uint16",
                                                       "int",   "int32", "uint",   "uint32"};
constexpr std::array<std::string_view, 4> index_types{"int", "int32", "uint", "uint32"};
constexpr std::array<std::string_view, 4> real_types{"float", "float32", "double", "float64"};
constexpr std::array<std::string_view, 3> formats{"ascii", "binary_little_endian",
                                                  "binary_big_endian"};

bool is_type(std::string_view word)
{
    return is_one_of(word, small_types) || is_one_of(word, real_types);
}

}  // namespace

std::string ply_header_fault(std::istream& file)
{
    std::string line;
    if (!std::getline(file, line) || line.substr(0, 3) != "ply") return "does not begin with ply";
    std::string element;
    std::set<std::string> found;  // what a surface needs: "vertex x", "face vertex_indices", ...
    bool has_format = false;
    while (std::getline(file, line)) {
        std::istringstream words(line);
        std::string keyword, type, name;
        words >> keyword;
        if (keyword == "end_header") break;
        if (keyword == "comment" || keyword == "obj_info") continue;
        if (keyword == "format") {
            words >> type >> name;
            has_format = is_one_of(type, formats) && !name.empty();
        } else if (keyword == "element") {
            long long count = -1;
            if (!(words >> element >> count) || count < 0) {
                return fmt::format("element without a name and a number: \"{}\"", line);
            }
        } else if (keyword == "property" && !element.empty()) {
            words >> type;
            if (type == "list") {
                std::string size_type;
                words >> size_type >> type >> name;
                if (!is_one_of(size_type, small_types)) type.clear();
                if (is_one_of(type, index_types)) found.insert(element + " " + name);
            } else {
                words >> name;
                if (is_one_of(type, real_types)) found.insert(element + " " + name);
            }
            if (!is_type(type) || name.empty()) {
                return fmt::format("property without a known type and a name: \"{}\"", line);
            }
        } else {
            return fmt::format("unexpected line \"{}\" in the header", line);
        }
    }
    if (!file) return "header without end_header";
    if (!has_format) return "header without a format";
    for (const char* coordinate : {"vertex x", "vertex y", "vertex z"}) {
        if (!found.contains(coordinate)) {
            return fmt::format("no real property \"{}\"", coordinate);
        }
    }
    if (!found.contains("face vertex_indices") && !found.contains("face vertex_index")) {
        return "no integer list \"face vertex_indices\"";
    }
    return "";
}

}  // namespace braidzone
