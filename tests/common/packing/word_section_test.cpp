#include "common/packing/word_section.h"

#include <cstring>
#include <random>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace burnish {
namespace {

std::vector<uint8_t> random_words(size_t bytes) {
  std::mt19937 random(3);
  std::vector<uint8_t> words(bytes);
  for (uint8_t& byte : words) byte = static_cast<uint8_t>(random());
  return words;
}

TEST(WordSection, GivesBackAnyWords) {
  for (const WordLayout layout : {WordLayout{4, 0, 1}, {4, 1, 1}, {4, 3, 3}, {8, 0, 3}, {8, 1, 1}})
    for (const size_t count : {0, 1, 2, 3, 1000}) {
      const std::vector<uint8_t> words = random_words(count * layout.word_bytes);
      EXPECT_EQ(unpack_words(layout, pack_words(layout, words), words.size()).value(), words);
    }
}

TEST(WordSection, OfASteadyRiseTakesNextToNothing) {
  std::vector<uint32_t> words(30'000);
  for (size_t i = 0; i < words.size(); ++i) words[i] = static_cast<uint32_t>(17 * i);
  const std::span<const uint8_t> bytes(reinterpret_cast<const uint8_t*>(words.data()),
                                       words.size() * sizeof(words[0]));
  EXPECT_LT(pack_words({4, 1, 1}, bytes).size(), 200u);
}

TEST(WordSection, OfAnotherSizeThanExpectedIsDataLoss) {
  const WordLayout layout{4, 1, 1};
  const std::vector<uint8_t> section = pack_words(layout, random_words(400));
  for (const size_t size : {0, 396, 404}) {
    const Status status = unpack_words(layout, section, size).status();
    EXPECT_EQ(status.code(), StatusCode::kDataLoss);
    EXPECT_THAT(status.message(), testing::HasSubstr("are not one zstd frame of"));
  }
}

TEST(WordSection, DamagedInItsBodyIsDataLoss) {
  const WordLayout layout{4, 0, 1};
  std::vector<uint8_t> section = pack_words(layout, std::vector<uint8_t>(4000, 7));
  section.resize(section.size() - 2);
  EXPECT_THAT(unpack_words(layout, section, 4000).status().message(),
              testing::HasSubstr("does not decompress"));
}

}  // namespace
}  // namespace burnish
