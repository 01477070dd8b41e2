#include "common/gltf/base64.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace burnish {
namespace {

std::vector<uint8_t> bytes_of_text(std::string_view text) {
  return {text.begin(), text.end()};
}

TEST(Base64, TheExamplesOfItsRfcGoBothWays) {
  const std::pair<const char*, const char*> examples[] = {{"", ""},
                                                          {"f", "Zg=="},
                                                          {"fo", "Zm8="},
                                                          {"foo", "Zm9v"},
                                                          {"foob", "Zm9vYg=="},
                                                          {"fooba", "Zm9vYmE="},
                                                          {"foobar", "Zm9vYmFy"}};
  for (const auto& [text, encoded] : examples) {
    EXPECT_EQ(to_base64(bytes_of_text(text)), encoded);
    EXPECT_EQ(from_base64(encoded), bytes_of_text(text));
  }
}

TEST(Base64, PaddingMayBeLeftOut) {
  EXPECT_EQ(from_base64("Zm8"), bytes_of_text("fo"));
}

TEST(Base64, EveryByteComesBack) {
  std::vector<uint8_t> bytes;
  for (int i = 0; i < 256; ++i) bytes.push_back(static_cast<uint8_t>(i));
  EXPECT_EQ(from_base64(to_base64(bytes)), bytes);
}

TEST(Base64, OtherCharactersAndLengthsAreRefused) {
  for (const char* text : {"Z", "Zm9vY", "Zm9v\n", "Zm-v", "Z=9v", "Zm9\xff"})
    EXPECT_EQ(from_base64(text), std::nullopt) << text;
}

}  // namespace
}  // namespace burnish
