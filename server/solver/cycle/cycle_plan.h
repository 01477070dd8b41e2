#pragma once

#include <limits>

#include "server/solver/hierarchy/patches.h"

namespace burnish {

/// Describes what the V-cycle over one hierarchy does beyond one correction per depth. It changes
/// how fast a solve converges, but not its limit.
struct CyclePlan {
  /// From this depth on, and not only around patches, parts of the surface move with too little
  /// energy for the 14 bits of S.
  int first_weak_depth = std::numeric_limits<int>::max();
  Patches patches;              ///< at the finest depth
  bool has_flat_parts = false;  ///< some moves of flat pieces take no energy at all

  bool has_weak_parts(int depth) const { return depth >= first_weak_depth; }

  /// Returns whether rounded entries of S would give some moves a wrong energy.
  bool needs_all_digits(int depth) const { return has_flat_parts || has_weak_parts(depth); }
};

}  // namespace burnish
