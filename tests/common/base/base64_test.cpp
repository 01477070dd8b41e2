#include "common/base/base64.h"

#include <gtest/gtest.h>

namespace burnish {
namespace {

// The vectors of RFC 4648, section 10.
TEST(Base64, PadsWhatIsNoMultipleOfThreeBytes) {
  EXPECT_EQ(base64(""), "");
  EXPECT_EQ(base64("f"), "Zg==");
  EXPECT_EQ(base64("fo"), "Zm8=");
  EXPECT_EQ(base64("foo"), "Zm9v");
  EXPECT_EQ(base64("foobar"), "Zm9vYmFy");
}

TEST(Base64, HasBytesOfAllValues) {
  EXPECT_EQ(base64("\xff\xfb\xf0"), "//vw");
  EXPECT_EQ(base64(std::string(2, '\0')), "AAA=");
}

}  // namespace
}  // namespace burnish
