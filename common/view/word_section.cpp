#include "common/view/word_section.h"

#include <cstring>
#include <zstd.h>

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
Word zigzag(Word difference) {
  const Word sign = difference >> (8 * sizeof(Word) - 1) ? ~Word{0} : Word{0};
  return static_cast<Word>(difference << 1) ^ sign;
}

template <typename Word>
Word undo_zigzag(Word coded) {
  return (coded >> 1) ^ (coded & 1 ? ~Word{0} : Word{0});
}

template <typename Word>
std::vector<uint8_t> to_planes(std::span<const uint8_t> words, size_t back) {
  const size_t count = words.size() / sizeof(Word);
  std::vector<uint8_t> planes(words.size());
  for (size_t i = 0; i < count; ++i) {
    Word word = word_at<Word>(words.data(), i);
    if (back > 0) {
      const Word before = i < back ? Word{0} : word_at<Word>(words.data(), i - back);
      word = zigzag<Word>(word - before);
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
      word = undo_zigzag(word) + (i < back ? Word{0} : word_at<Word>(words.data(), i - back));
    std::memcpy(words.data() + i * sizeof(Word), &word, sizeof(Word));
  }
}

}  // namespace

std::vector<uint8_t> pack_words(const WordLayout& layout, std::span<const uint8_t> words) {
  const std::vector<uint8_t> planes = layout.word_bytes == 8
                                          ? to_planes<uint64_t>(words, layout.difference_to)
                                          : to_planes<uint32_t>(words, layout.difference_to);
  std::vector<uint8_t> section(ZSTD_compressBound(planes.size()));
  const size_t size =
      ZSTD_compress(section.data(), section.size(), planes.data(), planes.size(), kZstdLevel);
  BURNISH_CHECK(!ZSTD_isError(size), ZSTD_getErrorName(size));
  section.resize(size);
  return section;
}

Result<std::vector<uint8_t>> unpack_words(const WordLayout& layout,
                                          std::span<const uint8_t> section, size_t size) {
  if (ZSTD_getFrameContentSize(section.data(), section.size()) != size)
    return data_loss("its " + std::to_string(section.size()) + " bytes are not one zstd frame of " +
                     std::to_string(size));
  std::vector<uint8_t> planes(size);
  const size_t read = ZSTD_decompress(planes.data(), size, section.data(), section.size());
  if (ZSTD_isError(read))
    return data_loss(std::string("does not decompress: ") + ZSTD_getErrorName(read));
  if (read != size)
    return data_loss("decompresses to " + std::to_string(read) + " bytes of " +
                     std::to_string(size));
  std::vector<uint8_t> words(size);
  if (layout.word_bytes == 8) {
    from_planes<uint64_t>(planes, layout.difference_to, words);
  } else {
    from_planes<uint32_t>(planes, layout.difference_to, words);
  }
  return words;
}

}  // namespace burnish
