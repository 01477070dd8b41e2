#pragma once

#include <algorithm>
#include <span>

#include "common/base/types.h"

namespace burnish {

/// The colours of a mesh's vertices before and after edits.
struct ColourEdit {
  std::span<const Rgba8> before;
  std::span<const Rgba8> after;

  bool is_there() const {
    return before.size() == after.size() && !std::ranges::equal(before, after);
  }
  bool changes(uint32_t vertex) const { return before[vertex] != after[vertex]; }
  bool changes(const Triangle& triangle) const {
    return std::ranges::any_of(triangle, [&](uint32_t v) { return changes(v); });
  }
};

}  // namespace burnish
