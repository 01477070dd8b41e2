#include "common/packing/word_section.h"

#include <cstring>

#include "common/packing/zigzag.h"
#include "common/packing/zstd_frame.h"

namespace burnish {

namespace {

constexpr int kZstdLevel = 3;

template <typename Word>
Word word_at(const uint8_t* bytes, size_t i) {
  Word word;
  std::memcpy(&word, bytes + i * sizeof(Word), sizeof(Word));
  return word;
}

template <typename Word>
std::vector<uint8_t> to_planes(std::span<const uint8_t> words, size_t back) {
  const size_t count = words.size() / sizeof(Word);
  std::vector<uint8_t> planes(words.size());
  for (size_t i = 0; i < count; ++i) {
    Word word = word_at<Word>(words.data(), i);
    if (back > 0) {
      const Word before = i < back ? Word{0} : word_at<Word>(words.data(), i - back);
      word = to_zigzag<Word>(word - before);
    }
    for (size_t byte = 0; byte < sizeof(Word); ++byte)
      planes[byte * count + i] = static_cast<uint8_t>(word >> 8 * byte);
  }
  return planes;
}

template <typename Word>
void from_planes(std::span<const uint8_t> planes, size_t back, std::span<uint8_t> words) {
  const size_t count = words.size() / sizeof(Word);
  for (size_t i = 0; i < count; ++i) {
    Word word = 0;
    for (size_t byte = 0; byte < sizeof(Word); ++byte)
      word |= static_cast<Word>(planes[byte * count + i]) << 8 * byte;
    if (back > 0)
      word = from_zigzag(word) + (i < back ? Word{0} : word_at<Word>(words.data(), i - back));
    std::memcpy(words.data() + i * sizeof(Word), &word, sizeof(Word));
  }
}

}  // namespace

std::vector<uint8_t> pack_words(const WordLayout& layout, std::span<const uint8_t> words) {
  const std::vector<uint8_t> planes = layout.word_bytes == 8
                                          ? to_planes<uint64_t>(words, layout.difference_to)
                                          : to_planes<uint32_t>(words, layout.difference_to);
  std::vector<uint8_t> section;
  append_compressed(planes, kZstdLevel, section);
  return section;
}

Result<std::vector<uint8_t>> unpack_words(const WordLayout& layout,
                                          std::span<const uint8_t> section, size_t size) {
  ASSIGN_OR_RETURN(const std::vector<uint8_t> planes, decompress(section, size));
  std::vector<uint8_t> words(size);
  if (layout.word_bytes == 8) {
    from_planes<uint64_t>(planes, layout.difference_to, words);
  } else {
    from_planes<uint32_t>(planes, layout.difference_to, words);
  }
  return words;
}

}  // namespace burnish
