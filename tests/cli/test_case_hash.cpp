#include "cli/case_hash.hpp"
#include "support/case_texts.hpp"
#include "support/temporary_folder.hpp"

#include <gtest/gtest.h>

namespace braidzone {
namespace {

/// Hash of a case beside a vessel with some content.
std::string hash_of(const std::string& case_text, const std::string& vessel,
                    const std::vector<std::string>& overrides = {})
{
    const test::TemporaryFolder folder;
    folder.write("vessel.stl", vessel);
    return case_hash(read_case(folder.write("case.toml", case_text), overrides));
}

TEST(CaseHash, IsTheSameWhereverTheCaseLiesAndHoweverItIsSaid)
{
    const std::string hash = hash_of(test::smallest_case, "a vessel");
    EXPECT_EQ(hash.size(), 64U);
    EXPECT_EQ(hash_of(test::smallest_case, "a vessel"), hash);
    EXPECT_EQ(hash_of(std::string("# A comment.\n") + test::smallest_case, "a vessel"), hash);
    EXPECT_EQ(
        hash_of(std::string(test::smallest_case) + "[grid]\nspacing = \"0.2 mm\"\n", "a vessel"),
        hash_of(test::smallest_case, "a vessel", {"grid.spacing=0.2 mm"}));
}

TEST(CaseHash, ChangesWithAValueAndWithAnInputFile)
{
    const std::string hash = hash_of(test::smallest_case, "a vessel");
    EXPECT_NE(hash_of(test::smallest_case, "another vessel"), hash);
    EXPECT_NE(hash_of(test::smallest_case, "a vessel", {"grid.spacing=0.2 mm"}), hash);
}

TEST(InputFiles, AreTheCaseAndWhatItNames)
{
    const test::TemporaryFolder folder;
    const Case job = read_case(folder.write("case.toml", test::smallest_case));
    const std::vector<InputFile> inputs = input_files(job);
    ASSERT_EQ(inputs.size(), 2U);
    EXPECT_EQ(inputs[0].role, "case");
    EXPECT_EQ(inputs[1].role, "vessel");
    EXPECT_EQ(inputs[1].path, folder.path() / "vessel.stl");
}

}  // namespace
}  // namespace braidzone
