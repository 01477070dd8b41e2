#include "client/pages/page_demand.h"

#include <algorithm>
#include <limits>

namespace burnish {

static constexpr float kInfinite = std::numeric_limits<float>::infinity();
static constexpr float kBarelyWanted = 1 + std::numeric_limits<float>::epsilon();

void DemandFinder::Wish::raise(const Wish& other) {
  excess = std::max(excess, other.excess);
  is_seen = is_seen || other.is_seen;
}

DemandFinder::DemandFinder(const KnownPages& known)
    : known_(known),
      page_wishes_(known.head().page_count()),
      block_wishes_(known.block_count()),
      is_begun_(known.block_count()) {}

const PageDemand& DemandFinder::find(const PageView& view, const FrameBounds& frame,
                                     const CutTargets& targets, const PageSet& was_used) {
  demand_.pages.clear();
  demand_.blocks.clear();
  std::ranges::fill(block_wishes_, Wish{});
  std::ranges::fill(is_begun_, uint8_t{0});
  block_wishes_.back().excess = kInfinite;  // the root is always wanted
  const Picture picture = {view, frame, targets, was_used};
  for (uint32_t block = 0; block < known_.block_count(); ++block) visit(picture, block);
  order_blocks();
  return demand_;
}

void DemandFinder::visit(const Picture& picture, uint32_t block) {
  const PageBounds& bounds = known_.head().blocks[block].bounds;
  const float excess = excess_of(bounds, picture.view, picture.frame, picture.targets);
  if (excess <= picture.targets.keep && block_wishes_[block].excess == 0) return;
  if (known_.find_block(block) == nullptr)
    visit_unknown(picture, block, excess);
  else
    visit_known(picture, block);
}

void DemandFinder::visit_unknown(const Picture& picture, uint32_t block, float excess) {
  const PageBounds& bounds = known_.head().blocks[block].bounds;
  Wish wish;
  wish.is_seen = is_visible(picture.view, bounds, picture.frame.largest_move);
  wish.excess = wish.is_seen ? excess : excess * kUnseenWeight;
  wish.raise(block_wishes_[block]);
  if (wish.excess > 1) demand_.blocks.push_back({block, wish.excess, wish.is_seen});
}

void DemandFinder::visit_known(const Picture& picture, uint32_t block) {
  const KnownBlock& known = *known_.find_block(block);
  begin_wishes(block);
  for (const uint32_t coarser : known.coarser_blocks) begin_wishes(coarser);
  Wish largest;
  for (uint32_t i = 0; i < known.directory.entries.size(); ++i) {
    const PageId page = known.directory.begin + i;
    const PageEntry& entry = known.directory.entries[i];
    const Wish wish = wish_for(picture, page, entry.bounds);
    if (wish.excess <= 1) continue;
    const auto coarser_pages = known.directory.coarser[i];
    demand_.pages.push_back({page, wish.excess, wish.is_seen, &entry, coarser_pages});
    for (const PageId coarser : coarser_pages) page_wishes_[coarser].raise(wish);
    largest.raise(wish);
  }
  for (const uint32_t coarser : known.coarser_blocks) block_wishes_[coarser].raise(largest);
}

DemandFinder::Wish DemandFinder::wish_for(const Picture& picture, PageId page,
                                          const PageBounds& bounds) const {
  const CutTargets& targets = picture.targets;
  Wish wish = page_wishes_[page];
  float own = excess_of(bounds, picture.view, picture.frame, targets);
  if (page == known_.head().root()) own = kInfinite;
  if (targets.keep < 1 && own > targets.keep && picture.was_used[page] != 0)
    own = std::max(own / kKeep, kBarelyWanted);
  if (std::max(own, wish.excess) <= 1) return wish;
  const bool is_seen = is_visible(picture.view, bounds, picture.frame.largest_move);
  wish.raise({is_seen ? own : own * kUnseenWeight, is_seen});
  return wish;
}

void DemandFinder::begin_wishes(uint32_t block) {
  if (is_begun_[block] != 0) return;
  is_begun_[block] = 1;
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
  std::ranges::sort(demand_.blocks, [](const WantedBlock& one, const WantedBlock& other) {
    return one.excess != other.excess ? one.excess > other.excess : one.block > other.block;
  });
}

}  // namespace burnish
