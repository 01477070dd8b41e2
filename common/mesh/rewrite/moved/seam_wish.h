#pragma once

#include <span>

namespace burnish {

/// How much of the steps at the seams of a scan's pictures goes (level_seams.h).
struct SeamWish {
  double amount = 0;                 ///< 0 to 1
  std::span<const float> free = {};  ///< per vertex, 0 to 1: how much of it may change; empty: all

  bool is_on() const { return amount > 0; }
};

}  // namespace burnish
