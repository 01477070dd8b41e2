#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "common/base/resize_touched.h"

namespace burnish {

/// Returns the numbers below `count` that are taken, rising, for any number of threads. Calls
/// is_taken(number) twice for each, from several threads.
template <typename IsTaken>
std::vector<int32_t> select_numbers(int32_t count, const IsTaken& is_taken) {
  constexpr int32_t kPiece = 1 << 14;
  const int32_t pieces = count / kPiece + 1;
  const auto for_each_taken = [&](int32_t piece, auto&& visit) {
    const int32_t end = piece + 1 < pieces ? (piece + 1) * kPiece : count;
    for (int32_t i = piece * kPiece; i < end; ++i)
      if (is_taken(i)) visit(i);
  };
  std::vector<int32_t> start(pieces + 1, 0);
#pragma omp parallel for schedule(static) if (pieces > 1)
  for (int32_t piece = 0; piece < pieces; ++piece)
    for_each_taken(piece, [&](int32_t) { ++start[piece + 1]; });
  for (int32_t piece = 0; piece < pieces; ++piece) start[piece + 1] += start[piece];
  std::vector<int32_t> taken(start[pieces]);
#pragma omp parallel for schedule(static) if (pieces > 1)
  for (int32_t piece = 0; piece < pieces; ++piece) {
    int32_t* next = taken.data() + start[piece];
    for_each_taken(piece, [&](int32_t i) { *next++ = i; });
  }
  return taken;
}

/// Returns the values at these places, in their order.
template <typename T>
std::vector<T> gather(std::span<const T> values, std::span<const int32_t> places) {
  std::vector<T> gathered;
  resize_touched(gathered, places.size());
#pragma omp parallel for schedule(static)
  for (size_t i = 0; i < places.size(); ++i) gathered[i] = values[places[i]];
  return gathered;
}

}  // namespace burnish
