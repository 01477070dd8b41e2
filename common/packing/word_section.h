#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "common/base/status.h"

namespace burnish {

/// How a section of the view format stores its words.
struct WordLayout {
  size_t word_bytes;     ///< 4 or 8
  size_t difference_to;  ///< distance in words; 0: words are stored unchanged
  size_t words_of_element;
};

/// Packs words into one section of a file: differences, byte planes, one zstd frame.
/// Needs: a whole number of words.
std::vector<uint8_t> pack_words(const WordLayout& layout, std::span<const uint8_t> words);

/// Unpacks a section to `size` bytes. Fails: data_loss if it does not unpack to exactly `size`
/// bytes; a section that declares another size takes no memory.
Result<std::vector<uint8_t>> unpack_words(const WordLayout& layout,
                                          std::span<const uint8_t> section, size_t size);

}  // namespace burnish
