#include "client/pages/page_demand.h"

#include <algorithm>
#include <limits>

#include "common/base/heap_sort.h"

namespace burnish {

static constexpr float kInfinite = std::numeric_limits<float>::infinity();

void DemandFinder::Wish::raise(const Wish& other) {
  excess = std::max(excess, other.excess);
  is_seen = is_seen || other.is_seen;
}

DemandFinder::DemandFinder(const KnownPages& known)
    : known_(known),
      page_wishes_(known.head().page_count()),
      block_wishes_(known.block_count()),
      visits_(known.block_count()) {}

const PageDemand& DemandFinder::find(const PageView& view, const FrameBounds& frame,
                                     const CutTargets& targets, const PageSet& was_shown) {
  demand_.pages.clear();
  demand_.blocks.clear();
  std::ranges::fill(block_wishes_, Wish{});
  std::ranges::fill(visits_, Visit::kNone);
  block_wishes_.back().excess = kInfinite;  // the root is always wanted
  const Picture picture = {view, frame, targets, was_shown};
  for (uint32_t block = 0; block < known_.block_count(); ++block) visit(picture, block);
  order_blocks();
  return demand_;
}

void DemandFinder::visit(const Picture& picture, uint32_t block) {
  const CutTargets& targets = picture.targets;
  const bool is_known = known_.find_block(block) != nullptr;
  Wish wish = block_wishes_[block];
  const Wish own = own_wish(picture, known_.head().blocks[block].bounds,
                            is_known ? targets.keep : targets.take, wish.excess > 0);
  if (std::max(own.excess, wish.excess) == 0) return;
  if (is_known) return visit_known(picture, block);
  wish.raise(own);
  demand_.blocks.push_back({block, wish.excess, wish.is_seen});
}

// Returns no wish for what is not wanted above this excess, nor needed by others.
DemandFinder::Wish DemandFinder::own_wish(const Picture& picture, const PageBounds& bounds,
                                          float wanted_above, bool is_needed) {
  const float excess = excess_of(bounds, picture.view, picture.frame, picture.targets);
  if (excess <= wanted_above && !is_needed) return {};
  const bool is_seen = is_visible(picture.view, bounds, picture.frame.largest_move);
  const Wish own = {is_seen ? excess : excess * kUnseenWeight, is_seen};
  return own.excess <= wanted_above && !is_needed ? Wish() : own;
}

void DemandFinder::visit_known(const Picture& picture, uint32_t block) {
  const KnownBlock& known = *known_.find_block(block);
  begin_wishes(block);
  visits_[block] = Visit::kDone;
  for (const uint32_t coarser : known.coarser_blocks) begin_wishes(coarser);
  Wish largest;
  for (uint32_t i = 0; i < known.directory.entries.size(); ++i) {
    const PageId page = known.directory.begin + i;
    const PageEntry& entry = known.directory.entries[i];
    const Wish wish = page_wish(picture, page, entry.bounds);
    if (wish.excess == 0) continue;
    const auto coarser_pages = known.directory.coarser[i];
    demand_.pages.push_back({page, wish.excess, wish.is_seen, &entry, coarser_pages});
    for (const PageId coarser : coarser_pages) page_wishes_[coarser].raise(wish);
    largest.raise(wish);
  }
  for (const uint32_t coarser : known.coarser_blocks) block_wishes_[coarser].raise(largest);
}

DemandFinder::Wish DemandFinder::page_wish(const Picture& picture, PageId page,
                                           const PageBounds& bounds) const {
  const CutTargets& targets = picture.targets;
  const bool may_stay = targets.keep < targets.take && picture.was_shown[page] != 0;
  Wish wish = page_wishes_[page];
  if (page == known_.head().root()) wish.excess = kInfinite;
  Wish own = own_wish(picture, bounds, may_stay ? targets.keep : targets.take, wish.excess > 0);
  if (may_stay) own.excess /= kHysteresis;
  wish.raise(own);
  return wish;
}

void DemandFinder::begin_wishes(uint32_t block) {
  if (visits_[block] != Visit::kNone) return;
  visits_[block] = Visit::kBegun;
  const PageRange pages = known_.pages_of(block);
  std::fill(page_wishes_.begin() + pages.begin, page_wishes_.begin() + pages.end, Wish{});
}

// Pages of a block can be used only with coarser ones, so coarse blocks come first.
void DemandFinder::order_blocks() {
  float finer = 0;
  float level = 0;
  PageId level_end = 0;
  for (WantedBlock& wanted : demand_.blocks) {
    const PageId begin = known_.pages_of(wanted.block).begin;
    if (begin >= level_end) {
      finer = std::max(finer, level);
      level_end = known_.head().level_begin(known_.head().level_of(begin) + 1);
    }
    wanted.excess = std::max(wanted.excess, finer);
    level = std::max(level, wanted.excess);
  }
  heap_sort(demand_.blocks, [](const WantedBlock& one, const WantedBlock& other) {
    return one.excess != other.excess ? one.excess > other.excess : one.block > other.block;
  });
}

}  // namespace burnish
