#pragma once

#include <vector>

#include "server/prepare/pages/page_vertices.h"
#include "server/prepare/pages/page_work.h"
#include "server/prepare/pages/shared_vertices.h"

namespace burnish {

/// What replaces one page.
struct Replacement {
  std::vector<Triangle> triangles;  ///< at least one; vertices of the scan, joined
  float error = 0;                  ///< file units: how far the surface has moved, about
};

/// What replaces the pages of a level, in their order.
struct Replacements {
  std::vector<Replacement> of_pages;
  uint64_t clustered_pages = 0;
  uint64_t torn_pages = 0;  ///< that lost triangles with gaps
};

/// How many triangles a level has at most for each of the finer one. Levels would not end without.
inline constexpr double kLevelShrinkMax = 0.75;

/// Replaces each page of a level by about half its triangles. Where collapsing edges does not bring
/// the level down to kLevelShrinkMax, pages that hardly shrink are clustered, and where that is not
/// enough they lose their small triangles.
/// Deterministic: the same bits for any number of threads. Fails: cancelled.
Result<Replacements> replace_pages(const CutLevel& level, const PageVertices& vertices,
                                   std::span<const uint8_t> shared, const PageWork& work);

}  // namespace burnish
