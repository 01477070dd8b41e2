#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "common/base/heard_loop.h"

namespace burnish {

/// Orders values by one digit of their keys. Values of one digit keep their order. Throws:
/// WorkCancelled.
template <typename T, typename Key>
void order_by_digit(std::span<const T> from, const Key& key, int shift, int bits, std::span<T> to,
                    const LoopPart& part) {
  constexpr size_t kChunks = 16;  // one chunk per thread
  const size_t digits = size_t{1} << bits;
  const auto digit_of = [&](const T& value) { return key(value) >> shift & (digits - 1); };
  const auto chunk_start = [&](size_t chunk) { return from.size() * chunk / kChunks; };
  LoopProgress loop(part.progress, part.phase, part.begin, part.end);
  // A chunk's values in their order, as far as nobody cancels.
  const auto visit_chunk = [&](size_t chunk, const auto& visit) {
    const size_t end = chunk_start(chunk + 1);
    for (size_t block = chunk_start(chunk); block < end && loop.goes_on(0); block += kHeardBlock)
      for (size_t i = block; i < std::min(block + kHeardBlock, end); ++i) visit(from[i]);
  };
  ask_before(loop);
  std::vector<size_t> next(kChunks * digits, 0);  // by chunk, then digit
#pragma omp parallel for schedule(static)
  for (size_t chunk = 0; chunk < kChunks; ++chunk)
    visit_chunk(chunk, [&](const T& value) { ++next[chunk * digits + digit_of(value)]; });
  leave_if_cancelled(loop);
  size_t before = 0;
  for (size_t digit = 0; digit < digits; ++digit)
    for (size_t chunk = 0; chunk < kChunks; ++chunk)
      before += std::exchange(next[chunk * digits + digit], before);
#pragma omp parallel for schedule(static)
  for (size_t chunk = 0; chunk < kChunks; ++chunk)
    visit_chunk(chunk,
                [&](const T& value) { to[next[chunk * digits + digit_of(value)]++] = value; });
  leave_if_cancelled(loop);
}

/// Sorts by unsigned keys. Values of one key keep their order. Looks only at the bits in which keys
/// differ. Shapes: `spare` is as long as `values` and is overwritten. Throws: WorkCancelled; then
/// the values are no longer all there.
template <typename T, typename Key>
void radix_sort(std::span<T> values, std::span<T> spare, const Key& key,
                const LoopPart& part = kUnheardLoop) {
  constexpr int kDigitBits = 11;
  if (values.empty()) return;
  uint64_t differing = 0;
  for (const T& value : values) differing |= uint64_t{key(value)} ^ uint64_t { key(values[0]) };
  std::span<T> from = values, to = spare;
  for (int shift = 0; shift < 64 && differing >> shift != 0; shift += kDigitBits) {
    order_by_digit(std::span<const T>(from), key, shift, kDigitBits, to, part);
    std::swap(from, to);
  }
  if (from.data() != values.data()) std::copy(from.begin(), from.end(), values.begin());
}

}  // namespace burnish
