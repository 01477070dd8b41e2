#include "client/connection/unreachable.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace burnish {
namespace {

using testing::HasSubstr;

TEST(Unreachable, TextsOfLibrariesBecomePlainWords) {
  EXPECT_THAT(why_unreachable("DNS resolution failed for a:1: C-ares status is not ARES_SUCCESS"),
              HasSubstr("name"));
  EXPECT_THAT(why_unreachable("last error: UNKNOWN: Failed to connect: Connection refused"),
              HasSubstr("burnish-server"));
  EXPECT_THAT(why_unreachable("Socket closed"), HasSubstr("TLS"));
}

TEST(Unreachable, OtherTextsStay) {
  EXPECT_EQ(why_unreachable("certificate verify failed"), "certificate verify failed");
  EXPECT_FALSE(why_unreachable("").empty());
}

}  // namespace
}  // namespace burnish
