#pragma once

#include <concepts>

namespace burnish {

/// Codes a difference so that small ones of both signs become small: 0, -1, 1, -2 become 0, 1, 2,
/// 3. All is modulo 2^bits.
template <std::unsigned_integral Word>
constexpr Word to_zigzag(Word difference) {
  const Word sign = difference >> (8 * sizeof(Word) - 1) ? static_cast<Word>(~Word{0}) : Word{0};
  return static_cast<Word>(static_cast<Word>(difference << 1) ^ sign);
}

template <std::unsigned_integral Word>
constexpr Word from_zigzag(Word coded) {
  return static_cast<Word>((coded >> 1) ^ (coded & 1 ? static_cast<Word>(~Word{0}) : Word{0}));
}

}  // namespace burnish
