#pragma once

#include <limits>

#include "server/solver/cycle/patches.h"

namespace burnish {

/// What the V-cycle over one hierarchy does beyond one correction a depth. It changes how fast a
/// solve converges, never what it converges to.
struct CyclePlan {
  /// From this depth on, parts of the surface move with so little energy that 14 bits of S hide it,
  /// and not only around patches.
  int first_weak_depth = std::numeric_limits<int>::max();
  Patches patches;  ///< of the finest depth

  bool has_weak_parts(int depth) const { return depth >= first_weak_depth; }
};

}  // namespace burnish
