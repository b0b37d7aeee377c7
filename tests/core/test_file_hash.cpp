#include "core/error.hpp"
#include "core/file_hash.hpp"
#include "support/temporary_folder.hpp"

#include <gtest/gtest.h>

namespace braidzone {
namespace {

// Examples of FIPS 180-4: "abc", the empty message, and a million times "a".
TEST(FileHash, GivesThePublishedDigests)
{
    const test::TemporaryFolder folder;
    EXPECT_EQ(sha256_of_file(folder.write("abc", "abc")),
              "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
    EXPECT_EQ(sha256_of_file(folder.write("empty", "")),
              "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
    EXPECT_EQ(sha256_of_file(folder.write("million", std::string(1000000, 'a'))),
              "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
}

TEST(FileHash, OfATextIsThatOfAFileWithIt)
{
    EXPECT_EQ(sha256_of_text("abc"),
              "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
    EXPECT_EQ(sha256_of_text(""),
              "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
}

TEST(FileHash, RefusesAMissingFile)
{
    EXPECT_THROW(sha256_of_file("/nowhere/at/all"), IoError);
}

}  // namespace
}  // namespace braidzone
