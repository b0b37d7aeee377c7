#include "core/ply_header.hpp"

#include <gtest/gtest.h>

#include <sstream>

namespace braidzone {
namespace {

/// A good header, with one line replaced.
std::string fault_with(const std::string& old_line, const std::string& new_line)
{
    std::string header =
        "ply\nformat ascii 1.0\ncomment made by hand\nelement vertex 8\nproperty float x\n"
        "property double y\nproperty float32 z\nproperty uchar red\nelement face 12\n"
        "property list uchar int vertex_indices\nend_header\n";
    const std::size_t start = header.find(old_line + "\n");
    EXPECT_NE(start, std::string::npos);
    header.replace(start, old_line.size() + 1, new_line);
    std::istringstream file(header);
    return ply_header_fault(file);
}

TEST(PlyHeaderFault, IsEmptyForAGoodHeader)
{
    EXPECT_EQ(fault_with("property uchar red", ""), "");
    EXPECT_EQ(fault_with("property list uchar int vertex_indices",
                         "property list uchar uint32 vertex_index\n"),
              "");
}

TEST(PlyHeaderFault, NamesWhatIsMissing)
{
    EXPECT_EQ(fault_with("ply", "solid\n"), "does not begin with ply");
    EXPECT_EQ(fault_with("format ascii 1.0", ""), "header without a format");
    EXPECT_EQ(fault_with("format ascii 1.0", "format text 1.0\n"), "header without a format");
    EXPECT_EQ(fault_with("property double y", ""), "no real property \"vertex y\"");
    EXPECT_EQ(fault_with("property double y", "property int y\n"), "no real property \"vertex y\"");
    EXPECT_EQ(fault_with("property list uchar int vertex_indices", ""),
              "no integer list \"face vertex_indices\"");
    EXPECT_EQ(fault_with("end_header", ""), "header without end_header");
}

TEST(PlyHeaderFault, QuotesALineThatCannotBeUnderstood)
{
    EXPECT_EQ(fault_with("element vertex 8", "elemint vertex 8\n"),
              "unexpected line \"elemint vertex 8\" in the header");
    EXPECT_EQ(fault_with("element vertex 8", ""),
              "unexpected line \"property float x\" in the header");
    EXPECT_EQ(fault_with("element vertex 8", "element vertex -8\n"),
              "element without a name and a number: \"element vertex -8\"");
    EXPECT_EQ(fault_with("property float x", "property flout x\n"),
              "property without a known type and a name: \"property flout x\"");
}

}  // namespace
}  // namespace braidzone
