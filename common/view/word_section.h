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
  size_t difference_to;  ///< so many words back; 0: words are stored as they are
  size_t words_of_element;
};

/// Words as one section of a file: differences, byte planes, one zstd frame.
/// Needs: a whole number of words.
std::vector<uint8_t> pack_words(const WordLayout& layout, std::span<const uint8_t> words);

/// The words, `size` bytes. Fails: data_loss where the section is not one of exactly so many; no
/// memory is taken for one that does not say so itself.
Result<std::vector<uint8_t>> unpack_words(const WordLayout& layout,
                                          std::span<const uint8_t> section, size_t size);

}  // namespace burnish
