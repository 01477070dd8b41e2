#pragma once

#include <cstdint>
#include <vector>

#include "client/pages/chosen_cut.h"
#include "client/pages/page_cache.h"

namespace burnish {

/// Triangles of one slot that follow each other and are drawn.
struct DrawnRange {
  PageSlot slot = 0;
  uint32_t first_triangle = 0;
  uint32_t triangles = 0;
  PageId page = 0;
  bool operator==(const DrawnRange&) const = default;
};

/// Lists what a picture of the cut draws, page by page, neighbouring patches as one range.
/// Needs: every page of the cut is on the card.
std::vector<DrawnRange> drawn_ranges(const ChosenCut& cut, const PageCache& cache);

}  // namespace burnish
