#pragma once

#include <cstdint>
#include <vector>

#include "common/base/types.h"

namespace burnish {

/// Gives equal positions the same index, in order of first appearance; 0 and -0 are equal.
/// Cost: O(1) per position; 8 to 16 bytes per distinct position besides the position itself.
class VertexWelder {
 public:
  /// Appends the distinct positions to `vertices`. Needs: only the welder changes `vertices`.
  explicit VertexWelder(std::vector<Vec3d>& vertices);

  uint32_t index_of(const Vec3d& position);

 private:
  size_t slot_of(const Vec3d& position) const;
  void grow();

  std::vector<Vec3d>& vertices_;
  std::vector<uint32_t> slots_;  // open addressing, a power of two, at most half full
  uint64_t seeds_[3];
};

}  // namespace burnish
