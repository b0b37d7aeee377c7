#include "core/base64.hpp"

#include <gtest/gtest.h>

namespace braidzone {

// RFC 4648, section 10.
TEST(Base64, IsThatOfTheStandard)
{
    EXPECT_EQ(base64_of(""), "");
    EXPECT_EQ(base64_of("f"), "Zg==");
    EXPECT_EQ(base64_of("fo"), "Zm8=");
    EXPECT_EQ(base64_of("foo"), "Zm9v");
    EXPECT_EQ(base64_of("foobar"), "Zm9vYmFy");
}

}  // namespace braidzone
