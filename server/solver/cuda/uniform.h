#pragma once

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <span>

namespace burnish::cuda {

/// Fields of cells are looked through in chunks of so many.
inline constexpr int64_t kChunk = 1024;
inline constexpr int64_t kParallelMin = 256;  ///< chunks; of fewer one thread is done before others
                                              ///< wake

template <typename T>
std::span<const T> chunk_of(std::span<const T> field, int64_t chunk) {
  const std::span<const T> rest = field.subspan(chunk * kChunk);
  return rest.first(std::min(rest.size(), size_t{kChunk}));
}

/// Needs: not empty.
inline bool all_are(std::span<const float> field, float one) {
  return field.front() == one &&
         std::memcmp(&field[0], &field[0] + 1, field.size_bytes() - sizeof(float)) == 0;
}

/// Whether all cells have the same number. Mostly the first chunk says that they have not.
inline bool is_uniform(std::span<const float> field) {
  if (field.empty()) return true;
  const float one = field.front();
  if (!all_are(chunk_of(field, 0), one)) return false;
  const auto chunks = (static_cast<int64_t>(field.size()) + kChunk - 1) / kChunk;
  bool same = true;
#pragma omp parallel for schedule(static) reduction(&& : same)
  for (int64_t chunk = 1; chunk < chunks; ++chunk)
    same = same && all_are(chunk_of(field, chunk), one);
  return same;
}

}  // namespace burnish::cuda
