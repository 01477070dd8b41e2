#pragma once

#include <algorithm>
#include <cstdint>
#include <span>

namespace burnish::cuda {

/// Fields of cells are searched in chunks of this many.
inline constexpr int64_t kChunk = 1024;
inline constexpr int64_t kParallelMin = 256;  ///< chunks; fewer end before other threads wake

template <typename T>
std::span<const T> chunk_of(std::span<const T> field, int64_t chunk) {
  const std::span<const T> rest = field.subspan(chunk * kChunk);
  return rest.first(std::min(rest.size(), size_t{kChunk}));
}

}  // namespace burnish::cuda
