#include "export/foam_format.hpp"

#include "core/error.hpp"

#include <fmt/format.h>
#include <zlib.h>

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <limits>

namespace braidzone {

namespace {

std::filesystem::path with_gz(const std::filesystem::path& file)
{
    return file.string() + ".gz";
}

/// The decompressed content of a plain or gzipped file (zlib passes plain files through).
std::string read_whole(const std::filesystem::path& file)
{
    const auto present = std::filesystem::exists(file) ? file : with_gz(file);
    const gzFile stream = gzopen(present.c_str(), "rb");
    if (stream == nullptr) throw IoError(fmt::format("{}: cannot be opened", file.string()));
    std::string text;
    std::vector<char> block(1 << 20);
    int num_read = 0;
    while ((num_read = gzread(stream, block.data(), static_cast<unsigned>(block.size()))) > 0)
        text.append(block.data(), static_cast<std::size_t>(num_read));
    const int status = gzclose_r(stream);
    if (num_read < 0 || status != Z_OK)
        throw IoError(fmt::format("{}: reading failed or the file is cut off", present.string()));
    return text;
}

bool is_blank(char c)
{
    return c == ' ' || c == '\n' || c == '\t' || c == '\r';
}

/// A number from raw bytes, whose address need not be aligned.
template <class Number>
Number decode(const char* bytes)
{
    Number value;
    std::memcpy(&value, bytes, sizeof value);
    return value;
}

double decode_scalar(const char* bytes, int num_bytes)
{
    return num_bytes == 4 ? static_cast<double>(decode<float>(bytes)) : decode<double>(bytes);
}

/// Value of `key=...` in an `arch` entry such as "LSB;label=32;scalar=64", in bytes.
int arch_bytes(const std::string& arch, const std::string& key, int otherwise)
{
    const auto found = arch.find(key + "=");
    if (found == std::string::npos) return otherwise;
    int bits = 0;
    const char* begin = arch.data() + found + key.size() + 1;
    std::from_chars(begin, arch.data() + arch.size(), bits);
    return bits / 8;
}

}  // namespace

FoamReader::FoamReader(const std::filesystem::path& file) : file_(file), text_(read_whole(file))
{
    read_header();
}

void FoamReader::read_header()
{
    if (word() != "FoamFile") fail("no FoamFile header");
    expect('{');
    while (peek() != '}') {
        const std::string key = word();
        if (key.empty()) fail("broken FoamFile header");
        const std::string value = entry();
        if (key == "format") header_.is_binary = value == "binary";
        if (key == "class") header_.class_name = value;
        if (key == "arch") {
            if (value.find("MSB") != std::string::npos) fail("big-endian files are not supported");
            header_.label_bytes = arch_bytes(value, "label", header_.label_bytes);
            header_.scalar_bytes = arch_bytes(value, "scalar", header_.scalar_bytes);
            const auto is_size = [](int bytes) { return bytes == 4 || bytes == 8; };
            if (!is_size(header_.label_bytes) || !is_size(header_.scalar_bytes))
                fail("arch " + value + ": labels and scalars must have 32 or 64 bits");
        }
    }
    expect('}');
}

void FoamReader::fail(const std::string& what) const
{
    const auto read =
        text_.begin() + static_cast<std::ptrdiff_t>(std::min(position_, text_.size()));
    const auto line = 1 + std::count(text_.begin(), read, '\n');
    throw InputError(fmt::format("{}:{}: {}", file_.string(), line, what));
}

void FoamReader::skip_blank()
{
    while (position_ < text_.size()) {
        if (is_blank(text_[position_])) {
            ++position_;
        } else if (text_.compare(position_, 2, "//") == 0) {
            position_ = std::min(text_.find('\n', position_), text_.size());
        } else if (text_.compare(position_, 2, "/*") == 0) {
            const auto end = text_.find("*/", position_);
            if (end == std::string::npos) fail("comment without end");
            position_ = end + 2;
        } else {
            return;
        }
    }
}

char FoamReader::peek()
{
    skip_blank();
    return position_ < text_.size() ? text_[position_] : '\0';
}

void FoamReader::expect(char c)
{
    const char found = peek();
    if (found == '\0') fail(fmt::format("file ends where '{}' is expected", c));
    if (found != c) fail(fmt::format("found '{}' where '{}' is expected", found, c));
    ++position_;
}

std::string FoamReader::word()
{
    skip_blank();
    const auto begin = position_;
    while (position_ < text_.size() && !is_blank(text_[position_]) &&
           std::string_view("(){};").find(text_[position_]) == std::string_view::npos)
        ++position_;
    return text_.substr(begin, position_ - begin);
}

std::string FoamReader::entry()
{
    skip_blank();
    const auto begin = position_;
    bool in_quotes = false;
    while (position_ < text_.size() && (in_quotes || text_[position_] != ';'))
        if (text_[position_++] == '"') in_quotes = !in_quotes;
    if (position_ == text_.size()) fail("entry without ';'");
    return text_.substr(begin, position_++ - begin);
}

int FoamReader::label()
{
    skip_blank();
    long long value = 0;
    const auto [end, error] =
        std::from_chars(text_.data() + position_, text_.data() + text_.size(), value);
    if (error != std::errc() || value < std::numeric_limits<int>::min() ||
        value > std::numeric_limits<int>::max())
        fail("an integer is expected");
    position_ = static_cast<std::size_t>(end - text_.data());
    return static_cast<int>(value);
}

double FoamReader::scalar()
{
    skip_blank();
    double value = 0.0;
    const auto [end, error] =
        std::from_chars(text_.data() + position_, text_.data() + text_.size(), value);
    if (error != std::errc()) fail("a number is expected");
    position_ = static_cast<std::size_t>(end - text_.data());
    return value;
}

std::string_view FoamReader::raw(std::size_t num_bytes)
{
    expect('(');
    if (text_.size() - position_ < num_bytes) fail("file ends within a list");
    const std::string_view bytes = std::string_view(text_).substr(position_, num_bytes);
    position_ += num_bytes;
    expect(')');
    return bytes;
}

template <class Item, class Parse, class Decode>
std::vector<Item> FoamReader::list(std::size_t item_bytes, Parse parse, Decode decode_item)
{
    std::vector<Item> items;
    if (peek() == '(') {
        expect('(');
        while (peek() != ')')
            items.push_back(parse());
        expect(')');
        return items;
    }
    const int num_items = label();
    if (num_items < 0) fail(fmt::format("a list of {} entries", num_items));
    const auto size = static_cast<std::size_t>(num_items);
    // An empty binary list may come without parentheses.
    if (size == 0 && peek() != '(' && peek() != '{') return items;
    if (header_.is_binary && size > 0 && peek() == '(') {
        const std::string_view bytes = raw(size * item_bytes);
        items.reserve(size);
        for (std::size_t i = 0; i < size; ++i)
            items.push_back(decode_item(bytes.data() + i * item_bytes));
        return items;
    }
    if (peek() == '{') {
        expect('{');
        items.assign(size, parse());
        expect('}');
        return items;
    }
    expect('(');
    for (std::size_t i = 0; i < size; ++i)
        items.push_back(parse());
    expect(')');
    return items;
}

std::vector<int> FoamReader::labels()
{
    const auto num_bytes = static_cast<std::size_t>(header_.label_bytes);
    return list<int>(
        num_bytes, [&] { return label(); },
        [&](const char* bytes) {
            const std::int64_t value =
                num_bytes == 4 ? decode<std::int32_t>(bytes) : decode<std::int64_t>(bytes);
            if (value < std::numeric_limits<int>::min() || value > std::numeric_limits<int>::max())
                fail(fmt::format("label {} does not fit into 32 bits", value));
            return static_cast<int>(value);
        });
}

std::vector<int> FoamReader::bools()
{
    const auto as_bool = [&](int value) {
        if (value != 0 && value != 1) fail(fmt::format("{} where 0 or 1 is expected", value));
        return value;
    };
    return list<int>(
        1, [&] { return as_bool(label()); }, [&](const char* byte) { return as_bool(*byte); });
}

std::vector<double> FoamReader::scalars()
{
    return list<double>(
        static_cast<std::size_t>(header_.scalar_bytes), [&] { return scalar(); },
        [&](const char* bytes) { return decode_scalar(bytes, header_.scalar_bytes); });
}

std::vector<Vec3> FoamReader::vectors()
{
    const auto parse = [&] {
        expect('(');
        const double x = scalar(), y = scalar(), z = scalar();
        expect(')');
        return Vec3(x, y, z);
    };
    const int step = header_.scalar_bytes;
    return list<Vec3>(static_cast<std::size_t>(3 * step), parse, [step](const char* bytes) {
        return Vec3(decode_scalar(bytes, step), decode_scalar(bytes + step, step),
                    decode_scalar(bytes + 2 * step, step));
    });
}

std::vector<std::vector<int>> FoamReader::label_lists()
{
    if (header_.class_name != "faceCompactList") {
        // A nested list of plain text: only its innermost lists could be raw, and never are.
        return list<std::vector<int>>(
            0, [&] { return labels(); },
            [&](const char*) -> std::vector<int> { fail("binary faces must be compact"); });
    }
    const std::vector<int> starts = labels();
    const std::vector<int> all = labels();
    if (starts.empty()) fail("no faces");
    std::vector<std::vector<int>> lists;
    lists.reserve(starts.size() - 1);
    for (std::size_t i = 0; i + 1 < starts.size(); ++i) {
        if (starts[i] < 0 || starts[i + 1] < starts[i] ||
            static_cast<std::size_t>(starts[i + 1]) > all.size())
            fail(fmt::format("list {} starts at {} and ends at {}", i, starts[i], starts[i + 1]));
        lists.emplace_back(all.begin() + starts[i], all.begin() + starts[i + 1]);
    }
    return lists;
}

bool foam_file_exists(const std::filesystem::path& file)
{
    return std::filesystem::exists(file) || std::filesystem::exists(with_gz(file));
}

std::string foam_header(std::string_view class_name, std::string_view location,
                        std::string_view object)
{
    return fmt::format(
        "FoamFile\n{{\n    version     2.0;\n    format      ascii;\n    class       {};\n"
        "    location    \"{}\";\n    object      {};\n}}\n\n",
        class_name, location, object);
}

std::string foam_vector(const Vec3& v)
{
    return fmt::format("({} {} {})", v.x(), v.y(), v.z());
}

}  // namespace braidzone
