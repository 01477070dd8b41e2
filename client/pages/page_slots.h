#pragma once

#include <cstdint>
#include <optional>
#include <vector>

namespace burnish {

using PageSlot = uint32_t;

/// Hands out the slots of the arenas on the card: equal places for kPageVerticesMax vertices and
/// kPageTrianglesMax triangles. Gives the lowest free one, so that arenas grow with need.
class PageSlots {
 public:
  explicit PageSlots(uint64_t count) : count_(count) {}

  /// Returns nothing when all are taken.
  std::optional<PageSlot> take();
  /// Needs: a slot that is taken.
  void give_back(PageSlot slot);

  uint64_t count() const { return count_; }
  uint64_t taken() const { return begun_ - free_.size(); }
  /// All slots ever taken are below it: how large the arenas must be.
  uint64_t begun() const { return begun_; }

 private:
  uint64_t count_;
  uint64_t begun_ = 0;
  std::vector<PageSlot> free_;  // a heap, the lowest first; all below begun_
};

}  // namespace burnish
