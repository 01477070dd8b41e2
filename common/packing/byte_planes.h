#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace burnish {

/// Appends the lowest byte of all numbers, then the next byte of all, and so on. So bytes that
/// hardly change lie together, which helps zstd.
template <std::unsigned_integral Word>
void append_planes(std::span<const Word> numbers, size_t planes, std::vector<uint8_t>& bytes) {
  for (size_t plane = 0; plane < planes; ++plane)
    for (const Word number : numbers) bytes.push_back(static_cast<uint8_t>(number >> 8 * plane));
}

/// Reads them again. Needs: as many numbers as were appended, in so many planes.
template <std::unsigned_integral Word>
void read_planes(std::span<const uint8_t> bytes, size_t planes, std::span<Word> numbers) {
  for (size_t i = 0; i < numbers.size(); ++i) {
    Word number = 0;
    for (size_t plane = 0; plane < planes; ++plane)
      number |= static_cast<Word>(Word{bytes[plane * numbers.size() + i]} << 8 * plane);
    numbers[i] = number;
  }
}

/// Appends one bit per flag, the first in the lowest bit; the last byte is filled up with zeros.
inline void append_bits(std::span<const uint8_t> flags, std::vector<uint8_t>& bytes) {
  for (size_t i = 0; i < flags.size(); ++i) {
    if (i % 8 == 0) bytes.push_back(0);
    if (flags[i] != 0) bytes.back() |= static_cast<uint8_t>(1u << i % 8);
  }
}

/// Reads them again. Needs: ceil(flags / 8) bytes.
inline void read_bits(std::span<const uint8_t> bytes, std::span<uint8_t> flags) {
  for (size_t i = 0; i < flags.size(); ++i) flags[i] = bytes[i / 8] >> i % 8 & 1;
}

}  // namespace burnish
