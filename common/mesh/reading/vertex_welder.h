#pragma once

#include <bit>
#include <cstdint>
#include <random>

#include "common/base/scratch_array.h"
#include "common/base/types.h"

namespace burnish {

/// Gives equal positions the same index, in order of first appearance; 0 and -0 are equal.
/// Cost: O(1) per position; 8 to 16 bytes of scratch space per distinct position besides the
/// position itself. `Positions` is a vector of Vec3d.
template <typename Positions>
class VertexWelder {
 public:
  /// Appends the distinct positions to `vertices`. Needs: only the welder changes `vertices`.
  explicit VertexWelder(Positions& vertices, ScratchSpace space = {})
      : vertices_(vertices), space_(std::move(space)), slots_(space_, kSlotsAtFirst) {
    // With secret seeds a hostile file cannot aim at one slot. The result does not depend on them.
    std::random_device random;
    for (uint64_t& seed : seeds_) seed = (uint64_t{random()} << 32) | random();
  }

  uint32_t index_of(const Vec3d& given) {
    const Vec3d position = given + Vec3d::Zero();  // turns -0 into 0
    const size_t slot = slot_of(position);
    if (slots_[slot] != kEmpty) return slots_[slot] - 1;
    const auto index = static_cast<uint32_t>(vertices_.size());
    slots_[slot] = index + 1;
    vertices_.push_back(position);
    if (2 * vertices_.size() > slots_.size()) grow();
    return index;
  }

 private:
  static constexpr uint32_t kEmpty = 0;  // else an index and one
  static constexpr size_t kSlotsAtFirst = 1024;

  /// Returns the two halves of the full product, folded: every bit of both factors reaches the
  /// result.
  static uint64_t folded_product(uint64_t a, uint64_t b) {
    const auto product = static_cast<unsigned __int128>(a) * b;
    return static_cast<uint64_t>(product) ^ static_cast<uint64_t>(product >> 64);
  }

  size_t slot_of(const Vec3d& position) const {
    const auto bits = [&](int axis) { return std::bit_cast<uint64_t>(position[axis]); };
    const uint64_t xy = folded_product(bits(0) ^ seeds_[0], bits(1) ^ seeds_[1]);
    const uint64_t hash = folded_product(xy ^ seeds_[2], bits(2) ^ seeds_[0]);
    const size_t mask = slots_.size() - 1;
    size_t slot = hash & mask;
    while (slots_[slot] != kEmpty && vertices_[slots_[slot] - 1] != position)
      slot = (slot + 1) & mask;
    return slot;
  }

  void grow() {
    slots_ = ScratchArray<uint32_t>(space_, 2 * slots_.size());
    for (uint32_t v = 0; v < vertices_.size(); ++v) slots_[slot_of(vertices_[v])] = v + 1;
  }

  Positions& vertices_;
  ScratchSpace space_;
  ScratchArray<uint32_t> slots_;  // open addressing, a power of two, at most half full
  uint64_t seeds_[3];
};

}  // namespace burnish
