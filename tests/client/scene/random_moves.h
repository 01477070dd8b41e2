#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "common/base/types.h"

namespace burnish {

/// Returns a displacement that looks random. It depends on the seed and the lattice point alone, so
/// that pages agree about it. Units: each axis within -1 to 1.
inline Vec3f random_move(const Vec3i& lattice, uint32_t seed) {
  uint64_t state = seed;
  for (const int place : lattice) state = (state ^ uint32_t(place)) * 0x9e3779b97f4a7c15u;
  Vec3f move;
  for (float& part : move) {
    state ^= state >> 29;
    state *= 0xbf58476d1ce4e5b9u;
    part = static_cast<float>(state >> 40) / (1 << 23) - 1;
  }
  return move;
}

inline std::vector<Vec3f> random_moves(std::span<const Vec3i> lattice, uint32_t seed) {
  std::vector<Vec3f> moves;
  for (const Vec3i& point : lattice) moves.push_back(random_move(point, seed));
  return moves;
}

}  // namespace burnish
