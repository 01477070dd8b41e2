#pragma once

#include <vector>

#include "common/base/scratch_vector.h"
#include "server/prepare/pages/page_vertices.h"
#include "server/prepare/pages/page_work.h"
#include "server/prepare/pages/shared_vertices.h"

namespace burnish {

/// The replacement of one page.
struct Replacement {
  uint64_t first = 0;  ///< in Replacements::triangles
  uint64_t count = 0;  ///< at least one
  float error = 0;     ///< file units: how far the surface has moved, about
};

/// The replacements of a level's pages, in their order.
struct Replacements {
  explicit Replacements(const ScratchSpace& space) : triangles(space) {}

  std::span<const Triangle> of(size_t page) const {
    return {&triangles[0] + of_pages[page].first, of_pages[page].count};
  }

  std::vector<Replacement> of_pages;
  ScratchVector<Triangle> triangles;  ///< vertices of the scan, joined; some are replaced again
  uint64_t clustered_pages = 0;
  uint64_t torn_pages = 0;  ///< that lost triangles with gaps
};

/// How many triangles a level has at most for each of the finer one. Levels would not end without.
inline constexpr double kLevelShrinkMax = 0.75;

/// Replaces each page of a level by its own triangles, so that fuller pages follow.
/// Deterministic: the same bits for any number of threads. Fails: cancelled.
Result<Replacements> keep_pages(const CutLevel& level, const PageVertices& vertices,
                                std::span<const uint8_t> shared, const ScratchSpace& space,
                                const PageWork& work);

/// Replaces each page of a level by about half its triangles. Where collapsing edges does not bring
/// the level down to kLevelShrinkMax, pages that hardly shrink are clustered, and where that is not
/// enough they lose their small triangles.
/// Deterministic: the same bits for any number of threads. Fails: cancelled.
Result<Replacements> replace_pages(const CutLevel& level, const PageVertices& vertices,
                                   std::span<const uint8_t> shared, const ScratchSpace& space,
                                   const PageWork& work);

}  // namespace burnish
