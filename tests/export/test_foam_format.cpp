#include "core/error.hpp"
#include "export/foam_format.hpp"
#include "export/text_file.hpp"
#include "support/temporary_folder.hpp"

#include <gtest/gtest.h>
#include <zlib.h>

#include <cstdint>
#include <cstring>

namespace braidzone {
namespace {

const std::string ascii_header = "FoamFile { version 2.0; format ascii; class labelList; }\n";

std::string binary_header(const std::string& arch)
{
    return "FoamFile { version 2.0; format binary; arch \"" + arch + "\"; class x; }\n";
}

template <class Number>
std::string bytes_of(const std::vector<Number>& numbers)
{
    std::string bytes(numbers.size() * sizeof(Number), '\0');
    std::memcpy(bytes.data(), numbers.data(), bytes.size());
    return bytes;
}

/// The message of the InputError that `action` throws.
template <class Action>
std::string message_of(Action action)
{
    try {
        action();
    } catch (const InputError& error) {
        return error.what();
    }
    return "no InputError";
}

TEST(FoamReader, ReadsEveryFormOfAsciiList)
{
    const test::TemporaryFolder folder;
    const auto file =
        folder.write("f", "/* banner */\n" + ascii_header +
                              "// sized\n3(1 -2 3)\n2\n(\n4\n5\n)\n3{7}\n(8 9)\n0()\n");
    FoamReader reader(file);
    EXPECT_EQ(reader.labels(), (std::vector<int>{1, -2, 3}));
    EXPECT_EQ(reader.labels(), (std::vector<int>{4, 5}));
    EXPECT_EQ(reader.labels(), (std::vector<int>{7, 7, 7}));
    EXPECT_EQ(reader.labels(), (std::vector<int>{8, 9}));
    EXPECT_TRUE(reader.labels().empty());
    EXPECT_EQ(reader.peek(), '\0');
}

TEST(FoamReader, ReadsVectorsAndScalars)
{
    const test::TemporaryFolder folder;
    FoamReader reader(folder.write("f", ascii_header + "2((1 2.5 -3e-3) (0 0 1))\n2(0.1 1e-18)"));
    const auto vectors = reader.vectors();
    ASSERT_EQ(vectors.size(), 2U);
    EXPECT_EQ(vectors[0], Vec3(1, 2.5, -3e-3));
    EXPECT_EQ(reader.scalars(), (std::vector<double>{0.1, 1e-18}));
}

TEST(FoamReader, ReadsBinaryOfBothPrecisions)
{
    const test::TemporaryFolder folder;
    FoamReader usual(folder.write("usual", binary_header("LSB;label=32;scalar=64") + "3\n(" +
                                               bytes_of<std::int32_t>({40, 41, 2147483647}) +
                                               ")\n0\n1\n(" + bytes_of<double>({0.1, 0.2, 0.3}) +
                                               ")\n"));
    EXPECT_EQ(usual.labels(), (std::vector<int>{40, 41, 2147483647}));
    EXPECT_TRUE(usual.labels().empty());
    EXPECT_EQ(usual.vectors().at(0), Vec3(0.1, 0.2, 0.3));

    FoamReader other(folder.write("other", binary_header("LSB;label=64;scalar=32") + "2(" +
                                               bytes_of<std::int64_t>({40, 41}) + ")2(" +
                                               bytes_of<float>({0.5F, 0.25F}) + ")"));
    EXPECT_EQ(other.labels(), (std::vector<int>{40, 41}));
    EXPECT_EQ(other.scalars(), (std::vector<double>{0.5, 0.25}));
}

TEST(FoamReader, ReadsGzippedFile)
{
    const test::TemporaryFolder folder;
    const std::string text = ascii_header + "2(6 7)";
    const gzFile stream = gzopen((folder.path() / "f.gz").c_str(), "wb");
    gzwrite(stream, text.data(), static_cast<unsigned>(text.size()));
    gzclose(stream);
    EXPECT_TRUE(foam_file_exists(folder.path() / "f"));
    EXPECT_EQ(FoamReader(folder.path() / "f").labels(), (std::vector<int>{6, 7}));
}

TEST(FoamReader, SaysWhatIsWrongAndWhere)
{
    const test::TemporaryFolder folder;
    const auto read_labels = [&](const std::string& text) {
        const auto file = folder.write("bad", text);
        return message_of([&] { FoamReader(file).labels(); });
    };
    EXPECT_NE(read_labels(ascii_header + "\n2(1 x)").find("bad:3: an integer is expected"),
              std::string::npos);
    EXPECT_NE(read_labels(ascii_header + "3(1 2").find("an integer is expected"),
              std::string::npos);
    EXPECT_NE(read_labels(binary_header("LSB;label=32;scalar=64") + "9(1234)")
                  .find("file ends within a list"),
              std::string::npos);
    EXPECT_NE(read_labels(binary_header("MSB;label=32;scalar=64")).find("big-endian"),
              std::string::npos);
    EXPECT_NE(read_labels("3(1 2 3)").find("no FoamFile header"), std::string::npos);
    EXPECT_NE(read_labels(ascii_header + "-1()").find("a list of -1 entries"), std::string::npos);
    EXPECT_THROW(FoamReader(folder.path() / "absent"), IoError);
}

TEST(FoamReader, RefusesCompactListsThatOverlap)
{
    const test::TemporaryFolder folder;
    const auto file = folder.write(
        "faces", "FoamFile { format ascii; class faceCompactList; }\n3(0 4 2)\n4(0 1 2 3)");
    EXPECT_NE(message_of([&] { FoamReader(file).label_lists(); }).find("list 1 starts at 4"),
              std::string::npos);
}

// 0.1 + 0.2 has 17 digits; fewer would not give it back.
TEST(FoamVector, KeepsEveryDigit)
{
    EXPECT_EQ(foam_vector(Vec3(0.1 + 0.2, 1.0, -2.5e-4)), "(0.30000000000000004 1 -0.00025)");
}

TEST(WriteTextFile, ThrowsWhereItCannotWrite)
{
    const test::TemporaryFolder folder;
    const auto file = folder.write("file", "");
    EXPECT_THROW(write_text_file(file / "below", "text"), IoError);
}

}  // namespace
}  // namespace braidzone
