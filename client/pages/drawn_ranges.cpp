#include "client/pages/drawn_ranges.h"

#include "common/base/check.h"

namespace burnish {

static void add_page(PageId id, const CachedPage& cached, const PageSet& set,
                     std::vector<DrawnRange>& ranges) {
  DrawnRange range = {cached.slot, 0, 0, id};
  for (const PagePatch& patch : cached.page->patches) {
    if (is_drawn(patch, set)) {
      range.triangles += patch.triangles;
      continue;
    }
    if (range.triangles > 0) ranges.push_back(range);
    range.first_triangle += range.triangles + patch.triangles;
    range.triangles = 0;
  }
  if (range.triangles > 0) ranges.push_back(range);
}

std::vector<DrawnRange> drawn_ranges(const ChosenCut& cut, const PageCache& cache) {
  std::vector<DrawnRange> ranges;
  for (const PageId page : cut.visible_pages) {
    const CachedPage* cached = cache.find(page);
    BURNISH_CHECK(cached != nullptr && cached->state == PageState::kOnCard,
                  "a page of the cut left the card");
    add_page(page, *cached, cut.set, ranges);
  }
  return ranges;
}

}  // namespace burnish
