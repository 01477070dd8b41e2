#pragma once

#include <bit>
#include <cstdint>

#include "common/grid/stencil_slots.h"

// An entry of a matrix and the place of its column in the tile of its group of rows, in one word.
// Products read half of the bytes of a float and an index. The number keeps 14 significant bits and
// the whole range of exponents, so rows need no scaling.

#ifdef __CUDACC__
#define BURNISH_ON_BOTH __host__ __device__
#else
#define BURNISH_ON_BOTH
#endif

namespace burnish::cuda {

/// Limit of the packed entries of a row: all entries, except of irregular rows.
inline constexpr int kEntriesMax = kSlots - 1;

inline constexpr int kLocalBits = 10;
inline constexpr int kTile = 1 << kLocalBits;

#ifdef __CUDACC__
/// Returns the nearest number that fits, with its column.
__device__ inline uint32_t pack(float value, uint32_t local) {
  const uint32_t half = 1u << (kLocalBits - 1);
  return ((__float_as_uint(value) + half) & ~(kTile - 1u)) | local;
}
#endif
BURNISH_ON_BOTH inline float value_of(uint32_t packed) {
  return std::bit_cast<float>(packed & ~(kTile - 1u));
}
BURNISH_ON_BOTH inline uint32_t local_of(uint32_t packed) {
  return packed & (kTile - 1u);
}

/// A fine corner that a coarse corner gathers, and its weight 1, 1/2, 1/4 or 1/8 as a number of
/// halvings. A coarse corner has at most this many.
inline constexpr int kRestrictionMax = kSlots;
inline constexpr int kCornerBits = 30;
BURNISH_ON_BOTH inline uint32_t pack_restriction(int32_t corner, uint32_t halvings) {
  return halvings << kCornerBits | static_cast<uint32_t>(corner);
}
BURNISH_ON_BOTH inline int32_t corner_of(uint32_t restriction) {
  return static_cast<int32_t>(restriction & ((1u << kCornerBits) - 1));
}
BURNISH_ON_BOTH inline float weight_of(uint32_t restriction) {
  constexpr uint32_t kBiasOfExponent = 127;
  return std::bit_cast<float>((kBiasOfExponent - (restriction >> kCornerBits)) << 23);
}

}  // namespace burnish::cuda
