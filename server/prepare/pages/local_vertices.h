#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "common/base/limits.h"

namespace burnish {

/// Numbers the vertices of one page in the order in which they come. Has no memory of its own to
/// allocate, so that it can stand on the stack of any thread.
class LocalVertices {
 public:
  static constexpr uint32_t kFull = 0xffffffff;

  LocalVertices() { slots_.fill(kEmpty); }

  /// Returns the number of a vertex, or kFull for one vertex more than a page can have.
  uint32_t add(uint32_t vertex) {
    uint32_t slot = (vertex * 0x9e3779b1u) >> (32 - kSlotBits);
    while (slots_[slot] != kEmpty) {
      if (vertices_[slots_[slot]] == vertex) return slots_[slot];
      slot = (slot + 1) % kSlots;
    }
    if (count_ == kPageVerticesMax) return kFull;
    vertices_[count_] = vertex;
    used_slots_[count_] = static_cast<uint16_t>(slot);
    slots_[slot] = static_cast<uint16_t>(count_);
    return count_++;
  }

  /// The vertices by number.
  std::span<const uint32_t> all() const { return {vertices_.data(), count_}; }

  void clear() {
    for (uint32_t i = 0; i < count_; ++i) slots_[used_slots_[i]] = kEmpty;
    count_ = 0;
  }

 private:
  static constexpr int kSlotBits = 12;
  static constexpr uint32_t kSlots = 1u << kSlotBits;
  static constexpr uint16_t kEmpty = 0xffff;
  static_assert(kSlots >= 2 * kPageVerticesMax);

  std::array<uint16_t, kSlots> slots_;
  std::array<uint32_t, kPageVerticesMax> vertices_;
  std::array<uint16_t, kPageVerticesMax> used_slots_;
  uint32_t count_ = 0;
};

}  // namespace burnish
