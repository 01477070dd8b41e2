#pragma once

#include <algorithm>
#include <span>

#include "common/base/types.h"
#include "common/mesh/rewrite/moved/seam_wish.h"
#include "common/mesh/textures/texel_change.h"

namespace burnish {

/// The colours of a mesh's vertices before and after edits.
struct ColourEdit {
  std::span<const Rgba8> before;
  std::span<const Rgba8> after;
  std::span<const TexelChange> texels = {};  ///< one per vertex; empty: as between the colours
  SeamWish seams = {};                       ///< of pictures, before all else

  bool is_there() const {
    return before.size() == after.size() &&
           (seams.is_on() || !std::ranges::equal(before, after) ||
            std::ranges::any_of(texels, [](const TexelChange& texel) { return !texel.is_none(); }));
  }
  bool changes(uint32_t vertex) const {
    return before[vertex] != after[vertex] || (!texels.empty() && !texels[vertex].is_none());
  }
  bool changes(const Triangle& triangle) const {
    return std::ranges::any_of(triangle, [&](uint32_t v) { return changes(v); });
  }
  TexelChange texel(uint32_t vertex) const {
    return texels.empty() ? texel_change(before[vertex], after[vertex]) : texels[vertex];
  }
};

}  // namespace burnish
