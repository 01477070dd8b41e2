#pragma once

#include <cstdint>

#include "common/base/types.h"

namespace burnish {

/// Bits of i, j, k interleaved, i lowest: 3·13 bits hold corners 0..4096 of the deepest grid.
/// The order keeps the eight children of a cell together and in corner order.
using MortonKey = uint64_t;

namespace morton_detail {

inline uint64_t spread(uint64_t x) {
  x &= 0x1fffff;
  x = (x | x << 32) & 0x1f00000000ffff;
  x = (x | x << 16) & 0x1f0000ff0000ff;
  x = (x | x << 8) & 0x100f00f00f00f00f;
  x = (x | x << 4) & 0x10c30c30c30c30c3;
  x = (x | x << 2) & 0x1249249249249249;
  return x;
}

inline uint64_t gather(uint64_t x) {
  x &= 0x1249249249249249;
  x = (x ^ x >> 2) & 0x10c30c30c30c30c3;
  x = (x ^ x >> 4) & 0x100f00f00f00f00f;
  x = (x ^ x >> 8) & 0x1f0000ff0000ff;
  x = (x ^ x >> 16) & 0x1f00000000ffff;
  x = (x ^ x >> 32) & 0x1fffff;
  return x;
}

}  // namespace morton_detail

/// Needs: coordinates in [0, 2^21).
inline MortonKey morton_key(const Vec3i& p) {
  using morton_detail::spread;
  return spread(static_cast<uint64_t>(p.x())) | spread(static_cast<uint64_t>(p.y())) << 1 |
         spread(static_cast<uint64_t>(p.z())) << 2;
}

inline Vec3i morton_point(MortonKey key) {
  using morton_detail::gather;
  return {static_cast<int>(gather(key)), static_cast<int>(gather(key >> 1)),
          static_cast<int>(gather(key >> 2))};
}

}  // namespace burnish
