#include "client/pages/known_pages.h"

#include <algorithm>

#include "common/base/check.h"

namespace burnish {

KnownPages::KnownPages(PageHead head) : head_(std::move(head)) {
  blocks_.resize(head_.block_count());
  ranges_.reserve(blocks_.size());
  for (uint32_t block = 0; block < blocks_.size(); ++block)
    ranges_.push_back(head_.pages_of(block));
  level_zero_blocks_ = block_of(head_.level_pages[0] - 1) + 1;
}

uint32_t KnownPages::block_of(PageId page) const {
  const auto after = std::ranges::upper_bound(ranges_, page, {}, &PageRange::begin);
  return static_cast<uint32_t>(after - ranges_.begin()) - 1;
}

const PageEntry* KnownPages::find(PageId page) const {
  const KnownBlock* block = find_block(block_of(page));
  return block == nullptr ? nullptr : &block->directory.entries[page - block->directory.begin];
}

void KnownPages::add(uint32_t index, DirectoryBlock block) {
  BURNISH_CHECK(block.begin == ranges_[index].begin, "a block of another place");
  BURNISH_CHECK(block.entries.size() == ranges_[index].count(), "a block of another size");
  auto known = std::make_unique<KnownBlock>();
  for (const PageId coarser : block.coarser.item)
    known->coarser_blocks.push_back(block_of(coarser));
  std::ranges::sort(known->coarser_blocks);
  const auto doubled = std::ranges::unique(known->coarser_blocks);
  known->coarser_blocks.erase(doubled.begin(), doubled.end());
  known->coarser_blocks.shrink_to_fit();
  for (const PageEntry& entry : block.entries) known->triangles += entry.triangles;
  known->directory = std::move(block);
  if (blocks_[index] == nullptr) ++known_blocks_;
  blocks_[index] = std::move(known);
}

void KnownPages::forget(uint32_t block) {
  if (blocks_[block] == nullptr) return;
  blocks_[block].reset();
  --known_blocks_;
}

}  // namespace burnish
