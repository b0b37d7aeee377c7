// What the program makes of streams that cannot be written to.

#include "support/temporary_folder.hpp"

#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cstdlib>
#include <fstream>
#include <iterator>
#include <string>

namespace braidzone {
namespace {

namespace fs = std::filesystem;

const std::string straight_tube =
    std::string(BRAIDZONE_SOURCE_DIR) + "/cases/straight_tube/case.toml";

struct Outcome {
    int status = -1;
    std::string message;  ///< on stderr
};

/// Runs the program with a redirection of its output by the shell.
Outcome run_with(const std::string& arguments, const std::string& redirection)
{
    const test::TemporaryFolder folder;
    const std::string message = (folder.path() / "message").string();
    const std::string command =
        "'" BRAIDZONE_PROGRAM "' " + arguments + " 2> '" + message + "' " + redirection;
    const int status = std::system(command.c_str());
    std::ifstream stream(message);
    return {WEXITSTATUS(status), {std::istreambuf_iterator<char>(stream), {}}};
}

TEST(FullOutput, IsStatusFiveWithOneMessage)
{
    for (const std::string& arguments :
         {std::string("devices"), std::string("--help"), "check '" + straight_tube + "'"}) {
        const Outcome full = run_with(arguments, "> /dev/full");
        EXPECT_EQ(full.status, 5) << arguments;
        EXPECT_EQ(full.message,
                  "braidzone: standard output cannot be written: No space left on device\n")
            << arguments;
    }
}

TEST(ClosedOutput, IsStatusFiveIfAnythingIsPrinted)
{
    const Outcome closed = run_with("devices", ">&-");
    EXPECT_EQ(closed.status, 5);
    EXPECT_NE(closed.message.find("standard output cannot be written"), std::string::npos);
    EXPECT_EQ(run_with("check --quiet '" + straight_tube + "'", ">&-").status, 0);
}

TEST(FullOutput, OfMessagesLeavesTheStatus)
{
    EXPECT_EQ(run_with("check no_such_file.toml", "2> /dev/full").status, 5);
    EXPECT_EQ(run_with("check", "2> /dev/full").status, 2);
}

}  // namespace
}  // namespace braidzone
